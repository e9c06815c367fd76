#include "sim/reading/senses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace moontrace {
namespace {

TEST(LateSenses, GiveEachReadingLaterByTheDelayAndAsOfNow) {
  constexpr double kTick = 0.001;
  LateSenses senses(0.005, kTick, {0, {-1, 0, 0}, {0, 0, 0}});
  for (int i = 0; i < 20; ++i) {
    const ReaderInput got = senses.Pass({i * kTick, {1.0 * i, 0, 0}, {0, 2.0 * i, 0}});
    EXPECT_EQ(got.time, i * kTick);
    EXPECT_EQ(got.tip.x, i < 5 ? -1 : i - 5) << i;
    EXPECT_EQ(got.force.y, i < 5 ? 0 : 2 * (i - 5)) << i;
  }
}

// Over 4000 s there are some 2000 independent values of a square (the integral of the squared
// correlation is 1.9 s): the rms is known to 1.6 percent, and a tick of 10 ms adds 1.3.
TEST(UnsurePlace, HasItsRmsAndItsTime) {
  constexpr double kRms = 0.5e-3, kTick = 0.01;
  UnsurePlace unsure(kRms, kTick, 7);
  std::vector<glm::dvec2> errors;
  for (int i = 0; i < 400000; ++i) errors.push_back(unsure.Next());
  for (const int axis : {0, 1}) {
    double square = 0, product = 0, across = 0;
    constexpr std::size_t kLater = 75;  // one lag
    for (std::size_t i = 0; i + kLater < errors.size(); ++i) {
      square += errors[i][axis] * errors[i][axis];
      product += errors[i][axis] * errors[i + kLater][axis];
      across += errors[i].x * errors[i].y;
    }
    const auto count = static_cast<double>(errors.size() - kLater);
    EXPECT_NEAR(std::sqrt(square / count), kRms, 0.07 * kRms);
    EXPECT_NEAR(product / square, 2 * std::exp(-1.0), 0.07);
    EXPECT_NEAR(across / square, 0, 0.1);
  }
}

TEST(UnsurePlace, WandersFromTheFirstTickOnAndWithoutJumps) {
  UnsurePlace unsure(1e-3, 0.001, 3);
  glm::dvec2 last = unsure.Next();
  EXPECT_GT(std::abs(last.x) + std::abs(last.y), 1e-5);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 next = unsure.Next();
    // its speed has an rms of 1 mm / 0.75 s on each axis; five times that
    EXPECT_LT(std::abs(next.x - last.x), 5 * 1e-3 / 0.75 * 0.001);
    last = next;
  }
}

TEST(UnsurePlace, IsNoneForASureHand) {
  UnsurePlace unsure(0, 0.001, 3);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(unsure.Next(), glm::dvec2(0, 0));
}

}  // namespace
}  // namespace moontrace
