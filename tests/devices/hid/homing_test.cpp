#include "devices/hid/homing.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/source_path.h"

namespace moontrace {
namespace {

ArmGeometry Arm() { return LoadProfile(SourcePath("devices/profiles/woodenhaptics.toml")).arm; }

constexpr ArmCounts kRestCounts = {100, -200, 300};

/// Counts that are `a`, `b`, `c` away from the rest.
ArmCounts Away(int a, int b, int c) {
  return {static_cast<std::int16_t>(kRestCounts[0] + a),
          static_cast<std::int16_t>(kRestCounts[1] + b),
          static_cast<std::int16_t>(kRestCounts[2] + c)};
}

/// Holds the arm at `counts` from `time` for `seconds`, read every millisecond.
HomingStep Hold(Homing& homing, const ArmCounts& counts, double& time, double seconds) {
  HomingStep step = homing.step();
  for (const double end = time + seconds; time < end; time += 0.001) {
    step = homing.Advance(counts, time);
  }
  return step;
}

// In the rest a count of A moves the tip by 245 mm x 2 pi / 32000 = 48 um to the left, of B by 54
// um away from the person, of C by 64 um down, as this arm's counts fall while its angles grow.
TEST(Homing, IsDoneAfterRestAndThreeRightMoves) {
  Homing homing(Arm());
  double time = 0;
  EXPECT_EQ(Hold(homing, Away(0, 0, -300), time, 0.1), HomingStep::kRest);
  EXPECT_EQ(Hold(homing, kRestCounts, time, 1.1), HomingStep::kMove);
  EXPECT_EQ(homing.rest(), kRestCounts);
  EXPECT_EQ(Hold(homing, Away(0, 0, -300), time, 0.1), HomingStep::kMove);  // up
  EXPECT_EQ(Hold(homing, Away(-350, 0, -300), time, 0.1), HomingStep::kMove);
  EXPECT_EQ(Hold(homing, Away(-350, -350, -300), time, 0.1), HomingStep::kDone);
}

TEST(Homing, IsNotDoneByAnArmThatMerelyLiesThere) {
  Homing homing(Arm());
  double time = 0;
  EXPECT_EQ(Hold(homing, kRestCounts, time, 20), HomingStep::kRest);
}

TEST(Homing, WaitsUntilTheCountsAreStill) {
  Homing homing(Arm());
  double time = 0;
  Hold(homing, Away(300, 0, 0), time, 0.1);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(Hold(homing, Away(0, i % 2 * 40, 0), time, 0.5), HomingStep::kRest);
  }
  // A hand's tremble of less than a millimetre is still.
  for (int i = 0; i < 6; ++i) Hold(homing, Away(0, i % 2 * 8, 0), time, 0.25);
  EXPECT_EQ(homing.step(), HomingStep::kMove);
}

TEST(Homing, BeginsAgainWhenTheSenseIsWrong) {
  Homing homing(Arm());
  double time = 0;
  Hold(homing, Away(300, 0, 0), time, 0.1);
  ASSERT_EQ(Hold(homing, kRestCounts, time, 1.1), HomingStep::kMove);
  EXPECT_EQ(Hold(homing, Away(350, 0, 0), time, 0.1), HomingStep::kWrongDirection);  // to the left
  // The counts at that moment are the first of the new attempt.
  EXPECT_EQ(Hold(homing, kRestCounts, time, 1.1), HomingStep::kMove);
}

TEST(Homing, HasASentenceForEveryStepThatFitsALine) {
  for (const HomingStep step :
       {HomingStep::kRest, HomingStep::kMove, HomingStep::kWrongDirection}) {
    EXPECT_FALSE(SentenceOf(step).empty());
    EXPECT_LE(SentenceOf(step).size(), 80u);
  }
  EXPECT_TRUE(SentenceOf(HomingStep::kDone).empty());
}

}  // namespace
}  // namespace moontrace
