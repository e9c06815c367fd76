#include "sim/console/choice.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

const std::vector<std::string> kWays{"mouse", "paper", "device"};

TEST(ChoiceOf, AWordABeginningOrANumberAmongOtherWords) {
  for (const char* line : {"2", "2.", "two", "paper", "Paper please.", "the second", "swell paper",
                           "the second one", "pa", "number 2", "2 paper"}) {
    EXPECT_EQ(ChoiceOf(line, kWays), 1U) << line;
  }
  EXPECT_EQ(ChoiceOf("one", kWays), 0U);
  EXPECT_EQ(ChoiceOf("the mouse, I think", kWays), 0U);
  EXPECT_EQ(ChoiceOf("third", kWays), 2U);
}

TEST(ChoiceOf, NoneWhereNoneOrSeveralAreNamed) {
  for (const char* line :
       {"", "p", "4", "four", "12", "yes", "paperclip", "paper or mouse", "1 or 2", "?"}) {
    EXPECT_EQ(ChoiceOf(line, kWays), std::nullopt) << line;
  }
}

}  // namespace
}  // namespace moontrace
