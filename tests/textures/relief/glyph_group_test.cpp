#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "tests/textures/small_script.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kTwoPi = glm::two_pi<double>();

TypeStyle Style() {
  TypeStyle style;
  style.size = 0.010;
  style.width = 0.0012;
  style.depth = 0.0006;
  style.rounding = 0.00024;
  style.blend_radius = 0.0003;
  style.line_pitch = 0.018;
  return style;
}

template <typename ShapeKind>
std::vector<ShapeKind> All(const Group& group) {
  std::vector<ShapeKind> found;
  for (const Element& element : group.elements) {
    if (const auto* shape = std::get_if<ShapeKind>(&element.shape)) found.push_back(*shape);
  }
  return found;
}

Glyph WithStroke(std::vector<Piece> pieces) {
  return {"test", 1, {{StrokeKind::kStroke, std::move(pieces)}}};
}

TEST(BuildGlyph, ScalesPiecesAndCapsEndsAndJointsOnce) {
  // Moon's L: (0,1)-(0,0)-(1,0).
  const Group group = BuildGlyph(WithStroke({Line{{0, 1}, {0, 0}}, Line{{0, 0}, {1, 0}}}), Style());
  ASSERT_EQ(group.elements.size(), 5u);
  EXPECT_EQ(std::get<Line>(group.elements[0].shape), (Line{{0, 0.010}, {0, 0}}));
  EXPECT_EQ(std::get<Line>(group.elements[1].shape), (Line{{0, 0}, {0.010, 0}}));
  EXPECT_EQ(std::get<Dot>(group.elements[2].shape).center, glm::dvec2(0, 0.010));
  EXPECT_EQ(std::get<Dot>(group.elements[3].shape).center, glm::dvec2(0, 0));
  EXPECT_EQ(std::get<Dot>(group.elements[4].shape).center, glm::dvec2(0.010, 0));
  for (const Element& element : group.elements) {
    EXPECT_EQ(element.profile.width, 0.0012);
    EXPECT_EQ(element.profile.depth, 0.0006);
    EXPECT_EQ(element.profile.rounding, 0.00024);
  }
  EXPECT_EQ(group.blend_radius, 0.0003);
}

TEST(BuildGlyph, SharesADotBetweenStrokesThatMeet) {
  Glyph glyph = WithStroke({Line{{0, 0}, {1, 0}}});
  glyph.strokes.push_back({StrokeKind::kStroke, {Line{{1, 1e-9}, {1, 1}}}});  // but for rounding
  EXPECT_EQ(All<Dot>(BuildGlyph(glyph, Style())).size(), 3u);
}

TEST(BuildGlyph, NeedsNoDotOnAFullCircle) {
  const Group group = BuildGlyph(WithStroke({Arc{{0.5, 0.5}, 0.5, 0, kTwoPi}}), Style());
  ASSERT_EQ(group.elements.size(), 1u);
  EXPECT_EQ(std::get<Arc>(group.elements[0].shape).radius, 0.005);
}

TEST(BuildGlyph, ClosesARingOfTwoArcsWithTwoDots) {
  const Group group = BuildGlyph(WithStroke({Arc{{0.5, 0.5}, 0.5, 0, kTwoPi / 2},
                                             Arc{{0.5, 0.5}, 0.5, kTwoPi / 2, kTwoPi / 2}}),
                                 Style());
  EXPECT_EQ(All<Arc>(group).size(), 2u);
  EXPECT_EQ(All<Dot>(group).size(), 2u);
}

TEST(BuildGlyph, MakesADiscOfADotNotNarrowerThanTheGroove) {
  Glyph glyph;
  glyph.strokes = {{StrokeKind::kDot, {Arc{{0.1, 0.2}, 0.11, 0, kTwoPi}}},
                   {StrokeKind::kDot, {Arc{{0.5, 0.2}, 0.01, 0, kTwoPi}}}};
  const std::vector<Fill> fills = All<Fill>(BuildGlyph(glyph, Style()));
  ASSERT_EQ(fills.size(), 2u);
  const Arc large = std::get<Arc>(fills[0].outline.at(0));
  EXPECT_NEAR(large.radius, 0.0011, 1e-17);  // one rounding
  EXPECT_NEAR(large.center.x, 0.001, 1e-17);
  EXPECT_EQ(std::get<Arc>(fills[1].outline.at(0)).radius, 0.0006);
}

TEST(BuildGlyph, OrdersPiecesThenDotsThenFills) {
  Glyph glyph;
  glyph.strokes = {
      {StrokeKind::kFill, {Line{{0, 0}, {1, 0}}, Line{{1, 0}, {0, 1}}, Line{{0, 1}, {0, 0}}}},
      {StrokeKind::kStroke, {Line{{0, 0}, {0, 1}}}}};
  const Group group = BuildGlyph(glyph, Style());
  ASSERT_EQ(group.elements.size(), 4u);
  EXPECT_TRUE(std::holds_alternative<Line>(group.elements[0].shape));
  EXPECT_TRUE(std::holds_alternative<Dot>(group.elements[1].shape));
  EXPECT_TRUE(std::holds_alternative<Dot>(group.elements[2].shape));
  const Fill& fill = std::get<Fill>(group.elements[3].shape);
  ASSERT_EQ(fill.outline.size(), 3u);
  EXPECT_EQ(std::get<Line>(fill.outline[1]), (Line{{0.010, 0}, {0, 0.010}}));
}

TEST(BuildTexture, SharesOneGroupAmongAllPlacesOfAGlyph) {
  const Script script = SmallScript();
  const Typeset set = SetText("aba\na", script, Style(), FindPage("a5"));
  const Texture texture = BuildTexture(set.pages[0], script, set.style);
  ASSERT_EQ(texture.layers.size(), 1u);
  EXPECT_EQ(texture.layers[0].relief, Relief::kEngraved);
  const auto& lines = texture.layers[0].group->placements;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].origin, glm::dvec2(0, 0));
  const auto& first = lines[0].group->placements;
  ASSERT_EQ(first.size(), 3u);
  EXPECT_EQ(first[0].group, first[2].group);
  EXPECT_NE(first[0].group, first[1].group);
  EXPECT_EQ(first[0].group, lines[1].group->placements.at(0).group);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(first[i].origin, set.pages[0].glyphs[i].origin_P);
  }
}

TEST(BuildTexture, IsAGrooveOrARidgeWhereALetterStands) {
  const Script script = SmallScript();
  TypeStyle style = Style();
  style.blend_radius = 0;
  for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
    style.relief = relief;
    const Typeset set = SetText("a\nb", script, style, FindPage("a5"));
    const Texture texture = BuildTexture(set.pages[0], script, style);
    const double sign = relief == Relief::kEngraved ? -1 : 1;
    for (const PlacedGlyph& placed : set.pages[0].glyphs) {
      // The stroke stands half an em from the left: full depth on it, none one width beside it.
      const glm::dvec2 spine = placed.origin_P + glm::dvec2(0.005, 0.003);
      EXPECT_NEAR(SampleTree(texture, spine).displacement, sign * 0.0006, 1e-12);
      EXPECT_EQ(SampleTree(texture, spine + glm::dvec2(0.0012, 0)).displacement, 0);
    }
  }
}

}  // namespace
}  // namespace moontrace
