// Lines of two sizes on a page: where they stand, and what is felt.
#include <gtest/gtest.h>

#include <glm/vec2.hpp>
#include <random>

#include "tests/textures/gradient_walk.h"
#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/field/field.h"
#include "textures/field/field_place.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kSize = 0.010, kPitch = 0.018;     // gap between lines 8 mm
constexpr double kHeading = 0.015;                  // gap 12 mm
const PageSpec kPage{"custom", 0.10, 0.12, 0.010};  // 80 by 100 mm to set in

TypeStyle Style(const Script& script) {
  TypeStyle style = DefaultStyle(kSize, Relief::kEngraved, script);
  style.line_pitch = kPitch;
  style.structure.read = true;
  return style;
}

Typeset Set(std::string_view text, LineDirection lines = LineDirection::kLeftToRight) {
  Script script = SmallScript();
  TypeStyle style = Style(script);
  style.lines = lines;
  if (lines == LineDirection::kAlternate) AddGuides(script, style);
  return SetText(text, script, style, kPage);
}

// The line's first glyph on a page.
const PlacedGlyph& At(const Typeset& set, std::size_t page, std::size_t line) {
  for (const PlacedGlyph& placed : set.pages.at(page).glyphs) {
    if (placed.line == line) return placed;
  }
  ADD_FAILURE() << "no line " << line;
  return set.pages[0].glyphs[0];
}

// Base lines by hand: the top margin lies at 110 mm. A heading's is 15 mm below it; to a line of
// the text below: the heading's gap of 12 mm and 10 mm; to a heading below: 12 and 15 mm.
TEST(Headings, StandAtTheirOwnLinePitch) {
  const Typeset set = Set("# a\nb\nc\n# d");
  EXPECT_NEAR(At(set, 0, 0).origin_P.y, 0.095, 1e-12);
  EXPECT_NEAR(At(set, 0, 1).origin_P.y, 0.073, 1e-12);
  EXPECT_NEAR(At(set, 0, 2).origin_P.y, 0.055, 1e-12);
  EXPECT_NEAR(At(set, 0, 3).origin_P.y, 0.028, 1e-12);
  EXPECT_EQ(At(set, 0, 0).kind, LineKind::kHeading);
  EXPECT_EQ(At(set, 0, 1).kind, LineKind::kPlain);
}

// Advances of 10 mm become 15: 80 mm hold five signs of which the last reaches 7.5 mm.
TEST(Headings, WrapByTheirOwnSizeAndLeaveAHeadingsPitchBetween) {
  const Typeset set = Set("# abcde fg\nh");
  EXPECT_NEAR(set.pages[0].glyphs[1].origin_P.x - set.pages[0].glyphs[0].origin_P.x, kHeading,
              1e-12);
  EXPECT_EQ(set.pages[0].glyphs[4].line, 0U);
  EXPECT_EQ(set.pages[0].glyphs[5].line, 1U);
  EXPECT_NEAR(At(set, 0, 0).origin_P.y - At(set, 0, 1).origin_P.y, 1.5 * kPitch, 1e-12);
}

TEST(Headings, RunDownAndBackAsTheTextDoes) {
  const Typeset down = Set("# ab\nc", LineDirection::kVertical);
  // Column of 15 mm at the right margin, 90 mm; strokes of 7.5 mm in its middle; then 12 mm, 10 mm.
  EXPECT_NEAR(At(down, 0, 0).origin_P.x, 0.075 + 0.00375, 1e-12);
  EXPECT_NEAR(At(down, 0, 0).origin_P.y, 0.110 - kHeading, 1e-12);
  EXPECT_NEAR(At(down, 0, 1).origin_P.x, 0.075 - 0.012 - 0.010 + 0.0025, 1e-12);
  const Typeset back = Set("# ab\nc", LineDirection::kRightToLeft);
  EXPECT_NEAR(At(back, 0, 0).origin_P.x, 0.090 - 0.0075, 1e-12);
  EXPECT_NEAR(back.pages[0].glyphs[1].origin_P.x, 0.090 - 0.0075 - kHeading, 1e-12);
}

// Old Moon: a heading of two rows has a guide of its size; what follows begins at the left again.
TEST(Headings, AlternateByThemselves) {
  const Typeset set = Set("# abcde\nghi", LineDirection::kAlternate);
  const Script script = SmallScript();
  const auto& glyphs = set.pages[0].glyphs;
  std::size_t guides = 0;
  for (const PlacedGlyph& placed : glyphs) {
    if (placed.glyph < script.glyphs.size()) continue;
    ++guides;
    EXPECT_EQ(placed.kind, LineKind::kHeading);
  }
  EXPECT_EQ(guides, 1U);
  EXPECT_NEAR(At(set, 0, 2).origin_P.x, 0.010, 1e-12);
  EXPECT_NEAR(At(set, 0, 0).origin_P.y - At(set, 0, 1).origin_P.y, 1.5 * kPitch, 1e-12);
}

TEST(Headings, DoNotStandAloneAtAPagesFoot) {
  // Five lines: base lines at 100, 82, 64, 46, 28 mm; a heading at 46 - 23 mm fits, no line below.
  const Typeset set = Set("a\nb\nc\nd\n# e\nf\ng");
  ASSERT_EQ(set.pages.size(), 2U);
  EXPECT_EQ(set.pages[0].lines, 4U);
  EXPECT_EQ(At(set, 1, 0).kind, LineKind::kHeading);
  EXPECT_NEAR(At(set, 1, 0).origin_P.y, 0.095, 1e-12);
  EXPECT_NEAR(At(set, 1, 1).origin_P.y, 0.073, 1e-12);
  // Two rows of one heading go together; a heading that nothing follows may stay.
  const Typeset two = Set("a\nb\nc\n# abcde f\ng");
  ASSERT_EQ(two.pages.size(), 2U);
  EXPECT_EQ(At(two, 1, 0).kind, LineKind::kHeading);
  EXPECT_EQ(At(two, 1, 1).kind, LineKind::kHeading);
  EXPECT_EQ(At(two, 1, 2).kind, LineKind::kPlain);
  EXPECT_EQ(Set("a\nb\nc\nd\n# e").pages.size(), 1U);
  // Three rows and an empty line leave no room below even on a page of their own.
  const Typeset three = Set("a\n# abcdefghijklmno\n\nb");
  ASSERT_EQ(three.pages.size(), 3U);
  EXPECT_EQ(three.pages[0].lines, 1U);
  EXPECT_EQ(three.pages[1].lines, 3U);
  EXPECT_EQ(At(three, 2, 0).kind, LineKind::kPlain);
  // More headings than a page holds: they fill it.
  EXPECT_EQ(Set("# a\n# b\n# c\n# d\n# e\nf").pages.size(), 2U);
}

TEST(Headings, ThatNoPageHoldsAreRefused) {
  const Script script = SmallScript();
  TypeStyle style = Style(script);
  const PageSpec low{"custom", 0.10, 0.033, 0.010};  // 13 mm: a line of text, no heading
  EXPECT_NO_THROW(SetText("a", script, style, low));
  EXPECT_THROW(SetText("# a", script, style, low), InputError);
  style.structure.heading_scale = 0.5;
  EXPECT_THROW(SetText("a", script, style, kPage), InputError);
}

TEST(Quotations, AreIndentedByAnEm) {
  const Typeset set = Set("a\n> bcdefghij k\nl");
  EXPECT_NEAR(At(set, 0, 0).origin_P.x, 0.010, 1e-12);
  EXPECT_NEAR(At(set, 0, 1).origin_P.x, 0.020, 1e-12);
  EXPECT_NEAR(At(set, 0, 2).origin_P.x, 0.020, 1e-12);
  EXPECT_NEAR(At(set, 0, 3).origin_P.x, 0.010, 1e-12);
}

// ---- what is felt ----

struct Felt {
  Typeset set;
  Texture texture;
};

Felt Feel(std::optional<Relief> relief, const char* first = "# The moon, 207") {
  const Script moon = FindScript("moon");
  TypeStyle style = DefaultStyle(0.006, Relief::kEngraved, moon);
  style.structure.read = true;
  style.structure.heading_relief = relief;
  const std::string text =
      std::string(first) +
      "\nlines of the text and\n> quoted what\nmore [lines](x)\n# Shq.\nlast &";
  Felt felt{SetText(text, moon, style, {"custom", 0.15, 0.12, 0.010}), {}};
  felt.texture = BuildTexture(felt.set.pages[0], moon, style);
  return felt;
}

TEST(TwoSizes, CompiledFieldIsTheTree) {
  // With a numeral sign in a heading lines are too near for rows; without, they are rows.
  const std::pair<std::optional<Relief>, const char*> pages[] = {
      {std::nullopt, "# The moon, 207"},
      {std::nullopt, "# The moon"},
      {Relief::kEmbossed, "# The moon, 207"}};
  for (const auto& [relief, first] : pages) {
    const Felt felt = Feel(relief, first);
    EXPECT_EQ(felt.texture.layers.size(), relief ? 2U : 1U);
    const TextureField field(felt.texture);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> x(0, 0.15), y(0, 0.12);
    for (int i = 0; i < 100000; ++i) {
      const glm::dvec2 p(x(random), y(random));
      const Sample tree = SampleTree(felt.texture, p), flat = field.SampleAt(p);
      // a few units in the last place of the page's 150 mm, times a slope below 3
      ASSERT_NEAR(flat.displacement, tree.displacement, 1e-15) << p.x << " " << p.y;
    }
  }
}

// Lines of two heights are found by arithmetic, as those of one are; buckets would answer too.
TEST(TwoSizes, AreKeptAsRowsOfTheCompiledField) {
  const Script moon = FindScript("moon");
  TypeStyle style = DefaultStyle(0.006, Relief::kEngraved, moon);
  style.structure.read = true;
  const Typeset set = SetText("# The moon\nlines of the text and\nmore\n# Shq\nlast", moon, style,
                              {"custom", 0.15, 0.12, 0.010});
  ASSERT_EQ(set.pages[0].lines, 6U);
  const TextureField::CompiledLayer layer =
      CompileLayer(BuildTexture(set.pages[0], moon, style).layers.at(0)).front().layer;
  EXPECT_GT(layer.rows.length, 0U);
  EXPECT_EQ(layer.rows.heights.size(), 6U);
  EXPECT_GT(layer.rows.of_band.size(), 6U);
}

TEST(TwoSizes, RidgesOfHeadingsStandAmongGrooves) {
  const Felt felt = Feel(Relief::kEmbossed);
  double highest = 0, deepest = 0;
  for (double x = 0; x < 0.15; x += 1e-4) {
    for (double y = 0; y < 0.12; y += 1e-4) {
      const double h = SampleTree(felt.texture, {x, y}).displacement;
      highest = std::max(highest, h);
      deepest = std::min(deepest, h);
    }
  }
  // 6 mm letters: w = 0.2 em, D = w/3 of grooves; headings of 9 mm: w = 1.8 mm, ridges of w/4. A
  // spine is met within 0.07 mm, where it is lower by less than the slope of 5/6 or 10/9 times
  // that.
  EXPECT_NEAR(highest, 0.45e-3, 0.06e-3);
  EXPECT_NEAR(deepest, -0.4e-3, 0.08e-3);
  EXPECT_LE(highest, 0.45e-3 + 1e-9);
}

// Ridge to groove included.
TEST(TwoSizes, DisplacementIsContinuousAndItsDerivativeTheGradient) {
  const Felt felt = Feel(Relief::kEmbossed);
  ExpectGradientIsTheDerivative(TextureField(felt.texture), {0.15, 0.12}, 20000);
}

// Strokes of different lines stay a groove's width apart: a tip finds paper between them.
TEST(TwoSizes, NoLinesRunIntoEachOther) {
  const Felt felt = Feel(std::nullopt);
  const Script moon = FindScript("moon");
  std::vector<Box> lines(felt.set.pages[0].lines);
  for (const PlacedGlyph& placed : felt.set.pages[0].glyphs) {
    const TypeStyle style = LineStyle(placed.kind, felt.set.style, moon);
    const Box box = Finish(BuildGlyph(moon.glyphs[placed.glyph], style))->bounds;
    Include(lines[placed.line], Moved(box, placed.origin_P));
  }
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_GT(lines[i - 1].min.y - lines[i].max.y, felt.set.style.width) << i;
  }
}

}  // namespace
}  // namespace moontrace
