#include "sim/console/round_axis.h"

#include <gtest/gtest.h>

#include <cmath>

namespace moontrace {
namespace {

TEST(RoundAxis, HasTheNumbersThatPeopleWouldWrite) {
  const auto as = [](std::initializer_list<double> numbers) {
    return std::vector<double>(numbers);
  };
  EXPECT_EQ(RoundAxis(0, 1).size(), 3U);
  EXPECT_EQ(RoundAxis(0, 100), as({0, 50, 100}));
  EXPECT_EQ(RoundAxis(1.3, 1), as({0, 0.5, 1, 1.5}));
  EXPECT_EQ(RoundAxis(230, 100), as({0, 100, 200, 300}));
  EXPECT_EQ(RoundAxis(7000, 100), as({0, 2000, 4000, 6000, 8000}));
}

TEST(RoundAxis, ReachesEachValueInAtMostFourStepsOfOneTwoOrFive) {
  for (double most = 1e-3; most < 1e6; most *= 1.07) {
    const std::vector<double> numbers = RoundAxis(most, 1e-3);
    ASSERT_GE(numbers.size(), 2U) << most;
    EXPECT_LE(numbers.size(), 5U) << most;
    EXPECT_GE(numbers.back(), most * (1 - 1e-6));
    EXPECT_LT(numbers[numbers.size() - 2], most);  // no empty step
    double leading = numbers[1];
    while (leading < 1 - 1e-9) leading *= 10;
    while (leading >= 10 - 1e-9) leading /= 10;
    const bool round = std::abs(leading - 1) < 1e-6 || std::abs(leading - 2) < 1e-6 ||
                       std::abs(leading - 5) < 1e-6;
    EXPECT_TRUE(round) << most << ' ' << numbers[1];
  }
}

}  // namespace
}  // namespace moontrace
