#include "lessons/bkt.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

TEST(Mastery, GivesTheReferenceSequence) {
  const std::vector<bool> answers{true, true, false, true, true, true};
  const double expected[] = {0.6000, 0.8903, 0.5781, 0.8814, 0.9753, 0.9952};
  for (std::size_t n = 1; n <= answers.size(); ++n) {
    const std::vector<bool> first(answers.begin(), answers.begin() + static_cast<int>(n));
    EXPECT_NEAR(Mastery(first), expected[n - 1], 5e-5) << n;
  }
}

TEST(Mastery, BeforeAnyAnswerIsThePrior) { EXPECT_EQ(Mastery({}), 0.2); }

TEST(Mastery, WithoutGuessingOneRightAnswerProvesIt) {
  EXPECT_DOUBLE_EQ(Mastery({true}, {0.2, 0.15, 0, 0.1}), 1);
}

TEST(Mastery, AnAnswerThatCannotBeChangesNothing) {
  // Known for sure, no slip, yet wrong.
  EXPECT_DOUBLE_EQ(Mastery({false}, {1, 0, 0, 0}), 1);
}

}  // namespace
}  // namespace moontrace
