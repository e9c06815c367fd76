#include "lessons/measure/spine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

namespace moontrace {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The letter N of the reference: lines and arcs both ways round.
std::vector<Piece> LetterN() {
  return {Line{{0, 0}, {0, 0.698}}, Arc{{0.125, 0.698}, 0.125, kPi, -0.75 * kPi},
          Line{{0.213, 0.787}, {0.787, 0.213}}, Arc{{0.875, 0.302}, 0.125, 1.25 * kPi, 0.75 * kPi},
          Line{{1, 0.302}, {1, 1}}};
}

/// What lies within `radius`, by looking at points `step` apart.
double WithinByStepping(const std::vector<Piece>& pieces, glm::dvec2 p, double radius,
                        double step) {
  double total = 0;
  for (const Piece& piece : pieces) {
    const int count = static_cast<int>(std::ceil(Length(piece) / step));
    const double width = Length(piece) / count;
    for (int i = 0; i < count; ++i) {
      if (glm::length(PointAt(piece, (i + 0.5) * width) - p) < radius) total += width;
    }
  }
  return total;
}

void ExpectAgrees(const std::vector<Piece>& pieces, unsigned seed) {
  const Spine spine(pieces);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.3, 1.3);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec2 p(place(random), place(random));
    const double radius = 0.05 + 0.2 * (i % 3);
    CoveredLength covered(4);
    double nearest = 1e300;
    for (const Piece& piece : pieces) nearest = std::min(nearest, DistanceTo(piece, p));
    EXPECT_NEAR(spine.Cover(p, radius, covered), nearest, 1e-13);
    // Stepping errs by at most one step at each end of at most four stretches.
    EXPECT_NEAR(covered.Total(), WithinByStepping(pieces, p, radius, 1e-4), 8e-4) << p.x << p.y;
  }
}

TEST(Spine, FindsDistanceAndNearPartsOfLinesAndArcs) { ExpectAgrees(LetterN(), 1); }

TEST(Spine, FindsDistanceAndNearPartsOfRings) {
  ExpectAgrees({Arc{{0.5, 0.5}, 0.5, 0.5 * kPi, 2 * kPi}}, 2);
  ExpectAgrees({Arc{{0.5, 0.5}, 0.5, -3.0, -2 * kPi}}, 3);
}

TEST(Spine, CoversAWholeRingFromItsCentre) {
  const Spine ring({Arc{{1, 2}, 0.5, 0.3, 2 * kPi}});
  CoveredLength covered(4);
  EXPECT_EQ(ring.Cover({1, 2}, 0.51, covered), 0.5);
  EXPECT_NEAR(covered.Total(), kPi, 1e-15);
}

TEST(Spine, OfAPointIsTheDistanceToIt) {
  const Spine point({Line{{1, 1}, {1, 1}}});
  CoveredLength covered(4);
  EXPECT_EQ(point.length(), 0);
  EXPECT_DOUBLE_EQ(point.Cover({4, 5}, 10, covered), 5);
}

TEST(Spine, KnowsItsWayAndOnWhichSideAPointLies) {
  const std::vector<Piece> pieces = LetterN();
  const Spine spine(pieces);
  for (const Piece& piece : pieces) {
    for (const double share : {0.1, 0.4, 0.9}) {
      const glm::dvec2 along = TangentAt(piece, share * Length(piece));
      for (const double d : {-0.02, 0.015}) {
        const glm::dvec2 left(-along.y, along.x);
        const Spine::Foot foot = spine.FootOf(PointAt(piece, share * Length(piece)) + d * left);
        EXPECT_NEAR(foot.aside, d, 1e-14);
        EXPECT_NEAR(glm::distance(foot.tangent, along), 0, 1e-14);
      }
    }
  }
  // Beyond an end there is no side.
  EXPECT_NEAR(spine.FootOf({0, -0.3}).aside, 0, 1e-15);
}

TEST(CoveredLength, CountsNothingTwice) {
  CoveredLength covered(4);
  EXPECT_EQ(covered.Total(), 0);
  covered.Add(1, 3);
  covered.Add(2, 4);
  covered.Add(1.5, 2.5);
  covered.Add(1, 3);
  EXPECT_EQ(covered.Total(), 3);
}

TEST(CoveredLength, JoinsWhatANewIntervalBridges) {
  CoveredLength covered(4);
  covered.Add(6, 7);
  covered.Add(0, 1);
  covered.Add(2, 3);
  covered.Add(4, 5);
  EXPECT_EQ(covered.Total(), 4);
  covered.Add(0.5, 4.5);  // bridges the first three
  EXPECT_EQ(covered.Total(), 6);
  covered.Add(5, 6);  // touches both neighbours
  EXPECT_EQ(covered.Total(), 7);
}

TEST(CoveredLength, IgnoresIntervalsTurnedRound) {
  CoveredLength covered(4);
  covered.Add(2, 1);
  EXPECT_EQ(covered.Total(), 0);
}

// Against cells ticked one by one; all numbers are whole, so sums are exact.
TEST(CoveredLength, AgreesWithTickingCells) {
  std::uint32_t state = 1;
  const auto next = [&] { return (state = state * 1664525u + 1013904223u) >> 16; };
  for (int round = 0; round < 200; ++round) {
    CoveredLength covered(1);
    std::vector<bool> cells(1000, false);
    for (int i = 0; i < 30; ++i) {
      const unsigned begin = next() % 980, end = begin + next() % 20;
      covered.Add(begin, end);
      for (unsigned cell = begin; cell < end; ++cell) cells[cell] = true;
    }
    int ticked = 0;
    for (const bool cell : cells) ticked += cell ? 1 : 0;
    ASSERT_EQ(covered.Total(), ticked);
  }
}

}  // namespace
}  // namespace moontrace
