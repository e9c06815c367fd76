#include "sim/reader/guide_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "textures/base/random.h"

namespace moontrace {
namespace {

const SignPlace kLine{{0.02, -0.03}, 0.006, 0.04};

/// Points along an arc that bulges to the right of an upright chord through the origin, by this
/// share of its height; `at`: where its lower end lies. All in em.
std::vector<FeltPoint> Arc(glm::dvec2 at, double height, double bulge, double noise = 0) {
  const double radius = (height * height / 4 + bulge * bulge) / (2 * std::abs(bulge));
  const double half = std::asin(height / 2 / radius);
  Random random(7);
  std::vector<FeltPoint> felt;
  for (int i = 0; i <= 40; ++i) {
    const double angle = half * (i / 20.0 - 1);
    const double right = radius * std::cos(angle) - (radius - std::abs(bulge));
    glm::dvec2 p =
        at + glm::dvec2(std::copysign(right, bulge), height / 2 + radius * std::sin(angle));
    p.x += noise * std::sqrt(12.0) * (random.Uniform() - 0.5);
    p.y += noise * std::sqrt(12.0) * (random.Uniform() - 0.5);
    felt.push_back({FromEm(kLine, p), 0.5});
  }
  return felt;
}

TEST(GuideLine, IsFoundAtEitherEndOfALine) {
  for (const double side : {1.0, -1.0}) {
    for (const double height : {1.3, 1.8, 2.5}) {
      const glm::dvec2 at(9, 0.5 - height);
      const std::optional<GuideLine> guide = FitGuide(Arc(at, height, side * 0.3 * height), kLine);
      ASSERT_TRUE(guide) << height;
      EXPECT_EQ(guide->bulges_right, side > 0);
      EXPECT_LT(glm::distance(guide->lower, FromEm(kLine, at)), 1e-9);
      EXPECT_LT(glm::distance(guide->upper, FromEm(kLine, {9, 0.5})), 1e-9);
    }
  }
}

// How flat guides are is not told: the least and the roundest of drawn ones.
TEST(GuideLine, MayBeFlatterOrRounder) {
  for (const double share : {0.15, 0.2, 0.4, 0.45}) {
    EXPECT_TRUE(FitGuide(Arc({9, -1.3}, 1.8, share * 1.8), kLine)) << share;
  }
}

// Half a millimetre rms over an arc, less what all of it shares.
TEST(GuideLine, IsFoundByAHandUnsureOfItsPlace) {
  EXPECT_TRUE(FitGuide(Arc({9, -1.3}, 1.8, 0.54, 0.05), kLine));
}

TEST(GuideLine, IsNoSignAndNoStraightLine) {
  std::vector<FeltPoint> ring, line;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    ring.push_back(
        {FromEm(kLine, {0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle)}), 0.5});
    line.push_back({FromEm(kLine, {0, 0.05 * i}), 0.5});
  }
  EXPECT_FALSE(FitGuide({}, kLine));
  EXPECT_FALSE(FitGuide(ring, kLine));
  EXPECT_FALSE(FitGuide(line, kLine));
  EXPECT_FALSE(FitGuide(Arc({0, 0}, 1.0, 0.3), kLine));  // as high as a sign
  // two lines' signs, one below the other
  std::vector<FeltPoint> two = ring;
  for (const FeltPoint& felt : ring) {
    two.push_back({felt.p + 1.8 * (FromEm(kLine, {0, -1}) - kLine.origin), 0.5});
  }
  EXPECT_FALSE(FitGuide(two, kLine));
}

}  // namespace
}  // namespace moontrace
