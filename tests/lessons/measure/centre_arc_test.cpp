#include "lessons/measure/centre_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;

/// H's crescent in the reference: upper tip (0.345, 0.845), lower (0.345, 0.155); at half height it
/// reaches from x = 0 to x = 0.204, so the middle is (0.102, 0.5).
void ExpectCentreOfH(const std::vector<Piece>& arcs) {
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_NEAR(glm::length(StartOf(arcs[0]) - glm::dvec2(0.345, 0.845)), 0, 1e-12);
  EXPECT_NEAR(glm::length(EndOf(arcs[0]) - glm::dvec2(0.345, 0.155)), 0, 1e-12);
  const glm::dvec2 middle = PointAt(arcs[0], Length(arcs[0]) / 2);
  EXPECT_NEAR(glm::length(middle - glm::dvec2(0.102, 0.5)), 0, 1e-12);
  const Arc& arc = std::get<Arc>(arcs[0]);
  // Radius from chord 2c = 0.69 and sagitta g = 0.243: (c^2 + g^2) / 2g.
  EXPECT_NEAR(arc.radius, (0.345 * 0.345 + 0.243 * 0.243) / (2 * 0.243), 1e-12);
  EXPECT_GT(arc.sweep, 0);  // down the left side: counter-clockwise
}

TEST(CentreArc, OfACrescentRunsThroughTipsAndMiddle) {
  const Arc outer{{0.345, 0.5}, 0.345, 90 * kDegree, 180 * kDegree};
  // Inner side through (0.204, 0.5), meeting the outer one in its tips.
  const double sagitta = 0.345 - 0.204, radius = (0.345 * 0.345 / sagitta + sagitta) / 2;
  const glm::dvec2 center(0.204 + radius, 0.5);
  const double half = std::asin(0.345 / radius);
  ExpectCentreOfH(CentreArc({outer, Arc{center, radius, kPi + half, -2 * half}}, 0));
}

TEST(CentreArc, TakesTheOuterTipsOfACrescentWithCutEnds) {
  // As the reference draws it: an inner arc of 127.83 to 232.17 degrees, joined by short lines.
  const double rise = std::sqrt(0.364 * 0.364 - 0.223 * 0.223);  // at x = 0.345
  const Arc outer{{0.345, 0.5}, 0.345, 90 * kDegree, 180 * kDegree};
  const double half = std::acos(0.223 / 0.364);
  ExpectCentreOfH(CentreArc(
      {outer, Line{{0.345, 0.155}, {0.345, 0.5 - rise}},
       Arc{{0.568, 0.5}, 0.364, kPi + half, -2 * half}, Line{{0.345, 0.5 + rise}, {0.345, 0.845}}},
      0));
}

TEST(CentreArc, OfACircleIsItsCentre) {
  const auto whole = CentreArc({Arc{{1, 2}, 0.1, 0, 2 * kPi}}, 0.1);
  const auto halves = CentreArc({Arc{{1, 2}, 0.1, 0, kPi}, Arc{{1, 2}, 0.1, kPi, kPi}}, 0.1);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(std::get<Line>(whole[0]), (Line{{1, 2}, {1, 2}}));
  EXPECT_EQ(whole, halves);
}

/// Two arcs of radius 1 through (0, 0) and (1, 0), one bulging up and one down.
std::vector<Piece> Lens() {
  const double half = std::asin(0.5), back = std::cos(half);
  return {Arc{{0.5, -back}, 1, kPi / 2 + half, -2 * half},
          Arc{{0.5, back}, 1, -kPi / 2 + half, -2 * half}};
}

void ExpectLine(const std::vector<Piece>& pieces, glm::dvec2 from, glm::dvec2 to) {
  ASSERT_EQ(pieces.size(), 1u);
  const Line& line = std::get<Line>(pieces[0]);
  EXPECT_NEAR(glm::length(line.from - from), 0, 1e-12);
  EXPECT_NEAR(glm::length(line.to - to), 0, 1e-12);
}

TEST(CentreArc, OfALensIsTheStraightLineBetweenItsTips) {
  ExpectLine(CentreArc(Lens(), 0), {0, 0}, {1, 0});  // level tips: from the left
}

TEST(CentreArc, EndsWhereTheFillHasItsFullDepth) {
  // At (0.5 + x, 0) a lens is 1 - sqrt(x^2 + 3/4) deep.
  const double rim = 0.05, x = std::sqrt((1 - rim) * (1 - rim) - 0.75);
  ExpectLine(CentreArc(Lens(), rim), {0.5 - x, 0}, {0.5 + x, 0});
  const double middle = 1 - std::sqrt(0.75), depth = 0.9 * middle;
  const double narrow = std::sqrt((1 - depth) * (1 - depth) - 0.75);
  ExpectLine(CentreArc(Lens(), 2 * middle), {0.5 - narrow, 0}, {0.5 + narrow, 0});
}

}  // namespace
}  // namespace moontrace
