#include "sim/reader/touch_sense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "textures/base/units.h"

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
  for (; t < 0.2; t += kTick) sense.Add(On(t, 1), true);
  sense.Lift();
  for (; t < 0.4; t += kTick) sense.Add({t, {0, 0, 2e-3}, {0, 0, 0}}, false);
  for (double force = 0; force < 1; force += 0.05, t += kTick) sense.Add(On(t, force), true);
  return sense;
}

// A tip that bounces presses now more, now less; flat paper stays flat under it. With the device's
// yielding alone a third of the press would be 0.4 mm, more than a groove's depth.
TEST(TouchSense, FlatPaperIsFlatUnderATipThatBounces) {
  TouchSense sense = Landed();
  for (double t = 0; t < 0.3; t += kTick) {
    const Felt& felt = sense.Add(On(1 + t, 1 + 0.33 * std::sin(80 * t)), true);
    EXPECT_LT(std::abs(felt.depth), 0.1) << t;
  }
}

TEST(TouchSense, AGrooveIsFeltAsDeepAsItIsUnderATipThatBounces) {
  TouchSense sense = Landed();
  for (double t = 0; t < 0.1; t += kTick) {
    ReaderInput input = On(1 + t, 1 + 0.33 * std::sin(80 * t));
    input.tip.z -= 0.3e-3;
    EXPECT_NEAR(sense.Add(input, true).depth, 1, 0.1) << t;
  }
}

/// How far from flat, as a share of a groove's depth, a light hand feels plain paper where its
/// ringing tip turns, at most, in these swings. Its damper makes its first touch firmer than how
/// deep it presses in tells.
double FarthestFromFlat(bool raised, int from, int to) {
  constexpr double kPress = 0.2, kDamper = 4, kRings = 0.05;  // [N], [N s/m], [s]
  ReaderKnowledge knowledge = Knowledge();
  knowledge.press = kPress;
  knowledge.followed = false;
  knowledge.raised = raised;
  TouchSense sense(knowledge, kTick);
  double t = 0, farthest = 0;
  for (; t < 0.2; t += kTick) sense.Add(On(t, kPress), true);
  sense.Lift();
  for (; t < 0.4; t += kTick) sense.Add({t, {0, 0, 2e-3}, {0, 0, 0}}, false);
  sense.Add({t, {0, 0, kSurface}, {0, 0, 0.03 * kDamper}}, true);  // at 30 mm/s
  for (int swing = 0; swing < to; ++swing) {
    double before = 1;
    for (double since = 0; since < kRings; since += kTick, t += kTick) {
      const double turned = kTurn * since / kRings;
      const double sinks = -0.5 * std::cos(turned);
      const double speed = 0.5 * kTurn / kRings * std::sin(turned);
      const double off = kYields * kPress * sinks;
      const double force = kPress * (1 + sinks) + kDamper * kYields * kPress * speed;
      const double depth =
          sense.Add({t, {0, 0, kSurface - kYields * kPress - off}, {0, 0, force}}, true).depth;
      const bool turns = speed * before <= 0;
      if (swing >= from && turns) farthest = std::max(farthest, std::abs(depth));
      before = speed;
    }
  }
  return farthest;
}

TEST(TouchSense, FlatPaperIsFlatUnderALightTipThatRings) {
  // a tick beside its turn the damper adds 0.011 N, 0.064 of the depth; 3 percent of what half the
  // press yields, the median's step, are 0.018 more
  EXPECT_LT(FarthestFromFlat(false, 50, 60), 0.09);
  EXPECT_LT(FarthestFromFlat(true, 50, 60), 0.09);
}

// What the damper adds beside a turn, as above. Beside ridges the first turn of all tells.
TEST(TouchSense, OneSwingTellsHowFarDeviceAndPaperYield) {
  EXPECT_LT(FarthestFromFlat(true, 1, 2), 0.065);
}

/// A hand without height that presses from the beginning, held by a wall with `force` after 0.4 s
/// and for 0.1 s.
double DepthAfter(double force, double seconds) {
  ReaderKnowledge knowledge = Knowledge();
  knowledge.feels_height = false;
  knowledge.delay = 0.12;
  knowledge.lag = 0.03;
  TouchSense sense(knowledge, kTick);
  for (double t = 0; t < seconds; t += kTick) {
    const bool held = t > 0.4 && t < 0.5;
    sense.Add({t, {0, 0, 0}, {held ? force : 0, 0, 0}}, true);
  }
  return sense.felt().depth;
}

// A groove's wall takes up to press times slope sideways, Knowledge().Hold() = 1.43 N.
TEST(TouchSense, WallsTellOfAGrooveWhereHeightIsNotFelt) {
  EXPECT_EQ(DepthAfter(1.4, 0.4), 0);
  EXPECT_EQ(DepthAfter(1.4, 0.5), 1);
  EXPECT_LT(DepthAfter(0.05, 0.5), 0.12);  // a device's grit is flat paper
  EXPECT_GT(DepthAfter(1.4, 2.5), 0.3);    // a straight way has no walls ahead
  EXPECT_LT(DepthAfter(1.4, 4.8), 0.1);
}

TEST(TouchSense, FeelsNoWallBeforeTheLandingIsFelt) {
  ReaderKnowledge knowledge = Knowledge();
  knowledge.feels_height = false;
  knowledge.delay = 0.12;
  knowledge.lag = 0.03;
  TouchSense sense(knowledge, kTick);
  for (double t = 0; t < 0.14; t += kTick) {
    EXPECT_EQ(sense.Add({t, {0, 0, 0}, {1, 0, 0}}, true).depth, 0);
  }
}

// By a line through the landing: the paper is where nothing presses.
TEST(TouchSense, ALandingTellsWhereThePaperBegins) {
  EXPECT_NEAR(Landed().surface(), kSurface, 0.05e-3);
}

ReaderKnowledge LateHand() {
  ReaderKnowledge knowledge;
  knowledge.delay = 0.120;
  knowledge.lag = 0.030;
  return knowledge;
}

TEST(AsideDrift, FindsWhatAHandStraysToTheLeftOfItsWay) {
  constexpr double kStrays = 0.8e-3;
  AsideDrift drift(LateHand(), 0.25, kTick);
  // upwards at 20 mm/s, felt 150 ms late and 0.8 mm to the left of the aim, which corrects itself
  std::vector<glm::dvec2> aims;
  for (int n = 0; n < 2000; ++n) {
    aims.emplace_back(drift.left(), 0.02 * n * kTick);
    const glm::dvec2 then = aims[n > 150 ? static_cast<std::size_t>(n - 150) : 0];
    drift.Add(then + glm::dvec2(-kStrays, 0), true, aims.back(), {0, 1});
  }
  EXPECT_NEAR(drift.left(), kStrays, 0.02 * kStrays);
  drift.Begin();
  EXPECT_EQ(drift.left(), 0);
}

TEST(AsideDrift, LearnsNothingOnASlopeOrRoundACorner) {
  AsideDrift drift(LateHand(), 0.25, 1e-3);
  for (int n = 0; n < 1000; ++n) drift.Add({1e-3, 0}, false, {0, 0}, {0, 1});
  EXPECT_EQ(drift.left(), 0);
  for (int n = 0; n < 1000; ++n) {
    const bool up = n / 100 % 2 == 0;  // it has turned since what it feels
    drift.Add({1e-3, 0}, true, {0, 0}, {0, up ? 1 : -1});
  }
  EXPECT_LT(std::abs(drift.left()), 1e-3);
}

// Of a ridge the flat is the lowest: a tip that lands on a slope finds it when it has come down.
TEST(TouchSense, FeelsRidgesAboveTheFlat) {
  ReaderKnowledge knowledge = Knowledge();
  knowledge.raised = true;
  TouchSense sense(knowledge, 1e-3);
  const auto feel = [&](double z, double x, int ticks) {
    for (int n = 0; n < ticks; ++n) {
      sense.Add({n * 1e-3, {x + n * 1e-5, 0, z}, {0, 0, knowledge.press}}, true);
    }
  };
  feel(0, 0, 300);
  EXPECT_NEAR(sense.felt().depth, 0, 0.01);
  feel(knowledge.depth, 0.003, 60);
  EXPECT_NEAR(sense.felt().depth, 1, 0.01);
  feel(-0.5 * knowledge.depth, 0.004, 600);  // it had rested on a slope
  EXPECT_NEAR(sense.felt().depth, 0, 0.02);
}

}  // namespace
}  // namespace moontrace
