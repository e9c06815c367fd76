#include "textures/relief/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "textures/base/units.h"

namespace moontrace {
namespace {

/// A line or an arc of any sweep up to a whole turn, in a square of 2 m.
Piece AnyPiece(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-1, 1);
  const glm::dvec2 p(place(random), place(random));
  if (random() % 2 == 0) return Line{p, {place(random), place(random)}};
  return Arc{p, 0.1 + std::abs(place(random)), 3 * place(random), kTurn * place(random)};
}

TEST(DistanceBetweenCurves, IsThatOfTheirNearestPoints) {
  std::mt19937_64 random(7);
  constexpr int kSteps = 4000;
  for (int n = 0; n < 300; ++n) {
    const Piece a = AnyPiece(random), b = AnyPiece(random);
    const double length = Length(a), step = length / kSteps;
    double sampled = 9;
    for (int i = 0; i <= kSteps; ++i)
      sampled = std::min(sampled, DistanceTo(b, PointAt(a, i * step)));
    const double exact = DistanceBetween(CurveOf(a), CurveOf(b));
    EXPECT_LE(exact, sampled + 1e-12) << n;
    EXPECT_GE(exact, sampled - step / 2 - 1e-12) << n;  // the nearest point lies between two
    EXPECT_NEAR(exact, DistanceBetween(CurveOf(b), CurveOf(a)), 1e-12) << n;
  }
}

TEST(DistanceToCurve, IsThatToThePiece) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> place(-2, 2);
  for (int n = 0; n < 1000; ++n) {
    const Piece piece = AnyPiece(random);
    const glm::dvec2 p(place(random), place(random));
    EXPECT_NEAR(DistanceTo(CurveOf(piece), p), DistanceTo(piece, p), 1e-12);
  }
}

TEST(CurveOfPiece, HasItsBoundsAndDirections) {
  std::mt19937_64 random(9);
  for (int n = 0; n < 1000; ++n) {
    const Piece piece = AnyPiece(random);
    const Curve curve = CurveOf(piece);
    EXPECT_NEAR(glm::distance(curve.box.min, BoundsOf(piece).min), 0, 1e-12);
    EXPECT_NEAR(glm::distance(curve.box.max, BoundsOf(piece).max), 0, 1e-12);
    EXPECT_GT(glm::dot(WayAtStart(curve), TangentAt(piece, 0)), 1 - 1e-12);
    EXPECT_GT(glm::dot(WayAtEnd(curve), TangentAt(piece, Length(piece))), 1 - 1e-12);
  }
}

}  // namespace
}  // namespace moontrace
