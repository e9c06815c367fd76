#include "devices/core/tip_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <type_traits>

namespace moontrace {
namespace {

constexpr double kTick = 0.001;

TEST(TipEstimate, IsTheWayOverTheTimeOfEachReadingsPeriod) {
  TipEstimate velocity;
  for (int n = 0; n < 100; ++n) {  // 50 mm/s, read every 8 ms
    velocity.Advance(kTick, n % 8 == 0, {0.05 * n * kTick, 0, 0});
    ASSERT_NEAR(velocity.v().x, n >= 8 ? 0.05 : 0, 1e-12) << n;
  }
}

TEST(TipEstimate, FadesWhereNoReadingComes) {
  TipEstimate velocity;
  velocity.Advance(kTick, true, {0, 0, 0});
  velocity.Advance(kTick, true, {0.001, 0, 0});
  EXPECT_NEAR(velocity.v().x, 1, 1e-12);
  for (int n = 0; n < 10; ++n) velocity.Advance(kTick, false, {0.001, 0, 0});
  EXPECT_NEAR(velocity.v().x, 0.1, 1e-12);  // less than 1 mm in 10 ms
  velocity.Advance(kTick, true, {0.001, 0, 0});
  EXPECT_EQ(velocity.v().x, 0);
}

TEST(TipEstimate, KnowsNoWayToTheFirstReadingNorToOneElsewhere) {
  TipEstimate velocity;
  velocity.Advance(kTick, true, {5, 0, 0});
  EXPECT_EQ(velocity.v(), glm::dvec3(0, 0, 0));
  velocity.Restart();
  velocity.Advance(kTick, true, {7, 0, 0});
  EXPECT_EQ(velocity.v(), glm::dvec3(0, 0, 0));
}

TEST(TipEstimate, RestsWhereTheNewestReadingWasUntilTheNextOne) {
  TipEstimate tip(glm::dvec3(50e-6));
  tip.Advance(kTick, true, {0.01, 0.02, 0.03});
  tip.Restart();
  tip.Advance(kTick, false, {0, 0, 0});
  EXPECT_EQ(tip.p(), glm::dvec3(0.01, 0.02, 0.03));
  EXPECT_EQ(tip.v(), glm::dvec3(0, 0, 0));
  static_assert(std::is_trivially_copyable_v<TipEstimate>);
}

TEST(TipEstimate, TakesExactReadingsAndAxesThatAreNotMeasuredAsTheyAre) {
  DeviceLimits limits;
  limits.measures = {true, true, false};
  limits.position_step = 100e-6;
  TipEstimate tip(limits);
  for (int n = 0; n < 50; ++n) {
    const double x = 1e-6 * n * n;
    tip.Advance(kTick, true, {x, x, x});
    EXPECT_EQ(tip.p().z, x);
  }
  EXPECT_NEAR(tip.v().z, (49 * 49 - 48 * 48) * 1e-3, 1e-12);
  EXPECT_NE(tip.p().x, tip.p().z);
}

// The steady Kalman filter found by iterating its covariance: an acceleration that is drawn anew
// for each period, readings whose rounding spreads evenly over a step.
TEST(TrackingGains, AreThoseOfTheSteadyKalmanFilter) {
  for (const double step : {10e-6, 55e-6, 117e-6}) {
    for (const double period : {0.001, 0.008}) {
      const double q = kHandAcceleration * kHandAcceleration, r = step * step / 12, t = period;
      double xx = r, xv = 0, vv = r / (t * t), gain_x = 0, gain_v = 0;
      for (int n = 0; n < 5000; ++n) {
        const double pxx = xx + 2 * t * xv + t * t * vv + q * t * t * t * t / 4;
        const double pxv = xv + t * vv + q * t * t * t / 2, pvv = vv + q * t * t;
        gain_x = pxx / (pxx + r);
        gain_v = pxv / (pxx + r);
        xx = (1 - gain_x) * pxx;
        xv = (1 - gain_x) * pxv;
        vv = pvv - gain_v * pxv;
      }
      const TrackingGains gains = TrackingGainsFor(step, period);
      EXPECT_NEAR(gains.position, gain_x, 1e-6) << step << ' ' << period;
      EXPECT_NEAR(gains.velocity, std::min(1.0, gain_v * t), 1e-6) << step << ' ' << period;
    }
  }
}

// Of an alpha-beta tracker under a steady acceleration a, read every T: a T^2 (1 - alpha) / beta in
// place, a T (alpha / beta - 1 / 2) in velocity; for short periods a / w^2 and sqrt(2) a / w.
TEST(TipEstimate, LagsBehindAnAccelerationByTheClosedForm) {
  const double step = 55e-6, a = 0.5;
  TipEstimate tip(glm::dvec3(step, step, step));
  double place = 0, velocity = 0;
  for (int n = 0; n < 1000; ++n) {
    const double time = n * kTick;
    velocity = a * time;
    place = 0.5 * a * time * time;
    tip.Advance(kTick, true, {place, 0, 0});
  }
  const TrackingGains gains = TrackingGainsFor(step, kTick);
  const double lag = a * kTick * kTick * (1 - gains.position) / gains.velocity;
  const double slow = a * kTick * (gains.position / gains.velocity - 0.5);
  EXPECT_NEAR(place - tip.p().x, lag, 1e-9);
  EXPECT_NEAR(velocity - tip.v().x, slow, 1e-7);
  const double w = std::sqrt(kHandAcceleration * std::sqrt(12.0) / step);
  EXPECT_NEAR(lag, a / (w * w), 0.25 * lag);  // beta is w^2 T^2 up to its next order, w T = 0.23
  EXPECT_NEAR(slow, std::sqrt(2.0) * a / w, 0.1 * slow);
}

// Even motion is what the tracker reckons with: no lag. What is left of the steps' rounding is
// within what the filter's own covariance allows several times over.
TEST(TipEstimate, FollowsAnEvenHandThroughItsSteps) {
  for (const double speed : {0.001, 0.002, 0.005, 0.0193, 0.05}) {
    const double step = 55e-6;
    TipEstimate tip{glm::dvec3(step)};
    double worst_place = 0, worst_rate = 0;
    for (int n = 0; n < 4000; ++n) {
      const double x = speed * n * kTick;
      tip.Advance(kTick, true, glm::dvec3(step * std::round(x / step)));
      if (n < 1000) continue;
      worst_place = std::max(worst_place, std::abs(tip.p().x - x));
      worst_rate = std::max(worst_rate, std::abs(tip.v().x - speed));
    }
    EXPECT_LT(worst_place, 0.6 * step) << speed;
    EXPECT_LT(worst_rate, 0.006) << speed;  // [m/s]; a step in a tick is 0.055
  }
}

TEST(TipEstimate, IsNeverFartherFromAReadingThanItsBand) {
  const double step = 64e-6;
  TipEstimate tip{glm::dvec3(step)};
  double x = 0;
  for (int n = 0; n < 600; ++n) {  // 0.5 m/s, stopped at once
    if (n < 300) x += 0.5 * kTick;
    const double reading = step * std::round(x / step);
    tip.Advance(kTick, true, {reading, 0, 0});
    ASSERT_LE(std::abs(tip.p().x - reading), TipEstimate::kBand * step * (1 + 1e-9)) << n;
    // half of what is beyond goes at each reading: 0.5 m/s is 7.8 steps a reading, so what is left
    // is within the band, which the tracker then follows by itself, after some ten readings
    if (n == 312) {
      EXPECT_LT(std::abs(tip.v().x), 0.15);
    }
  }
  EXPECT_NEAR(tip.v().x, 0, 1e-6);
}

}  // namespace
}  // namespace moontrace
