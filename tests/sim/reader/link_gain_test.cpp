#include "sim/reader/link_gain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "textures/base/random.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

class LinkGainsTest : public testing::Test {
 protected:
  LinkGainsTest() {
    line.weight = 0.6;
    line.worth = 5;
    line.spread = 0.08;
    line.cost = 4;
    line.inner = 0.05;
  }
  double Of(const std::vector<glm::dvec2>& ink, const std::vector<glm::dvec2>& flat,
            const std::vector<glm::dvec2>& of_links) const {
    return LinkGains(shapes, line, ByX(ink), ByX(flat), ByX(of_links)).Of(link, pair);
  }
  static std::vector<glm::dvec2> ByX(std::vector<glm::dvec2> points) {
    std::sort(points.begin(), points.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x; });
    return points;
  }
  /// A flat link at half height, its first fifth as deep as letters, between two signs that are 3
  /// em apart, far beyond its ends.
  static LinkWay Way() {
    LinkWay way;
    for (int i = 0; i <= 100; ++i) {
      way.all.emplace_back(1.2 + 0.01 * i, 0.5);
      if (i <= 20) way.deep.push_back(way.all.back());
    }
    return way;
  }
  /// By the definition, point by point.
  double Slowly(const std::vector<glm::dvec2>& ink, const std::vector<glm::dvec2>& flat,
                const std::vector<glm::dvec2>& of_links) const {
    const auto in_share = [&](glm::dvec2 p) { return p.x >= pair.from && p.x < pair.to; };
    const auto by = [&](double d, double share) {
      if (d >= LinkShapes::kFarthest) return 0.0;
      return std::max(0.0, share * (line.worth - 0.5 * std::pow(d / line.spread, 2)));
    };
    const auto to_sign = [&](glm::dvec2 p) {
      return p.x < pair.split ? shapes.Distance(pair.a, p - glm::dvec2(pair.x_a, 0))
                              : shapes.Distance(pair.b, p - glm::dvec2(pair.x_b, 0));
    };
    const glm::dvec2 at{pair.x_a, 0};
    double gain = 0;
    for (const glm::dvec2 p : ink) {
      if (!in_share(p)) continue;
      const double off = std::max(0.0, to_sign(p)) / line.spread;
      const double by_sign = std::max(0.0, line.worth - 0.5 * off * off);
      gain += std::max(0.0, by(link.DistanceToDeep(p - at), 0.7) - by_sign);
    }
    for (const glm::dvec2 p : of_links) {
      if (in_share(p)) gain += by(link.Distance(p - at), 0.3);
    }
    for (const glm::dvec2 p : flat) {
      const double d = link.Distance(p - at);
      if (!in_share(p) || d >= line.inner || to_sign(p) < line.inner) continue;
      gain -= line.cost * std::min(1.0, 2 * (1 - d / line.inner));
    }
    return std::max(-15.0, line.weight * gain);
  }

  Script script = FindScript("moon");
  SignShapes shapes{script, WrittenGlyphs(script), SignShapes::Dots::kMiddles};
  LinkShapes::Link link{Way()};
  SteppedLine line;
  SignPair pair{0, 1, 0.3, 3.3, 0.2, 3.2, 4.2};
};

// the centre line runs through cells whose middles lie up to 0.02 em from it, as deep as
// 5 * 0.7 * 0.6 less by at most 0.5 * (0.02 / 0.08)^2 * 0.7 * 0.6
TEST_F(LinkGainsTest, ItsEndsExplainInkAndAllOfItWhatIsALinks) {
  EXPECT_NEAR(Of({{1.55, 0.5}}, {}, {}), 2.1, 0.02);
  EXPECT_EQ(Of({{2.3, 0.5}}, {}, {}), 0);  // its middle is not so deep
  EXPECT_NEAR(Of({}, {}, {{2.3, 0.5}}), 0.9, 0.01);
  EXPECT_EQ(Of({}, {}, {{2.3, 0.9}}), 0);  // 5 spreads beside it
}

TEST_F(LinkGainsTest, FlatPaperOnItSpeaksAgainstItUpToABound) {
  EXPECT_NEAR(Of({}, {{2.3, 0.5}}, {}), -2.4, 1e-9);
  EXPECT_EQ(Of({}, {{2.3, 0.6}}, {}), 0);
  std::vector<glm::dvec2> flat;
  for (int i = 0; i < 50; ++i) flat.emplace_back(1.6 + 0.01 * i, 0.5);
  EXPECT_EQ(Of({}, flat, {}), -15);
}

TEST_F(LinkGainsTest, WhatLiesBeyondTheTwoSignsSharesIsNotTheirs) {
  pair.to = 2.2;
  EXPECT_EQ(Of({}, {{2.3, 0.5}}, {}), 0);
  EXPECT_EQ(Of({}, {}, {{2.3, 0.5}}), 0);
}

TEST_F(LinkGainsTest, NoLinkExplainsNothing) {
  link = LinkShapes::Link{LinkWay{}};
  EXPECT_EQ(Of({{1.55, 0.5}}, {{2.3, 0.5}}, {{2.3, 0.5}}), 0);
}

// sums of up to some hundred numbers of the order of 1, in another order
TEST_F(LinkGainsTest, AreWhatEachPointSays) {
  Random random(7);
  const auto scattered = [&random](std::size_t count) {
    std::vector<glm::dvec2> points;
    while (points.size() < count) {
      const double x = 5 * random.Uniform(), y = 1.6 * random.Uniform() - 0.4;
      points.emplace_back(x, y);
    }
    return points;
  };
  int positive = 0;
  for (int i = 0; i < 200; ++i) {
    LinkWay way;
    const double height = random.Uniform(), rise = random.Uniform() - 0.5;
    for (int k = 0; k <= 100; ++k) {
      way.all.emplace_back(0.5 + 0.02 * k, height + rise * 0.01 * k);
      if (k < 15 || k > 85) way.deep.push_back(way.all.back());
    }
    link = LinkShapes::Link(way);
    pair.a = static_cast<std::size_t>(random.Uniform() * static_cast<double>(shapes.size()));
    pair.b = static_cast<std::size_t>(random.Uniform() * static_cast<double>(shapes.size()));
    line.inner = i % 2 == 0 ? 0.05 : 0.14;  // narrower and wider than what links keep ready
    const auto ink = scattered(80), flat = scattered(100), of_links = scattered(80);
    const double gain = Of(ink, flat, of_links);
    ASSERT_NEAR(gain, Slowly(ink, flat, of_links), 1e-9) << i;
    if (gain > 0) ++positive;
  }
  EXPECT_GT(positive, 20);
  EXPECT_LT(positive, 180);
}

}  // namespace
}  // namespace moontrace
