#include "lessons/guide/guidance_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;

IntendedStroke StrokeOf(std::vector<Piece> spine, double width = 0.0014) {
  IntendedStroke stroke;
  stroke.spine_P = std::move(spine);
  stroke.width = width;
  return stroke;
}

/// A line, an arc that turns left, a line, an arc that turns right: C1, 40 mm or so.
std::vector<Piece> Snake() {
  return {Line{{0, 0}, {0.01, 0}}, Arc{{0.01, 0.005}, 0.005, -kPi / 2, kPi / 2},
          Line{{0.015, 0.005}, {0.015, 0.012}}, Arc{{0.018, 0.012}, 0.003, kPi, -kPi}};
}

TEST(GuidancePath, PointsAndTangentsAreThePieces) {
  const auto path = MakeGuidancePath({StrokeOf(Snake())});
  const GuidanceStroke& stroke = path->strokes.at(0);
  EXPECT_NEAR(stroke.length, 0.01 + 0.005 * kPi / 2 + 0.007 + 0.003 * kPi, 1e-15);
  double begin = 0;
  for (const Piece& piece : Snake()) {
    for (const double share : {0.01, 0.3, 0.99}) {
      const double along = share * Length(piece);
      EXPECT_LT(glm::distance(PointAt(stroke, begin + along), PointAt(piece, along)), 1e-15);
      EXPECT_LT(glm::distance(TangentAt(stroke, begin + along), TangentAt(piece, along)), 1e-12);
    }
    begin += Length(piece);
  }
}

TEST(GuidancePath, TheNearestPointIsTheNearestOfManyWithinTheWindow) {
  const auto path = MakeGuidancePath({StrokeOf(Snake())});
  const GuidanceStroke& stroke = path->strokes.at(0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec2 p{0.03 * share(random) - 0.005, 0.03 * share(random) - 0.005};
    const double from = share(random) * stroke.length;
    const double to = from + share(random) * (stroke.length - from);
    double least = 1;
    for (int k = 0; k <= 2000; ++k) {
      least = std::min(least, glm::distance(p, PointAt(stroke, from + (to - from) * k / 2000)));
    }
    const NearestPlace place = NearestWithin(stroke, p, from, from, to);
    EXPECT_GE(place.s, from);
    EXPECT_LE(place.s, to);
    EXPECT_NEAR(place.distance, glm::distance(p, PointAt(stroke, place.s)), 1e-15);
    // a step of 21 um at most: the sampled nearest is at most 10 um along from the true one
    EXPECT_LE(place.distance, least + 1e-15);
    EXPECT_GE(place.distance, least - 11e-6);
  }
}

TEST(GuidancePath, GapsAreBridgedAndPiecesWithoutLengthLeftOut) {
  const auto path = MakeGuidancePath({StrokeOf(
      {Line{{0, 0}, {0, 0}}, Line{{0, 0}, {0.01, 0}}, Line{{0.01, 0.004}, {0.02, 0.004}}})});
  EXPECT_NEAR(path->strokes.at(0).length, 0.024, 1e-15);
  EXPECT_LT(glm::distance(PointAt(path->strokes[0], 0.012), {0.01, 0.002}), 1e-15);
}

TEST(GuidancePath, ADotHasAPlaceAndNoLength) {
  const auto path = MakeGuidancePath({StrokeOf({Line{{0.01, 0.02}, {0.01, 0.02}}})});
  const GuidanceStroke& stroke = path->strokes.at(0);
  EXPECT_EQ(stroke.length, 0);
  EXPECT_EQ(PointAt(stroke, 0), glm::dvec2(0.01, 0.02));
  EXPECT_NEAR(NearestWithin(stroke, {0.01, 0.023}, 0, 0, 1).distance, 0.003, 1e-15);
}

TEST(GuidancePath, ALettersBoxHoldsAllItsStrokes) {
  IntendedStroke stem = StrokeOf({Line{{0, 0}, {0, 0.01}}});
  IntendedStroke arm = StrokeOf({Line{{0, 0}, {0.006, 0}}});
  IntendedStroke next = StrokeOf({Line{{0.02, 0}, {0.02, 0.01}}});
  next.glyph = 1;
  const auto path = MakeGuidancePath({stem, arm, next});
  EXPECT_LT(glm::distance(path->strokes[0].letter.min, {-0.0014, -0.0014}), 1e-15);
  EXPECT_LT(glm::distance(path->strokes[0].letter.max, {0.0074, 0.0114}), 1e-15);
  EXPECT_LT(glm::distance(path->strokes[2].letter.min, {0.0186, -0.0014}), 1e-15);
}

TEST(GuidancePath, ARecordedHandIsWhereItWas) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto path = MakeRecordedPath({5, 6, 6, 6.5, 7, 9},
                                     {{0, 0, 0},
                                      {0.01, 0, 0},
                                      {0.5, 0.5, 0},  // time stands
                                      {nan, 0, 0},
                                      {0.01, 0.01, 0.002},
                                      {0.01, 0.01, 0}},
                                     0.0014);
  ASSERT_TRUE(path->recorded());
  EXPECT_LT(glm::distance(RecordedPointAt(*path, 0.5), {0.005, 0}), 1e-15);
  EXPECT_LT(glm::distance(RecordedPointAt(*path, 1.25), {0.01, 0.0025}), 1e-15);
  EXPECT_EQ(RecordedPointAt(*path, 99), glm::dvec2(0.01, 0.01));
  EXPECT_EQ(RecordedPointAt(*path, -1), glm::dvec2(0, 0));
  EXPECT_NEAR(path->strokes.at(0).length, 0.02, 1e-15);
}

TEST(GuidancePath, NothingRecordedIsNoStroke) {
  EXPECT_TRUE(MakeRecordedPath({}, {}, 0.0014)->strokes.empty());
  EXPECT_TRUE(MakeGuidancePath({})->strokes.empty());
}

}  // namespace
}  // namespace moontrace
