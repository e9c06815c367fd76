#include "sim/console/wording.h"

#include <gtest/gtest.h>

namespace moontrace::say {
namespace {

TEST(Wording, CountsInWords) {
  EXPECT_EQ(Counted(1, "line", "lines"), "1 line");
  EXPECT_EQ(Counted(0, "line", "lines"), "0 lines");
  EXPECT_EQ(Times(0), "never");
  EXPECT_EQ(Times(1), "once");
  EXPECT_EQ(Times(3), "3 times");
}

TEST(Wording, NearlyAllIsNotAll) {
  EXPECT_EQ(Percent(1), "100 percent");
  EXPECT_EQ(Percent(0.9996).find("100"), std::string::npos) << Percent(0.9996);
}

TEST(Wording, TextOfSeveralLinesStandsWithinASentence) {
  EXPECT_EQ(Unbroken("the moon\nrose\n"), "the moon rose ");
  EXPECT_EQ(Unbroken(""), "");
  EXPECT_EQ(Joined({"a", "b", "c"}, " or "), "a, b or c");
  EXPECT_EQ(Joined({"a"}, " or "), "a");
}

}  // namespace
}  // namespace moontrace::say
