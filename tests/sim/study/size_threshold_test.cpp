#include "sim/study/size_threshold.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/study/learner_model.h"
#include "sim/trial/trial.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

const std::vector<std::string> kItems{"i", "o", "l"};

StaircaseRule Sizes(int trials) {
  StaircaseRule rule;
  rule.start = 0.03;
  rule.least = 0.001;
  rule.most = 0.04;
  rule.steps = {2, 1.4};
  rule.discard = 1;
  rule.stop_trials = trials;
  return rule;
}

/// A learner that has felt each item large, twice, and was told what it was.
SimulatedLearner Taught(const Script& script) {
  SimulatedLearner learner(ShippedLearner(), ShippedHand(), 3);
  for (int time = 0; time < 2; ++time) {
    for (const std::string& item : kItems) {
      learner.shapes().Remember(item, learner.Feel(SetItem(item, script, 0.03)), learner.day());
    }
  }
  return learner;
}

TEST(SlowSizeThreshold, OfALearnerThatKnowsItsLettersLiesBetweenLargeAndTooSmallToFeel) {
  const Script script = FindScript("moon");
  SimulatedLearner learner = Taught(script);
  const SizeThreshold found = FindSizeThreshold(learner, script, kItems, Sizes(40), 2, 5);
  ASSERT_TRUE(found.size.has_value());
  EXPECT_GT(*found.size, 0.001);
  EXPECT_LT(*found.size, 0.03);  // large ones are known
  EXPECT_GT(found.right, 0u);
  EXPECT_LT(found.right, found.trials);
  SimulatedLearner twin = Taught(script);
  EXPECT_EQ(FindSizeThreshold(twin, script, kItems, Sizes(40), 2, 5).size, found.size);
}

TEST(SizeThreshold, OfALearnerThatWasToldNothingThereIsNone) {
  SimulatedLearner learner(ShippedLearner(), ShippedHand(), 3);
  const Script script = FindScript("moon");
  const SizeThreshold found = FindSizeThreshold(learner, script, kItems, Sizes(3), 2, 5);
  EXPECT_FALSE(found.size.has_value());
  EXPECT_EQ(found.trials, 6u);
  EXPECT_EQ(found.right, 0u);
}

TEST(SizeThreshold, RefusesToAskForNothing) {
  SimulatedLearner learner(ShippedLearner(), ShippedHand(), 3);
  const Script script = FindScript("moon");
  EXPECT_THROW(FindSizeThreshold(learner, script, {}, Sizes(3), 1, 5), std::invalid_argument);
  EXPECT_THROW(FindSizeThreshold(learner, script, kItems, Sizes(3), 0, 5), std::invalid_argument);
}

}  // namespace
}  // namespace moontrace
