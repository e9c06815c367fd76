#include "devices/hand/drift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;
const TickMotion kRelax = MotionOver(1, 2000, 2 * std::sqrt(2000.0), 0.001);

/// Travels straight along x in steps of 0.1 mm.
void TravelStraight(Drift& drift, double length) {
  const int steps = static_cast<int>(std::lround(length / 1e-4));
  for (int i = 0; i < steps; ++i) drift.Travel({1e-4, 0});
}

TEST(Drift, GoesAcrossTheTravelByASineOfTheWay) {
  // Over one wavelength the sine's integral returns to zero, over half of it to
  // share * wavelength / pi * cos(phase): two halves are opposite, quarters give the phase.
  Drift drift(0.06, 0.15, kRelax, 5);
  drift.Begin();
  TravelStraight(drift, 0.0375);
  const double quarter = drift.offset().y;
  TravelStraight(drift, 0.0375);
  const double half = drift.offset().y;
  TravelStraight(drift, 0.075);
  EXPECT_NEAR(drift.offset().x, 0, 1e-18);
  EXPECT_NEAR(drift.offset().y, 0, 1e-14);
  const double reach = 0.06 * 0.15 / (2 * kPi);
  // half = 2 reach cos(phase), quarter = reach (cos(phase) + sin(phase)).
  const double cosine = half / (2 * reach), sine = quarter / reach - cosine;
  EXPECT_NEAR(cosine * cosine + sine * sine, 1, 1e-11);
}

TEST(Drift, StaysWithinItsShareAndIsNotTiny) {
  double mean_square = 0;
  int left = 0;
  const int seeds = 400;
  for (int seed = 0; seed < seeds; ++seed) {
    Drift drift(0.06, 0.15, kRelax, static_cast<std::uint64_t>(seed));
    drift.Begin();
    for (int mm = 0; mm < 100; ++mm) {
      TravelStraight(drift, 1e-3);
      EXPECT_LE(std::abs(drift.offset().y), 0.06e-3 * (mm + 1) + 1e-12);
    }
    mean_square += drift.offset().y * drift.offset().y / seeds;
    left += drift.offset().y > 0 ? 1 : 0;
  }
  // Over 100 mm: (2 reach sin(pi 100 / 150) sin(phase + ...))^2, whose mean over phases is
  // 2 reach^2 sin^2(120 deg): rms 1.754 mm. 400 seeds leave a spread of 0.35 / 20 of the square.
  const double expected = 2 * std::pow(0.06 * 0.15 / (2 * kPi) * std::sin(2 * kPi / 3), 2);
  EXPECT_NEAR(mean_square / expected, 1, 5 * 0.71 / 20);
  EXPECT_NEAR(left, seeds / 2, 5 * 10);  // five standard deviations of a fair coin
}

TEST(Drift, IsZeroAtEachApproachAndGoesAnotherWay) {
  Drift drift(0.06, 0.15, kRelax, 9);
  drift.Begin();
  TravelStraight(drift, 0.05);
  const double first = drift.offset().y;
  drift.Begin();
  EXPECT_EQ(drift.offset(), glm::dvec2(0, 0));
  TravelStraight(drift, 0.05);
  EXPECT_NE(drift.offset().y, first);
}

TEST(Drift, StandsAcrossThePresentTravelButDoesNotJumpThere) {
  Drift straight(0.06, 0.15, kRelax, 4), turning(0.06, 0.15, kRelax, 4);
  straight.Begin();
  turning.Begin();
  TravelStraight(straight, 0.03);
  TravelStraight(turning, 0.02);
  const glm::dvec2 before = turning.offset();
  turning.Travel({0, 1e-4});
  // A tick of critical motion at 45 rad/s moves by (0.045)^2 / 2 = 0.1 % of the way, twice over;
  // the drift of this step is 0.006 mm at most.
  EXPECT_LT(glm::length(turning.offset() - before), 0.002 * std::abs(before.y) + 6.1e-6);
  for (int i = 1; i < 100; ++i) turning.Travel({0, 1e-4});
  for (int i = 0; i < 1000; ++i) turning.Travel({0, 0});
  EXPECT_NEAR(turning.offset().x, -straight.offset().y, 1e-12);
  EXPECT_NEAR(turning.offset().y, 0, 1e-12);
}

TEST(Drift, DiesAwayCriticallyWithoutPress) {
  Drift drift(0.06, 0.15, kRelax, 4);
  drift.Begin();
  TravelStraight(drift, 0.03);
  const double begin = drift.offset().y;
  for (int i = 0; i < 50; ++i) drift.Relax();
  const double way = std::sqrt(2000.0) * 0.05;
  EXPECT_NEAR(drift.offset().y, begin * (1 + way) * std::exp(-way), 1e-14);
}

}  // namespace
}  // namespace moontrace
