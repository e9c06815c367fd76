#include "textures/fonts/arc_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <random>
#include <vector>

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;

/// De Casteljau's construction: another way to the curve's points than the code's polynomial.
glm::dvec2 Casteljau(std::vector<glm::dvec2> p, double t) {
  for (std::size_t n = p.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) p[i] += t * (p[i + 1] - p[i]);
  }
  return p[0];
}

/// Points of an arc or line by their plain definition.
glm::dvec2 At(const Piece& piece, double share) {
  if (const Line* line = std::get_if<Line>(&piece)) {
    return line->from + share * (line->to - line->from);
  }
  const Arc& arc = std::get<Arc>(piece);
  const double angle = arc.start + share * arc.sweep;
  return arc.center + arc.radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

std::vector<glm::dvec2> Sampled(const std::vector<Piece>& pieces, int count) {
  std::vector<glm::dvec2> points;
  for (const Piece& piece : pieces) {
    for (int i = 0; i <= count; ++i) points.push_back(At(piece, double(i) / count));
  }
  return points;
}

/// Greatest distance of points of `a` from the polyline through `b`.
double Deviation(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  double greatest = 0;
  for (const glm::dvec2 p : a) {
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < b.size(); ++i) {
      const glm::dvec2 d = b[i + 1] - b[i];
      const double t = glm::dot(d, d) > 0 ? glm::dot(p - b[i], d) / glm::dot(d, d) : 0;
      nearest = std::min(nearest, glm::length(p - b[i] - std::clamp(t, 0.0, 1.0) * d));
    }
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

/// Both ways, in the unit of the control points. 500 chords err by |P''|/8 500^2 < 1e-5, 100 chords
/// of an arc by less than 2e-5: a fiftieth of the tolerance.
double DeviationFromCubic(const std::vector<Piece>& pieces,
                          const std::vector<glm::dvec2>& control) {
  std::vector<glm::dvec2> curve;
  for (int i = 0; i <= 500; ++i) curve.push_back(Casteljau(control, i / 500.0));
  const std::vector<glm::dvec2> fitted = Sampled(pieces, 100);
  return std::max(Deviation(curve, fitted), Deviation(fitted, curve));
}

std::vector<Piece> Fit(const std::vector<glm::dvec2>& p, double tolerance) {
  return FitArcs(CubicCurve(p[0], p[1], p[2], p[3]), tolerance);
}

TEST(FitArcs, StaysWithinTheToleranceOfRandomCubics) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for (int i = 0; i < 20; ++i) {
    std::vector<glm::dvec2> control;
    for (int k = 0; k < 4; ++k) {
      const double x = coordinate(random);
      control.emplace_back(x, coordinate(random));
    }
    const std::vector<Piece> pieces = Fit(control, 0.001);
    EXPECT_LE(DeviationFromCubic(pieces, control), 0.001) << "curve " << i;
    EXPECT_LT(pieces.size(), 80U) << "curve " << i;
  }
}

TEST(FitArcs, FollowsLoopsCuspsStraightsAndDoubledControlPoints) {
  const std::vector<std::vector<glm::dvec2>> curves = {
      {{0, 0}, {1.5, 1}, {-0.5, 1}, {1, 0}},   // loop
      {{0, 0}, {1, 1}, {0, 1}, {1, 0}},        // cusp at t = 1/2
      {{0, 0}, {1.1, 0.9}, {0, 1}, {1, 0.1}},  // nearly a cusp
      {{0, 0}, {0, 0}, {1, 1}, {1, 0}},        // no derivative at the start
      {{0, 0}, {0, 1}, {1, 0}, {1, 0}},        // nor at the end
      {{0, 0}, {0, 0}, {1, 0.5}, {1, 0.5}},    // straight, doubled
      {{0, 0}, {2, 0}, {-1, 0}, {1, 0}},       // runs back on itself
      {{0, 0}, {1, 1}, {-1, 1}, {0, 0}},       // closed
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::vector<Piece> pieces = Fit(curves[i], 0.001);
    EXPECT_LE(DeviationFromCubic(pieces, curves[i]), 0.001) << "curve " << i;
  }
}

TEST(FitArcs, GivesNothingForAPoint) {
  EXPECT_TRUE(Fit({{1, 2}, {1, 2}, {1, 2}, {1, 2}}, 0.001).empty());
}

TEST(FitArcs, JoinsItsPiecesEndToEndWithoutAKink) {
  const std::vector<Piece> pieces = Fit({{0, 0}, {0.2, 1.2}, {0.9, -0.8}, {1, 0.6}}, 0.001);
  ASSERT_GT(pieces.size(), 2U);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    EXPECT_LT(glm::length(At(pieces[i], 1) - At(pieces[i + 1], 0)), 1e-9);
    // Chords over a thousandth of each piece; arcs here turn by less than 1 rad each.
    const glm::dvec2 before = glm::normalize(At(pieces[i], 1) - At(pieces[i], 0.999));
    const glm::dvec2 after = glm::normalize(At(pieces[i + 1], 0.001) - At(pieces[i + 1], 0));
    EXPECT_GT(glm::dot(before, after), std::cos(0.005));
  }
}

TEST(ArcByTangent, IsTheQuarterCircleForAQuarterTurn) {
  const Piece piece = ArcByTangent({1, 0}, {0, 1}, {0, 1}, 1e-6);
  const Arc& arc = std::get<Arc>(piece);
  EXPECT_NEAR(arc.center.x, 0, 1e-12);
  EXPECT_NEAR(arc.center.y, 0, 1e-12);
  EXPECT_NEAR(arc.radius, 1, 1e-12);
  EXPECT_NEAR(arc.sweep, kPi / 2, 1e-12);
}

TEST(MergePieces, MakesOneCircleOfTwoHalves) {
  const std::vector<Piece> merged = MergePieces(
      {Arc{{0.5, 0.5}, 0.5, kPi / 2, kPi}, Arc{{0.5, 0.5}, 0.5, 3 * kPi / 2, kPi}}, 1e-6);
  ASSERT_EQ(merged.size(), 1U);
  EXPECT_EQ(std::get<Arc>(merged[0]), (Arc{{0.5, 0.5}, 0.5, kPi / 2, 2 * kPi}));
}

TEST(MergePieces, MakesOneCircleOfFourFittedCubics) {
  // The usual four Bezier quarters err by 2.7e-4 of the radius.
  constexpr double k = 0.5522847498;
  std::vector<Piece> pieces;
  const glm::dvec2 corner[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 a = corner[i], b = corner[i + 1];
    for (const Piece& piece : Fit({a, a + k * b, b + k * a, b}, 5e-4)) pieces.push_back(piece);
  }
  const std::vector<Piece> merged = MergePieces(pieces, 4e-4);
  ASSERT_EQ(merged.size(), 1U);
  EXPECT_NEAR(std::get<Arc>(merged[0]).sweep, 2 * kPi, 1e-12);
  EXPECT_NEAR(std::get<Arc>(merged[0]).radius, 1, 4e-4);
  EXPECT_NEAR(glm::length(std::get<Arc>(merged[0]).center), 0, 4e-4);
}

TEST(MergePieces, JoinsCollinearLinesButKeepsCornersAndReturns) {
  const std::vector<Piece> corner = {Line{{0, 0}, {1, 0}}, Line{{1, 0}, {2, 0}},
                                     Line{{2, 0}, {2, 1}}};
  const std::vector<Piece> merged = MergePieces(corner, 1e-6);
  ASSERT_EQ(merged.size(), 2U);
  EXPECT_EQ(std::get<Line>(merged[0]), (Line{{0, 0}, {2, 0}}));
  EXPECT_EQ(MergePieces({Line{{0, 0}, {1, 0}}, Line{{1, 0}, {0.5, 0}}}, 1e-6).size(), 2U);
}

TEST(MergePieces, KeepsArcsOfUnlikeCirclesAndOfUnlikeSense) {
  // Moon's cup: radii 1.25 and 0.4 that join without a kink.
  const double angle = std::atan2(0.4, 0.75);
  EXPECT_EQ(MergePieces({Arc{{0.8, -0.25}, 1.25, kPi / 2, angle},
                         Arc{{0.4, 0.5}, 0.4, kPi / 2 + angle, kPi - 2 * angle}},
                        1e-3)
                .size(),
            2U);
  EXPECT_EQ(MergePieces({Arc{{0, 0}, 1, 0, 1}, Arc{{0, 0}, 1, 1, -1}}, 1e-3).size(), 2U);
  EXPECT_EQ(MergePieces({Arc{{0, 0}, 1, 0, 2 * kPi}, Arc{{0, 0}, 1, 0, 1}}, 1e-3).size(), 2U);
}

}  // namespace
}  // namespace moontrace
