#include "sim/study/simulated_learner.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>

#include "devices/catalogue/catalogue.h"
#include "lessons/guide/guidance.h"
#include "lessons/guide/guidance_path.h"
#include "lessons/guide/guidance_table.h"
#include "sim/trial/trial.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

const std::string kLetters = "abcdefghijklmnopqrstuvwxyz";

class LearnerTest : public ::testing::Test {
 protected:
  FeltShape Feel(const std::string& letter, double size, double depth_share = 1) {
    return learner_.Feel(SetItem(letter, script_, size, {1, depth_share}));
  }
  void Teach(const std::string& letters, double size = 0.04) {
    for (const char c : letters) {
      learner_.shapes().Remember(std::string(1, c), Feel(std::string(1, c), size), 0);
    }
  }
  std::string Hear(const std::string& letter, double size, double depth_share = 1) {
    return learner_.shapes().Name(Feel(letter, size, depth_share), 0, learner_.Guess()).label;
  }
  /// Share named right of all letters, each felt `times`.
  double Right(double size, int times, double depth_share = 1) {
    int right = 0;
    for (int i = 0; i < times; ++i) {
      for (const char c : kLetters) {
        const std::string letter(1, c), heard = Hear(letter, size, depth_share);
        if (heard == letter)
          ++right;
        else
          ++confused_[letter + heard];
      }
    }
    return right / (26.0 * times);
  }

  Script script_ = FindScript("moon");
  SimulatedLearner learner_{ShippedLearner(), ShippedHand(), 1};
  std::map<std::string, int> confused_;
};

TEST_F(LearnerTest, HearsWhatLiesThereWhateverItIsCalled) {
  Teach("bdo");
  // A page that is labelled D bears the shape of B: nothing but the page's shape reaches the touch.
  const ItemPage labelled_d = SetItem("b", script_, 0.04);
  EXPECT_EQ(learner_.shapes().Name(learner_.Feel(labelled_d), 0, 0).label, "b");
}

TEST_F(LearnerTest, LearnsTheShapeThatItIsShownAndNotTheName) {
  learner_.shapes().Remember("d", Feel("b", 0.04), 0);  // a false teacher
  learner_.shapes().Remember("o", Feel("o", 0.04), 0);
  EXPECT_EQ(Hear("b", 0.02), "d");
}

TEST_F(LearnerTest, FeelsEachSignOfALineAlsoBeyondASpace) {
  for (const double size : {0.025, 0.016}) {
    EXPECT_EQ(Feel("i i", size).size(), 2U);  // thin, and far apart
    EXPECT_EQ(Feel("t t", size).size(), 2U);
    EXPECT_EQ(Feel("moon", size).size(), 4U);
    EXPECT_EQ(Feel("o.", size).size(), 3U);  // a full stop is two dots
  }
}

TEST_F(LearnerTest, FeelsByWhatItsDeviceReports) {
  const DeviceProfile device = FindProfile("woodenhaptics", ProfilesFolder());
  SimulatedLearner on_device(ShippedLearner(), ShippedHand(), 1, &device);
  const ItemPage page = SetItem("b", script_, 0.02);
  const FeltShape exact = learner_.Feel(page), stepped = on_device.Feel(page);
  ASSERT_EQ(stepped.size(), 1U);
  EXPECT_NE(exact[0].picture, stepped[0].picture);
  on_device.shapes().Remember("b", stepped, 0);
  on_device.shapes().Remember("d", on_device.Feel(SetItem("d", script_, 0.02)), 0);
  EXPECT_EQ(on_device.shapes().Name(on_device.Feel(page), 0, 0).label, "b");
}

TEST_F(LearnerTest, CountsTheTimeOfItsExploring) {
  const double before = learner_.seconds();
  Feel("b", 0.02);
  const double one = learner_.seconds() - before;
  Feel("bob", 0.02);
  EXPECT_GT(one, 1);
  EXPECT_GT(learner_.seconds() - before - one, 1.5 * one);  // three signs take longer
}

TEST_F(LearnerTest, FeelsNothingOnBlankPaper) { EXPECT_TRUE(Feel("b", 0.04, 0).empty()); }

/// Traces with a push and without, and what the learner felt of its error.
class TracingLearnerTest : public LearnerTest {
 protected:
  TracedItem Trace(GuidanceMode mode, double help, double depth_share = 0.1) {
    LearnerModel model = ShippedLearner();
    model.tracing.press = 0.1;
    SimulatedLearner learner(model, ShippedHand(), 1);
    const ItemPage page = SetItem("b", script_, 0.012, {1, depth_share});
    const GuidancePlan plan{mode, GuidanceTable::Shipped().GainsOf(mode, help),
                            MakeGuidancePath(page.strokes)};
    const TracedItem traced =
        learner.Trace("b", page, mode == GuidanceMode::kOff ? nullptr : &plan);
    left_ = learner.AimErrorShare("b", false);
    return traced;
  }
  double left_ = 1;  ///< error of the aim after the trial
};

TEST_F(TracingLearnerTest, FeelsLessErrorWhenLedAndMoreWhenItIsAmplified) {
  const double none = Trace(GuidanceMode::kOff, 0).felt_error;
  const double left_alone = left_;
  EXPECT_LT(Trace(GuidanceMode::kRail, 10).felt_error, 0.8 * none);
  EXPECT_GT(left_, left_alone);  // and learns less by it
  EXPECT_GT(Trace(GuidanceMode::kAmplify, 8).felt_error, 1.1 * none);
  EXPECT_LT(left_, left_alone);
}

TEST_F(TracingLearnerTest, LearnsNothingOnBlankPaper) {
  EXPECT_EQ(Trace(GuidanceMode::kOff, 0, 0).felt_error, 0);
  EXPECT_EQ(left_, 1);
}

TEST_F(TracingLearnerTest, GoesOnFromFeltErrorsAsIfItHadTraced) {
  const ItemPage page = SetItem("v", script_, 0.012);
  SimulatedLearner whole(ShippedLearner(), ShippedHand(), 7);
  const double felt = whole.Trace("v", page, nullptr).felt_error;
  SimulatedLearner resumed(ShippedLearner(), ShippedHand(), 7);
  resumed.Relive("v", felt);
  EXPECT_EQ(whole.Trace("v", page, nullptr).measured.mean_error,
            resumed.Trace("v", page, nullptr).measured.mean_error);
}

TEST_F(LearnerTest, ForgetsItsAimSlowlyOverDays) {
  const ItemPage page = SetItem("v", script_, 0.04);
  learner_.Trace("v", page, nullptr);
  const double trained = learner_.AimErrorShare("v", false);
  learner_.Wait(1);
  const double next_day = learner_.AimErrorShare("v", false);
  EXPECT_GT(next_day, trained);
  EXPECT_LT(next_day, 1);
}

TEST_F(LearnerTest, DependsOnHelpWhereTheModelSaysSo) {
  LearnerModel model = ShippedLearner();
  model.tracing.dependence = 1;
  SimulatedLearner dependent(model, ShippedHand(), 1);
  dependent.Trace("v", SetItem("v", script_, 0.04), nullptr);
  EXPECT_EQ(dependent.AimErrorShare("v", false), 1);
  EXPECT_LT(dependent.AimErrorShare("v", true), 1);
}

using SlowRecognition = LearnerTest;

TEST_F(SlowRecognition, ErrsMoreOnLettersTooSmallForItsHand) {
  for (const double size : {0.04, 0.016, 0.006}) Teach(kLetters, size);
  const double large = Right(0.04, 2), small = Right(0.003, 3);
  std::printf("right: 40 mm %.3f, 3 mm %.3f\n", large, small);
  for (const auto& pair : confused_) std::printf("%s %d\n", pair.first.c_str(), pair.second);
  EXPECT_GT(large, 0.95);
  EXPECT_GT(large, small + 0.02);
}

TEST_F(SlowRecognition, GuessesOnBlankPaper) {
  Teach(kLetters, 0.012);
  // 130 guesses of chance 1/26: 14 or more right come once in 2000 times.
  const double right = 130 * Right(0.012, 5, 0);
  std::printf("blank: %.0f of 130\n", right);
  EXPECT_LT(right, 13.5);
}

}  // namespace
}  // namespace moontrace
