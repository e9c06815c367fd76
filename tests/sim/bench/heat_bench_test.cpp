#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "sim/bench/row.h"

namespace moontrace {
namespace {

// The hand's spring draws straight down; without friction the page answers along its normal only,
// so a slope of a leaves cos a of the press, and cos^2 a of it on the upright motor. Heat goes with
// force squared: cos^4 a. moontrace-raw.toml: 1.5 N for ever, 20 s.
TEST(HeatBench, ATiltedPageIsPressedLessByTheSameHandAndWarmsTheMotorsLess) {
  std::map<std::string, double> figure;
  for (const BenchRow& row : BenchHeat()) {
    figure[row.name] = row.value;
    EXPECT_TRUE(row.holds.value_or(true)) << row.name;
  }
  const double c = std::cos(20 * std::numbers::pi / 180);
  const std::string twice = "hand of 3 N, page ", once = "hand of 1.5 N, page ";
  const std::string tilted = "tilted 20 degrees: ";
  // half a percent: the hand still settles at 1 s, when press and motor are read
  EXPECT_NEAR(figure.at(twice + "level: presses"), 3, 0.015);
  EXPECT_NEAR(figure.at(twice + tilted + "presses"), 3 * c, 0.015);
  EXPECT_NEAR(figure.at(twice + "level: warmest motor"), 3, 0.015);
  EXPECT_NEAR(figure.at(twice + tilted + "warmest motor"), 3 * c * c, 0.015);
  EXPECT_LE(figure.at(twice + "level: heat"), 1);
  EXPECT_GT(figure.at(twice + "level: heat"), 0.99);
  EXPECT_GT(figure.at(twice + tilted + "motors rest after"),
            figure.at(twice + "level: motors rest after"));
  // six time constants of the continuous force, the ramp-in counting little
  const double warm = 1 - std::exp(-6.0);
  EXPECT_NEAR(figure.at(once + "level: heat"), warm, 0.005);
  EXPECT_NEAR(figure.at(once + tilted + "heat"), warm * std::pow(c, 4), 0.005);
}

}  // namespace
}  // namespace moontrace
