#include "sim/reader/link_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

// of a table of 33 cells an em, each told by its middle, in steps of a 255th of the farthest
constexpr double kCell = 0.5 * 1.4143 / 33 + LinkShapes::kFarthest / 255;

/// From (1, 0) to (2, 0), as deep as letters over its first fifth.
LinkWay Straight() {
  LinkWay way;
  for (int i = 0; i <= 100; ++i) {
    way.all.emplace_back(1 + 0.01 * i, 0);
    if (i <= 20) way.deep.emplace_back(1 + 0.01 * i, 0);
  }
  return way;
}

double ToSegment(glm::dvec2 p, double from, double to) {
  return std::min(LinkShapes::kFarthest, std::hypot(p.x - std::clamp(p.x, from, to), p.y));
}

TEST(LinkShapes, TellsHowFarAPlaceIsFromALink) {
  const LinkShapes::Link link(Straight());
  ASSERT_TRUE(link.exists());
  for (double x = 0.5; x < 2.5; x += 0.07) {
    for (double y = -0.4; y < 0.4; y += 0.05) {
      EXPECT_NEAR(link.Distance({x, y}), ToSegment({x, y}, 1, 2), kCell) << x << " " << y;
      EXPECT_NEAR(link.DistanceToDeep({x, y}), ToSegment({x, y}, 1, 1.2), kCell) << x << " " << y;
    }
  }
}

TEST(LinkShapes, ItsSpansHoldAllThatIsNearIt) {
  const LinkShapes::Link link(Straight());
  const auto holds = [](const LinkShapes::Spans& spans, glm::dvec2 p) {
    const int row = LinkShapes::RowOf(p.y);
    if (row < spans.first || row > spans.last()) return false;
    return p.x >= spans.At(row).from && p.x < spans.At(row).to;
  };
  int beyond = 0;
  for (double x = 0.5; x < 2.5; x += 0.013) {
    for (double y = -0.5; y < 0.5; y += 0.017) {
      const glm::dvec2 p{x, y};
      const double all = link.Distance(p), deep = link.DistanceToDeep(p);
      EXPECT_TRUE(all >= LinkShapes::kFarthest || holds(link.spans(), p)) << x << " " << y;
      EXPECT_TRUE(all >= LinkShapes::kNear || holds(link.near_spans(), p)) << x << " " << y;
      EXPECT_TRUE(deep >= LinkShapes::kFarthest || holds(link.deep_spans(), p)) << x << " " << y;
      if (!holds(link.near_spans(), p)) ++beyond;
    }
  }
  EXPECT_GT(beyond, 154 * 59 / 2);  // of so many; they are no trivial bounds
}

TEST(LinkShapes, OfNoLinkEverythingIsFar) {
  const LinkShapes::Link none{LinkWay{}};
  EXPECT_FALSE(none.exists());
  EXPECT_EQ(none.Distance({0, 0}), LinkShapes::kFarthest);
  EXPECT_EQ(none.DistanceToDeep({1, 0}), LinkShapes::kFarthest);
}

TEST(LinkShapes, HasALinkForEachPairInOrder) {
  const auto next = [](std::size_t a, std::size_t b) {
    return a == 0 && b == 1 ? Straight() : LinkWay{};
  };
  const auto within = [](std::size_t sign) { return sign == 1 ? Straight() : LinkWay{}; };
  const LinkShapes letters(2, next, nullptr, within);
  EXPECT_TRUE(letters.Next(0, 1).exists());
  EXPECT_FALSE(letters.Next(1, 0).exists());
  EXPECT_TRUE(letters.Within(1).exists());
  EXPECT_FALSE(letters.Within(0).exists());
  EXPECT_FALSE(letters.LinksWords());
  const LinkShapes words(2, next, next, within);
  ASSERT_TRUE(words.LinksWords());
  EXPECT_TRUE(words.Across(0, 1).exists());
}

}  // namespace
}  // namespace moontrace
