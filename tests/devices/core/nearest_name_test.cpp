#include "devices/core/nearest_name.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(NearestName, TakesTheFewestChanges) {
  EXPECT_EQ(NearestName("polehm", {"openffboard", "polhem", "spacemouse"}), "polhem");
  EXPECT_EQ(NearestName("rate", {"rat", "gate", "rate"}), "rate");
}

TEST(NearestName, IsEmptyWhenMoreThanHalfMustChange) {
  EXPECT_EQ(NearestName("abcd", {"wxyz"}), "");
  EXPECT_EQ(NearestName("ab", {"axx"}), "");  // two changes of two bytes
  EXPECT_EQ(NearestName("", {"a"}), "");
}

TEST(NearestName, DoesNotSearchForEndlessWords) {
  EXPECT_EQ(NearestName(std::string(1000000, 'a'), {"a"}), "");
}

}  // namespace
}  // namespace moontrace
