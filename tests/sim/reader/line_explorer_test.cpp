#include "sim/reader/line_explorer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <vector>

namespace moontrace {
namespace {

constexpr double kSize = 0.010, kDepth = 0.001, kPress = 0.5, kTick = 0.001;

/// How deep one lies at a place, share of kDepth.
using Paper = std::function<double(glm::dvec2)>;

/// Upright bars from the line's upper edge to its lower one, so many sizes from its beginning.
Paper Bars(const std::vector<double>& at, double half_width = 0.07) {
  return [at, half_width](glm::dvec2 p) {
    const auto near = [&](double x) { return std::abs(p.x - x * kSize) < half_width * kSize; };
    const bool high = p.y < 0 && p.y > -kSize;
    return high && std::any_of(at.begin(), at.end(), near) ? 1.0 : 0.0;
  };
}

/// A hand that is where it wants to be, at once, and feels it 0.1 s late.
struct Explored {
  ReaderKnowledge knowledge;
  LineExploration how;
  std::vector<glm::dvec2> felt;   ///< on the paper
  std::vector<glm::dvec2> inked;  ///< of that, in grooves
  double seconds = 0;
  bool ended = false;

  Explored() {
    knowledge.width = 0.001;
    knowledge.depth = kDepth;
    knowledge.space = 0.6;
    knowledge.greatest_size = knowledge.least_size = kSize;
    knowledge.press = kPress;
    knowledge.hand_mass = 0.1;
    knowledge.hand_stiffness = 200;
    knowledge.delay = 0.1;
    knowledge.device_stiffness = 1e9;
    how.size = how.height = kSize;
    how.margin = 0.15 * kSize;
    how.spacing = 0.1 * kSize;
    how.speed = 0.05;
  }

  void Over(const Paper& paper, bool carries = true) {
    LineExplorer explorer(knowledge, how, kTick);
    const std::size_t late = 100;
    std::vector<ReaderInput> way(late, {0, {0, 0, 0.005}, {0, 0, 0}});
    ReaderAction action{{0, 0, 0.005}, 0};
    for (std::size_t n = 0; n < 200000 && !explorer.done(); ++n) {
      ReaderInput now;
      const double depth = paper(glm::dvec2(action.aim));
      const bool pressed = action.press > 0;
      now.tip = {action.aim.x, action.aim.y, pressed ? -depth * kDepth : action.aim.z};
      // a groove that the tip falls into does not carry it
      now.force.z = pressed && (carries || depth == 0) ? action.press : 0;
      way.push_back(now);
      ReaderInput input = way[n];
      input.time = static_cast<double>(n) * kTick;
      action = explorer.Step(input);
      seconds = input.time;
      if (!explorer.feels()) continue;
      felt.push_back(explorer.place());
      if (explorer.depth() > 0.5) inked.push_back(explorer.place());
    }
    ended = explorer.done();
  }
  /// Whether something was felt so near, in sizes.
  bool FeltNear(glm::dvec2 at, double within) const {
    return std::any_of(felt.begin(), felt.end(),
                       [&](glm::dvec2 p) { return glm::distance(p, at * kSize) < within * kSize; });
  }
  double Right(const std::vector<glm::dvec2>& places) const {
    double right = -1;
    for (const glm::dvec2 p : places) right = std::max(right, p.x / kSize);
    return right;
  }
};

// Sweeps lie 0.1 sizes apart: no place between them is farther than half of that, and some for the
// aim's wave from one to the next.
TEST(LineExplorer, GoesOverAllOfASignToItsEdges) {
  Explored explored;
  explored.Over(Bars({0.2, 1.1}));
  EXPECT_TRUE(explored.ended);
  for (double x = 0; x <= 1.1; x += 0.1) {
    for (double y = -1; y <= 0; y += 0.1) {
      EXPECT_TRUE(explored.FeltNear({x, y}, 0.075)) << x << " " << y;
    }
  }
}

TEST(LineExplorer, EndsSoonAfterTheLastSign) {
  Explored of_one, of_three;
  of_one.Over(Bars({0.2}));
  of_three.Over(Bars({0.2, 0.6, 1.0}));
  EXPECT_TRUE(of_one.ended && of_three.ended);
  // beyond the last: a space of 0.6 and room beside a sign, and a slant more
  EXPECT_LT(of_one.Right(of_one.felt), 0.2 + 0.6 + 1.7);
  EXPECT_LT(of_three.Right(of_three.felt), 1.0 + 0.6 + 1.7);
  EXPECT_GT(of_three.seconds, of_one.seconds);
}

TEST(LineExplorer, FindsWhatFollowsBeyondASpace) {
  Explored explored;
  explored.Over(Bars({0.2, 1.5, 2.8}));  // gaps of 1.3: the space, and room beside thin signs
  EXPECT_NEAR(explored.Right(explored.inked), 2.8, 0.08);
  // all of the last as well
  for (double y = -1; y <= 0; y += 0.1) EXPECT_TRUE(explored.FeltNear({2.8, y}, 0.075)) << y;
}

// Columns lie 0.15, 0.05, ... sizes left of the hand's corner and every 0.1 to the right.
TEST(LineExplorer, FindsAThinStrokeBetweenItsColumns) {
  Explored explored;
  explored.Over(Bars({0.2}, 0.03));
  EXPECT_NEAR(explored.Right(explored.inked), 0.2, 0.04);
}

TEST(LineExplorer, GivesUpOnBlankPaper) {
  Explored explored;
  explored.Over(Bars({}));
  EXPECT_TRUE(explored.ended);
  EXPECT_TRUE(explored.inked.empty());
  EXPECT_LT(explored.Right(explored.felt), 3);
}

TEST(LineExplorer, FeelsAGrooveThatItsTipFallsInto) {
  Explored explored;
  explored.Over(Bars({0.2, 0.6}), false);
  EXPECT_NEAR(explored.Right(explored.inked), 0.6, 0.08);
}

TEST(LineExplorer, DoesTheSameForTheSameFeelings) {
  Explored a, b;
  a.Over(Bars({0.2, 0.9}));
  b.Over(Bars({0.2, 0.9}));
  EXPECT_EQ(a.felt, b.felt);
}

}  // namespace
}  // namespace moontrace
