#include "lessons/progress/fsrs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace moontrace {
namespace {

constexpr Rating kA = Rating::kAgain, kH = Rating::kHard, kG = Rating::kGood, kE = Rating::kEasy;

// Expected values of the first three tests: those of py-fsrs 6.3 and cpp-fsrs. The second's were
// worked out in single precision there, and are held to 1e-4.

TEST(Fsrs, GivesTheReferenceIntervals) {
  const std::vector<Rating> ratings{kG, kG, kG, kG, kG, kG, kA, kA, kG, kG, kG, kG, kG};
  const std::vector<double> expected{0, 2, 11, 46, 163, 498, 0, 0, 2, 4, 7, 12, 21};
  Memory memory;
  double interval = 0;
  for (std::size_t i = 0; i < ratings.size(); ++i) {
    memory = Review(memory, ratings[i], interval);
    interval = NextInterval(memory);
    // Short steps are minutes: no whole day.
    EXPECT_EQ(std::floor(interval), expected[i]) << "review " << i;
  }
  EXPECT_NEAR(memory.stability, 20.7704, 5e-5);
  EXPECT_NEAR(memory.difficulty, 9.0558, 5e-5);
}

TEST(Fsrs, GivesTheReferenceMemoryForGivenGaps) {
  const std::vector<Rating> ratings{kA, kG, kG, kG, kG, kG};
  const std::vector<double> gaps{0, 0, 1, 3, 8, 21};
  Memory memory;
  for (std::size_t i = 0; i < ratings.size(); ++i) memory = Review(memory, ratings[i], gaps[i]);
  EXPECT_NEAR(memory.stability, 53.62691, 1e-4);
  EXPECT_NEAR(memory.difficulty, 6.3574867, 1e-4);
}

TEST(Fsrs, ForgetsAlongTheReferenceCurve) {
  const Memory memory{10, 5, 0};
  EXPECT_NEAR(Retrievability(memory, 1), 0.985682, 5e-7);
  EXPECT_NEAR(Retrievability(memory, 5), 0.940344, 5e-7);
  EXPECT_NEAR(Retrievability(memory, 10), 0.9, 1e-12);
  EXPECT_NEAR(Retrievability(memory, 20), 0.845885, 5e-7);
  EXPECT_NEAR(Retrievability(memory, 100), 0.692827, 5e-7);
}

TEST(Fsrs, IsDueWhenRecallHasFallenToTheWantedRetention) {
  const Memory memory{200, 5, 0};
  for (const double retention : {0.8, 0.85, 0.9, 0.95}) {
    // Whole days: half a day changes recall by less than half the slope at once.
    EXPECT_NEAR(Retrievability(memory, NextInterval(memory, retention)), retention, 1e-3);
  }
}

TEST(Fsrs, NewItemsTakeTwoShortStepsAndForgottenOnesOne) {
  const double minute = 1.0 / (24 * 60);
  const Memory again = Review({}, kA, 0);
  EXPECT_DOUBLE_EQ(NextInterval(again), minute);
  const Memory good = Review(again, kG, minute);
  EXPECT_DOUBLE_EQ(NextInterval(good), 10 * minute);
  EXPECT_GE(NextInterval(Review(good, kG, 10 * minute)), 1);
  EXPECT_DOUBLE_EQ(NextInterval(Review({}, kH, 0)), minute);
  EXPECT_EQ(NextInterval(Review({}, kE, 0)), 8);  // its stability is 8.2956 days

  const Memory forgotten = Review({30, 5, 0}, kA, 30);
  EXPECT_DOUBLE_EQ(NextInterval(forgotten), 10 * minute);
  EXPECT_GE(NextInterval(Review(forgotten, kG, 10 * minute)), 1);
  EXPECT_GE(NextInterval(Review({30, 5, 0}, kH, 30)), 1);
}

TEST(Fsrs, BetterRatingsLastLongerAndForgettingNeverHelps) {
  const Memory memory{30, 5, 0};
  for (const double days : {0.01, 1.0, 30.0, 300.0}) {
    EXPECT_LE(Review(memory, kA, days).stability, memory.stability);
    EXPECT_LT(Review(memory, kA, days).stability, Review(memory, kH, days).stability);
    EXPECT_LT(Review(memory, kH, days).stability, Review(memory, kG, days).stability);
    EXPECT_LT(Review(memory, kG, days).stability, Review(memory, kE, days).stability);
  }
}

TEST(Fsrs, StaysWithinItsLimitsWhateverIsAnswered) {
  for (const Rating rating : {kA, kH, kG, kE}) {
    Memory memory;
    for (int i = 0; i < 300; ++i) {
      memory = Review(memory, rating, NextInterval(memory));
      ASSERT_TRUE(std::isfinite(memory.stability));
      ASSERT_GT(memory.stability, 0);
      ASSERT_GE(memory.difficulty, 1);
      ASSERT_LE(memory.difficulty, 10);
      ASSERT_LE(NextInterval(memory), 36500);
    }
  }
}

TEST(Fsrs, KnowsNothingOfWhatWasNeverReviewed) {
  EXPECT_EQ(Retrievability({}, 3), 0);
  EXPECT_EQ(NextInterval({}), 0);
}

TEST(Fsrs, TakesAClockThatWentBackAsNoTime) {
  const Memory memory{10, 5, 0};
  for (const double days : {-3.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(Retrievability(memory, days), 1);
    EXPECT_EQ(Review(memory, kG, days).stability, Review(memory, kG, 0).stability);
  }
}

}  // namespace
}  // namespace moontrace
