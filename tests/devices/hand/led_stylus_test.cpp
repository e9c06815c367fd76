#include "devices/hand/led_stylus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <vector>

namespace moontrace {
namespace {

constexpr double kTick = 0.001;

/// The shipped hand's figures, without what trembles and drifts.
HandModel Hand() {
  HandModel hand;
  hand.mass = 0.1;
  hand.stiffness = 200;
  hand.damping = 3;
  hand.drift_wavelength = 0.1;
  hand.late_ticks = 1;
  return hand;
}

HandModel Trembling() {
  HandModel hand = Hand();
  hand.tremor_rms = 1e-4;
  hand.tremor_low = 8;
  hand.tremor_high = 12;
  hand.drift = 0.06;
  return hand;
}

glm::dvec3 After(LedStylus& stylus, int ticks, glm::dvec3 force = {0, 0, 0}) {
  DeviceState state;
  for (int i = 0; i < ticks; ++i) {
    EXPECT_EQ(stylus.Read(state), DeviceStatus::kOk);
    stylus.Write(force);
  }
  return state.p_D;
}

TEST(LedStylus, ComesToRestWhereItIsLed) {
  LedStylus stylus(Hand(), {}, {0, 0, 0.005}, kTick, 1);
  stylus.Lead({{0.02, -0.01, 0.004}, 0});
  const glm::dvec3 p = After(stylus, 2000);
  EXPECT_LT(glm::distance(p, glm::dvec3(0.02, -0.01, 0.004)), 1e-6);
}

// A spring: force over stiffness.
TEST(LedStylus, GivesWayByForceOverStiffness) {
  LedStylus stylus(Hand(), {}, {0, 0, 0}, kTick, 1);
  const glm::dvec3 p = After(stylus, 3000, {0.5, 0, 0});
  EXPECT_NEAR(p.x, 0.5 / 200, 1e-6);
}

// A critically damped follower of frequency w lies 2 v / w behind an even movement at v.
TEST(LedStylus, LagsAnEvenMovementByItsMuscle) {
  const Muscle muscle;
  LedStylus stylus(Hand(), muscle, {0, 0, 0.005}, kTick, 1);
  const double v = 0.02;
  glm::dvec3 aim{0, 0, 0.005};
  glm::dvec3 p{0, 0, 0};
  for (int i = 0; i < 3000; ++i) {
    aim.x = v * kTick * i;
    stylus.Lead({aim, 0});
    p = After(stylus, 1);
  }
  // two ticks of holding an aim and of stepping
  EXPECT_NEAR(aim.x - p.x, v * muscle.lag, 2 * v * kTick);
}

TEST(LedStylus, IsNoFasterThanItsMuscle) {
  const Muscle muscle;
  LedStylus stylus(Hand(), muscle, {0, 0, 0.005}, kTick, 1);
  stylus.Lead({{0.2, 0, 0.005}, 0});
  // from rest at 8 m/s^2 to 0.4 m/s takes 10 mm and 50 ms, the rest 475 ms
  EXPECT_LT(After(stylus, 450).x, 0.2 - 0.4 * 0.025);
  EXPECT_NEAR(After(stylus, 1000).x, 0.2, 1e-3);
}

// Under its press the height is free: it falls as m z'' = -press - b z', to press / b.
TEST(LedStylus, PressesWithTheForceItIsAskedFor) {
  LedStylus stylus(Hand(), {}, {0, 0, 0.5}, kTick, 1);
  stylus.Lead({{0, 0, 0}, 1});
  const double before = After(stylus, 600).z;
  EXPECT_NEAR((before - After(stylus, 100).z) / 0.1, 1.0 / 3, 1e-3);
  // a page that carries it
  LedStylus carried(Hand(), {}, {0, 0, 0}, kTick, 1);
  carried.Lead({{0, 0, 0}, 1});
  DeviceState state;
  for (int i = 0; i < 3000; ++i) {
    carried.Read(state);
    carried.Write({0, 0, state.p_D.z < 0 ? -1000 * state.p_D.z : 0});
  }
  EXPECT_NEAR(state.p_D.z, -1e-3, 1e-6);
}

TEST(LedStylus, IsTheSameForTheSameSeedOnly) {
  const auto run = [](std::uint64_t seed) {
    LedStylus stylus(Trembling(), {}, {0, 0, 0}, kTick, seed);
    stylus.Lead({{0.01, 0, 0}, 1});
    return After(stylus, 500, {0, 0, 1});
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

TEST(LedStylus, LeavesOutAnAimThatIsNotFinite) {
  LedStylus stylus(Hand(), {}, {0, 0, 0}, kTick, 1);
  stylus.Lead({{NAN, 0, 0}, 0});
  stylus.Lead({{0.01, 0, 0}, -1});
  EXPECT_EQ(After(stylus, 100), glm::dvec3(0, 0, 0));
}

TEST(LedStylus, RefusesAHandThatCannotMove) {
  HandModel hand = Hand();
  hand.mass = 0;
  EXPECT_THROW(LedStylus(hand, {}, {0, 0, 0}, kTick, 1), std::invalid_argument);
  EXPECT_THROW(LedStylus(Hand(), {}, {0, 0, 0}, 0, 1), std::invalid_argument);
  Muscle muscle;
  muscle.lag = 0;
  EXPECT_THROW(LedStylus(Hand(), muscle, {0, 0, 0}, kTick, 1), std::invalid_argument);
}

}  // namespace
}  // namespace moontrace
