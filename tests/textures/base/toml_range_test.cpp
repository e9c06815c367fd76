#include "textures/base/toml_range.h"

#include <gtest/gtest.h>

#include <cmath>

#include "textures/base/error.h"

namespace moontrace {
namespace {

TEST(TomlRange, TakesItsEndsAndNamesPlaceAndRangeOfOthers) {
  const TomlTable table = TomlTable::Parse("a = 1\nb = 2.5\n", "f.toml");
  EXPECT_EQ(InRange(table, "b", 2.5, 2.5, 3), 2.5);
  EXPECT_EQ(InRange(table, "b", 2.5, 0, 2.5), 2.5);
  EXPECT_THROW(InRange(table, "b", std::nan(""), 0, 3), InputError);
  try {
    InRange(table, "b", 2.5, 0, 2);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("f.toml:2:", 0), 0U) << error.what();
    EXPECT_NE(std::string(error.what()).find("2.5 is out of range: give 0 to 2"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace moontrace
