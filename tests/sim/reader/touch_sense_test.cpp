#include "sim/reader/touch_sense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

constexpr double kTick = 1e-3;
constexpr double kYields = 1.75e-3;   ///< paper and device together [m/N]
constexpr double kSurface = -0.2e-3;  ///< where the paper begins [m]

ReaderKnowledge Knowledge() {
  ReaderKnowledge knowledge;
  knowledge.press = 1;
  knowledge.depth = 0.3e-3;
  knowledge.width = 0.7e-3;
  knowledge.device_stiffness = 2000;  // yields 0.5 mm/N of it
  return knowledge;
}

/// A tip on flat paper that carries `force`.
ReaderInput On(double time, double force) {
  return {time, {0, 0, kSurface - kYields * force}, {0, 0, force}};
}

/// Rests, is lifted, and lands again.
TouchSense Landed() {
  TouchSense sense(Knowledge(), kTick);
  double t = 0;
  for (; t < 0.2; t += kTick) sense.Add(On(t, 1));
  sense.Lift();
  for (; t < 0.4; t += kTick) sense.Add({t, {0, 0, 2e-3}, {0, 0, 0}});
  for (double force = 0; force < 1; force += 0.05, t += kTick) sense.Add(On(t, force));
  return sense;
}

// A tip that bounces presses now more, now less; flat paper stays flat under it. With the device's
// yielding alone a third of the press would be 0.4 mm, more than a groove's depth.
TEST(TouchSense, FlatPaperIsFlatUnderATipThatBounces) {
  TouchSense sense = Landed();
  for (double t = 0; t < 0.3; t += kTick) {
    const Felt& felt = sense.Add(On(1 + t, 1 + 0.33 * std::sin(80 * t)));
    EXPECT_LT(std::abs(felt.depth), 0.1) << t;
  }
}

TEST(TouchSense, AGrooveIsFeltAsDeepAsItIsUnderATipThatBounces) {
  TouchSense sense = Landed();
  for (double t = 0; t < 0.1; t += kTick) {
    ReaderInput input = On(1 + t, 1 + 0.33 * std::sin(80 * t));
    input.tip.z -= 0.3e-3;
    EXPECT_NEAR(sense.Add(input).depth, 1, 0.1) << t;
  }
}

// By a line through the landing: the paper is where nothing presses.
TEST(TouchSense, ALandingTellsWhereThePaperBegins) {
  EXPECT_NEAR(Landed().surface(), kSurface, 0.05e-3);
}

}  // namespace
}  // namespace moontrace
