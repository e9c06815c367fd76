#include "textures/base/enum_names.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

enum class Side { kLeft, kRight, kBoth };

constexpr std::string_view NameOf(Side side) {
  switch (side) {
    case Side::kLeft:
      return "left";
    case Side::kRight:
      return "right";
    case Side::kBoth:
      return "both";
  }
  return {};
}

TEST(EnumNames, AreCounted) {
  static_assert(CountNamed(&NameOf) == 3);
  EXPECT_EQ(AllNames(&NameOf), (std::vector<std::string>{"left", "right", "both"}));
}

TEST(EnumNames, LeadBackToTheirValues) {
  EXPECT_EQ(ValueNamed("left", &NameOf), Side::kLeft);
  EXPECT_EQ(ValueNamed("both", &NameOf), Side::kBoth);
  EXPECT_EQ(ValueNamed("neither", &NameOf), std::nullopt);
  EXPECT_EQ(ValueNamed("", &NameOf), std::nullopt);
}

}  // namespace
}  // namespace moontrace
