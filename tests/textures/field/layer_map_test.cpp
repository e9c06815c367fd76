// Pages with more than letters: links among them, rules, a margin, headings in relief of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "textures/field/field_find.h"
#include "textures/field/field_place.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kWidth = 0.15, kHeight = 0.13;

/// Words linked letter by letter, between rules, in a margin, below a heading.
Texture LinkedPage(Relief relief, Relief of_headings) {
  const Script moon = FindScript("moon");
  TypeStyle style = DefaultStyle(0.008, relief, moon);
  style.structure.read = true;
  style.structure.heading_relief = of_headings;
  style.links.reach = LinkReach::kLetters;
  style.rules.lines = style.rules.margin = true;
  const Typeset set = SetText("# The moon\nlines of the text and\nmore of them", moon, style,
                              {"custom", kWidth, kHeight, 0.010});
  return BuildTexture(set.pages[0], moon, style);
}

std::vector<CompiledPart> PartsOf(const Texture& texture) {
  std::vector<CompiledPart> parts;
  for (const Layer& layer : texture.layers) {
    for (CompiledPart& part : CompileLayer(layer)) parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<glm::dvec2> PointsAnywhere(std::size_t count) {
  std::mt19937_64 random(15);
  std::uniform_real_distribution<double> x(-0.005, kWidth + 0.005), y(-0.005, kHeight + 0.005);
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < count; ++i) points.emplace_back(x(random), y(random));
  return points;
}

TEST(LayerMap, LinkedLettersStandInRowsAndTheirLinksJoinThem) {
  const Texture texture = LinkedPage(Relief::kEngraved, Relief::kEngraved);
  const std::vector<CompiledPart> parts = CompileLayer(texture.layers.at(0));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_GT(parts[0].layer.rows.length, 0U);
  EXPECT_FALSE(parts[0].layer.joins);
  EXPECT_TRUE(parts[1].layer.joins);
  EXPECT_EQ(parts[0].places.size(), 27U);  // of both sizes, a contraction is one
  EXPECT_LT(parts[1].places.size(), parts[0].places.size());
}

TEST(LayerMap, TellsOfAllThatLiesBeyondTheFirstLayer) {
  const Texture texture = LinkedPage(Relief::kEngraved, Relief::kEngraved);
  const std::vector<CompiledPart> parts = PartsOf(texture);
  ASSERT_GE(parts.size(), 3U);
  const LayerMap map(parts);
  std::size_t untold = 0, told = 0, there = 0;
  for (const glm::dvec2 p : PointsAnywhere(100000)) {
    const unsigned bits = map.At(p);
    told += bits != 0 ? 1U : 0U;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (SampleLayerAt(parts[i].layer, p).displacement == 0) continue;
      ++there;
      untold += (bits >> (i - 1) & 1) == 0 ? 1U : 0U;
    }
  }
  EXPECT_EQ(untold, 0U);
  EXPECT_GT(there, 1000U);
  EXPECT_LT(told, 4 * there);  // squares of half a stroke's width reach over it on either side
}

TEST(LayerMap, HasNothingBesideThePageNorWhereNoPointIs) {
  const Texture texture = LinkedPage(Relief::kEngraved, Relief::kEngraved);
  const LayerMap map(PartsOf(texture));
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const glm::dvec2 p :
       {glm::dvec2(-1, 0), {2, 0.05}, {0.05, 1e300}, {kNone, 0.05}, {0, kNone}})
    EXPECT_EQ(map.At(p), 0U) << p.x << ", " << p.y;
  EXPECT_EQ(LayerMap().At({0, 0}), 0U);
}

TEST(LayerMap, SamplesAreThoseOfTheTreeOneByOneAndAtOnce) {
  for (const auto& [relief, of_headings] : {std::pair(Relief::kEngraved, Relief::kEngraved),
                                            {Relief::kEngraved, Relief::kEmbossed},
                                            {Relief::kEmbossed, Relief::kEngraved}}) {
    const Texture texture = LinkedPage(relief, of_headings);
    const TextureField field(texture);
    const double tolerance = 1e-17 + 2 * field.greatest_slope() * 8 * 2.3e-16 * kWidth;
    const std::vector<glm::dvec2> points = PointsAnywhere(50000);
    std::vector<Sample> at_once(points.size());
    field.SamplesAt(points, at_once);
    int turned = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Sample one = field.SampleAt(points[i]), tree = SampleTree(texture, points[i]);
      ASSERT_NEAR(one.displacement, tree.displacement, tolerance) << points[i].x << points[i].y;
      turned += glm::length(one.gradient - tree.gradient) > 1e-9 ? 1 : 0;
      ASSERT_EQ(one.displacement, at_once[i].displacement);
      ASSERT_EQ(one.gradient, at_once[i].gradient);
    }
    EXPECT_LE(turned, 2);  // at creases
  }
}

// Layers from the fourth on share a bit.
TEST(LayerMap, HoldsMoreLayersThanBits) {
  Texture texture;
  for (int i = 0; i < 12; ++i) {
    Group group;
    group.elements.push_back({Dot{{0.003 * i, 0}}, Profile{0.004, 0.001, 0.0005}});
    texture.layers.push_back(
        {Finish(std::move(group)), i % 2 ? Relief::kEmbossed : Relief::kEngraved});
  }
  const TextureField field(texture);
  for (double x = -0.01; x < 0.05; x += 1e-4) {
    const Sample one = field.SampleAt({x, 0.0002}), tree = SampleTree(texture, {x, 0.0002});
    ASSERT_NEAR(one.displacement, tree.displacement, 1e-15) << x;
    ASSERT_NEAR(one.gradient.x, tree.gradient.x, 1e-9) << x;
  }
}

/// Letters that stand apart, each two joined by a link; all are slanting rows of dots, of which
/// those of a letter and a link lie beside each other but for their last.
Layer LinkedSlants(int dots) {
  constexpr double kStep = 1e-4;
  const Profile profile{0.5e-4, 0.2e-4, 0.1e-4};
  Group letter, link;
  for (int i = 0; i < dots; ++i) {
    const double last = i + 1 == dots ? 0 : 0.5 * kStep;
    letter.elements.push_back({Dot{kStep * glm::dvec2(i, i)}, profile});
    link.elements.push_back({Dot{kStep * glm::dvec2(i, i) + glm::dvec2(last, -last)}, profile});
  }
  const auto letters = Finish(std::move(letter)), links = Finish(std::move(link));
  Group page;
  const double advance = kStep * (dots + 10);
  for (int i = 0; i < 12; ++i) page.placements.push_back({letters, {advance * i, 0}});
  for (int i = 0; i < 5; ++i) page.placements.push_back({links, {advance * i, 0}});
  return {Finish(std::move(page)), Relief::kEngraved};
}

// Whether two of 6000 dots meet takes 36 million comparisons: such stay one part.
TEST(LayerMap, GivesUpLinksThatWouldTakeLongToFind) {
  EXPECT_EQ(CompileLayer(LinkedSlants(60)).size(), 2U);
  EXPECT_EQ(CompileLayer(LinkedSlants(6000)).size(), 1U);
}

TEST(LayerMap, TakesAFillWithoutOutline) {
  const Profile profile{0.004, 0.001, 0.0005};
  Group first, second;
  first.elements.push_back({Dot{{0, 0}}, profile});
  second.elements.push_back({Fill{}, profile});
  second.elements.push_back({Line{{0.01, 0}, {0.02, 0}}, profile});
  Texture texture;
  texture.layers.push_back({Finish(std::move(first)), Relief::kEngraved});
  texture.layers.push_back({Finish(std::move(second)), Relief::kEmbossed});
  const TextureField field(texture);
  EXPECT_DOUBLE_EQ(field.SampleAt({0.015, 0.001}).displacement,
                   SampleTree(texture, {0.015, 0.001}).displacement);
  EXPECT_GT(field.SampleAt({0.015, 0.001}).displacement, 0);
}

// At a link the sum of two layers is twice as deep as one layer.
TEST(LayerMap, TwoLayersAreAnotherFieldThanOneInTwoParts) {
  const Texture linked = LinkedPage(Relief::kEngraved, Relief::kEngraved);
  const std::vector<CompiledPart> parts = CompileLayer(linked.layers.at(0));
  ASSERT_EQ(parts.size(), 2U);
  Texture one, two;
  one.layers.push_back(linked.layers.at(0));
  for (const CompiledPart& part : parts) {
    Group group;
    for (const PlacedGroup& place : part.places) {
      // the tree's own groups, so that both fields have the same blocks
      group.placements.push_back({{std::shared_ptr<const Group>(), place.group}, place.origin});
    }
    two.layers.push_back({Finish(std::move(group)), Relief::kEngraved});
  }
  EXPECT_NE(TextureField(one).Hash(), TextureField(two).Hash());
}

}  // namespace
}  // namespace moontrace
