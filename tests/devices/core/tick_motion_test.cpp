#include "devices/core/tick_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace moontrace {
namespace {

struct State {
  double x = 0, v = 0;
};

/// The same motion by the classic Runge-Kutta method in 1000 steps, an independent way.
State ByRungeKutta(double m, double k, double b, double tick, State state, double f) {
  const int steps = 1000;
  const double h = tick / steps;
  const auto rate = [&](State s) { return State{s.v, (f - k * s.x - b * s.v) / m}; };
  const auto moved = [](State s, State r, double by) {
    return State{s.x + by * r.x, s.v + by * r.v};
  };
  for (int i = 0; i < steps; ++i) {
    const State a = rate(state);
    const State c = rate(moved(state, a, h / 2));
    const State d = rate(moved(state, c, h / 2));
    const State e = rate(moved(state, d, h));
    state.x += h / 6 * (a.x + 2 * c.x + 2 * d.x + e.x);
    state.v += h / 6 * (a.v + 2 * c.v + 2 * d.v + e.v);
  }
  return state;
}

void ExpectAgrees(double m, double k, double b, double tick) {
  const TickMotion motion = MotionOver(m, k, b, tick);
  State state{0.002, -0.05};
  const double force = 0.7;
  const State expected = ByRungeKutta(m, k, b, tick, state, force);
  Move(motion, state.x, state.v, force);
  // Rounding of 1000 steps, a few 1e-16 each, on values of some 1e-2 m and 1 m/s.
  EXPECT_NEAR(state.x, expected.x, 1e-14);
  EXPECT_NEAR(state.v, expected.v, 1e-12);
}

TEST(TickMotion, AgreesWithAFineIntegrationHoweverItIsDamped) {
  ExpectAgrees(0.1, 200, 3, 0.001);                   // the shipped hand
  ExpectAgrees(0.1, 200, 3, 0.02);                    // a long tick
  ExpectAgrees(0.1, 200, 2 * std::sqrt(20.0), 0.01);  // critical
  ExpectAgrees(0.1, 200, 30, 0.01);                   // over-damped
  ExpectAgrees(0.1, 200, 0, 0.01);                    // undamped
  ExpectAgrees(0.1, 0, 3, 0.01);                      // no spring
  ExpectAgrees(0.1, 0, 0, 0.01);                      // free
}

TEST(TickMotion, TwoTicksAreOneOfTwiceTheLength) {
  const TickMotion half = MotionOver(0.1, 200, 3, 0.005);
  const TickMotion whole = MotionOver(0.1, 200, 3, 0.01);
  State a{0.01, 0.2}, b = a;
  Move(half, a.x, a.v, -0.3);
  Move(half, a.x, a.v, -0.3);
  Move(whole, b.x, b.v, -0.3);
  EXPECT_NEAR(a.x, b.x, 1e-16);
  EXPECT_NEAR(a.v, b.v, 1e-15);
}

}  // namespace
}  // namespace moontrace
