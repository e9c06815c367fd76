#include "lessons/measure/recogniser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace moontrace {
namespace {

using Polyline = std::vector<glm::dvec2>;

/// In units of the letter's size, as Moon draws them.
const Polyline kEll = {{0, 1}, {0, 0}, {0.9, 0}};
const Polyline kYe = {{0, 0}, {0.9, 0}, {0.9, 1}};  // its mirror mate
const Polyline kVee = {{0, 1}, {0.5, 0}, {1, 1}};

double DistanceTo(const Polyline& line, glm::dvec2 p) {
  double nearest = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const glm::dvec2 along = line[i] - line[i - 1];
    const double s =
        std::clamp(glm::dot(p - line[i - 1], along) / glm::dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(p, line[i - 1] + s * along));
  }
  return nearest;
}

/// What sweeps across a box would feel where grooves of a tenth of the size lie along the lines.
FeltLine Feel(const std::vector<Polyline>& lines, double size, glm::dvec2 origin = {0, 0},
              double width_in_sizes = 1.0) {
  FeltLine felt;
  felt.bottom = origin.y - 0.2 * size;
  felt.top = origin.y + 1.2 * size;
  const auto touch = [&](glm::dvec2 p) {
    double nearest = 1e9;
    for (const Polyline& line : lines) nearest = std::min(nearest, DistanceTo(line, p));
    felt.samples.push_back({origin + size * p, nearest < 0.06 ? 1.0 : 0.0});
  };
  const double right = width_in_sizes + 0.2;
  for (int i = 0; i * 0.1 - 0.2 <= right; ++i) {
    for (int k = 0; k <= 140; ++k) touch({0.1 * i - 0.2, -0.2 + 0.01 * (i % 2 ? 140 - k : k)});
  }
  for (int i = 0; i <= 14; ++i) {
    const int n = static_cast<int>((right + 0.2) / 0.01);
    for (int k = 0; k <= n; ++k) touch({-0.2 + 0.01 * (i % 2 ? n - k : k), 0.1 * i - 0.2});
  }
  return felt;
}

Polyline Moved(Polyline line, glm::dvec2 by) {
  for (glm::dvec2& p : line) p += by;
  return line;
}

class TaughtRecogniser : public ::testing::Test {
 protected:
  void SetUp() override {
    recogniser_.Remember("l", ShapeOf(Feel({kEll}, 0.04), {}), 0);
    recogniser_.Remember("y", ShapeOf(Feel({kYe}, 0.04), {}), 0);
  }
  Recogniser recogniser_;
};

TEST_F(TaughtRecogniser, NamesWhatItWasToldAtAnotherSizeAndPlace) {
  const Naming l = recogniser_.Name(ShapeOf(Feel({kEll}, 0.009, {0.3, -0.1}), {}), 0, 0);
  EXPECT_EQ(l.label, "l");
  EXPECT_GT(l.confidence, 0.5);
  EXPECT_EQ(recogniser_.Name(ShapeOf(Feel({kYe}, 0.009), {}), 0, 0).label, "y");
}

TEST_F(TaughtRecogniser, CannotNameWhatItWasNeverTold) {
  const Naming vee = recogniser_.Name(ShapeOf(Feel({kVee}, 0.04), {}), 0, 0);
  EXPECT_TRUE(vee.label == "l" || vee.label == "y") << vee.label;
}

TEST_F(TaughtRecogniser, GuessesWhereNothingGaveWay) {
  const FeltShape blank = ShapeOf(Feel({}, 0.04), {});
  EXPECT_TRUE(blank.empty());
  EXPECT_EQ(recogniser_.Name(blank, 0, 0).label, "l");
  EXPECT_EQ(recogniser_.Name(blank, 0, 1).label, "y");
  EXPECT_EQ(recogniser_.Name(blank, 0, 1).confidence, 0);
}

TEST_F(TaughtRecogniser, SpellsOutAWordThatItWasNotTold) {
  const auto word = Feel({kEll, Moved(kYe, {1.6, 0})}, 0.02, {0, 0}, 2.6);
  EXPECT_EQ(recogniser_.Name(ShapeOf(word, {}), 0, 0).label, "ly");
}

TEST_F(TaughtRecogniser, PicksTheNearerOfTwo) {
  const FeltShape shape = ShapeOf(Feel({kYe}, 0.012), {});
  EXPECT_EQ(recogniser_.Pick(shape, "l", "y", 0, 0).label, "y");
  EXPECT_EQ(recogniser_.Pick(shape, "l", "q", 0, 0).label, "l");
}

TEST_F(TaughtRecogniser, IsLessSureAfterAYear) {
  const FeltShape shape = ShapeOf(Feel({kEll}, 0.012), {});
  EXPECT_LT(recogniser_.Name(shape, 365, 0).confidence, recogniser_.Name(shape, 0, 0).confidence);
}

TEST_F(TaughtRecogniser, TellsSameFromDifferent) {
  const auto pair = [](const Polyline& a, const Polyline& b) {
    return ShapeOf(Feel({a, Moved(b, {1.6, 0})}, 0.02, {0, 0}, 2.6), {});
  };
  EXPECT_TRUE(recogniser_.AreSame(pair(kEll, kEll), 0, 0));
  EXPECT_FALSE(recogniser_.AreSame(pair(kEll, kYe), 0, 0));
}

TEST(Recogniser, KnowsNothingAtFirst) {
  EXPECT_EQ(Recogniser().Name(ShapeOf(Feel({kEll}, 0.04), {}), 0, 3).label, "");
}

TEST(FeltShape, HasNeitherPlaceNorSize) {
  const FeltShape large = ShapeOf(Feel({kVee}, 0.04), {});
  const FeltShape small = ShapeOf(Feel({kVee}, 0.01, {0.2, 0.1}), {});
  ASSERT_EQ(large.size(), 1u);
  ASSERT_EQ(small.size(), 1u);
  double likeness = 0;  // of pictures of length 1: their cosine; samples on cell borders may stray
  for (std::size_t i = 0; i < large[0].picture.size(); ++i) {
    likeness += static_cast<double>(large[0].picture[i] * small[0].picture[i]);
  }
  EXPECT_GT(likeness, 0.99);
}

TEST(FeltShape, OutlastsSamplesThatAreNoNumbers) {
  FeltLine felt = Feel({kVee}, 0.04);
  felt.samples[100].place.x = NAN;
  felt.samples[150].place.y = NAN;
  felt.samples[200].depth = INFINITY;
  EXPECT_EQ(ShapeOf(felt, {}).size(), 1u);
  EXPECT_TRUE(ShapeOf({}, {}).empty());
}

}  // namespace
}  // namespace moontrace
