#include "textures/typeset/rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/textures/sample_page.h"
#include "textures/base/error.h"
#include "textures/field/field.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/relief/groove_links.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

struct Ruled {
  Script script;
  Typeset set;
  Texture texture;
  RaisedLines raised;
};

Ruled MakeRuled(TypeStyle style, Script script, const std::string& text) {
  Ruled ruled;
  style.rules.lines = style.rules.margin = true;
  if (style.lines == LineDirection::kAlternate) AddGuides(script, style);
  ruled.script = std::move(script);
  ruled.set = SetText(text, ruled.script, style, FindPage("a5"));
  ruled.texture = BuildTexture(ruled.set.pages.front(), ruled.script, style);
  ruled.raised = RaisedLinesOf(ruled.set.pages.front(), ruled.script, style);
  return ruled;
}

class RulesOfLines : public ::testing::TestWithParam<LineDirection> {
 protected:
  RulesOfLines() {
    const Script script = FindScript("moon");
    TypeStyle style = DefaultStyle(0.008, Relief::kEngraved, script);
    style.lines = GetParam();
    ruled_ = MakeRuled(style, script, std::string(kPangram) + "\n\n" + kPangram);
  }
  Ruled ruled_;
};
INSTANTIATE_TEST_SUITE_P(Directions, RulesOfLines,
                         ::testing::Values(LineDirection::kLeftToRight, LineDirection::kRightToLeft,
                                           LineDirection::kAlternate, LineDirection::kVertical),
                         [](const auto& direction) {
                           std::string name = NameOf(direction.param);
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

// Ridges have their own layers, so wherever those rise no stroke may be within the gap: samples
// along every ridge's rims and middle, and the ring of points at the gap around them.
TEST_P(RulesOfLines, KeepTheirGapToEveryStroke) {
  const TypeStyle& style = ruled_.set.style;
  Texture strokes;
  strokes.layers.push_back(ruled_.texture.layers.front());
  ASSERT_FALSE(ruled_.raised.rules.empty());
  ASSERT_EQ(ruled_.raised.margin.size(), 8U);
  std::vector<Piece> middles(ruled_.raised.margin);
  for (const Line& rule : ruled_.raised.rules) middles.emplace_back(rule);
  const double reach = 0.5 * RuleProfile(style).width + RuleGap(style) - 1e-9;
  for (const Piece& middle : middles) {
    for (double s = 0; s <= Length(middle); s += 0.5e-3) {
      const glm::dvec2 p = PointAt(middle, s);
      for (int turn = 0; turn < 8; ++turn) {
        const glm::dvec2 away(std::cos(0.785398 * turn), std::sin(0.785398 * turn));
        for (const double share : {0.0, 0.5, 1.0}) {
          ASSERT_EQ(SampleTree(strokes, p + share * reach * away).displacement, 0)
              << p.x << " " << p.y;
        }
      }
    }
  }
}

// Each line of text lies between two rules at the same distances, whatever letters it has.
TEST_P(RulesOfLines, StandOnEitherSideOfEachLine) {
  const TextPage& page = ruled_.set.pages.front();
  const bool vertical = ruled_.set.style.lines == LineDirection::kVertical;
  std::vector<double> middles;
  for (const Line& rule : ruled_.raised.rules) {
    middles.push_back(vertical ? rule.from.x : rule.from.y);
    EXPECT_NEAR(vertical ? rule.to.x : rule.to.y, middles.back(), 1e-15);
  }
  std::sort(middles.begin(), middles.end());
  middles.erase(std::unique(middles.begin(), middles.end()), middles.end());
  std::vector<std::size_t> lines;
  for (const PlacedGlyph& glyph : page.glyphs) lines.push_back(glyph.line);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  ASSERT_EQ(middles.size(), 2 * lines.size());
  const double between = middles[1] - middles[0];
  for (std::size_t i = 0; i < middles.size(); i += 2) {
    EXPECT_NEAR(middles[i + 1] - middles[i], between, 1e-12);
    EXPECT_GT(between, ruled_.set.style.size);
  }
}

// The margin's ridge is closed and smooth: pieces meet with one tangent, everything lies inside.
TEST_P(RulesOfLines, TheMarginSurroundsThemAll) {
  const std::vector<Piece>& margin = ruled_.raised.margin;
  Box around;
  for (std::size_t i = 0; i < margin.size(); ++i) {
    const Piece& next = margin[(i + 1) % margin.size()];
    EXPECT_NEAR(glm::distance(EndOf(margin[i]), StartOf(next)), 0, 1e-12);
    EXPECT_NEAR(glm::distance(TangentAt(margin[i], Length(margin[i])), TangentAt(next, 0)), 0,
                1e-12);
    Include(around, BoundsOf(margin[i]));
  }
  const double width = MarginProfile(ruled_.set.style).width;
  const Box sheet = Grown(ruled_.set.pages.front().sheet_P, -width / 2);
  EXPECT_TRUE(Contains(sheet, around.min) && Contains(sheet, around.max));
  for (const Line& rule : ruled_.raised.rules) {
    EXPECT_TRUE(Contains(around, rule.from) && Contains(around, rule.to));
  }
}

// The whole page with texture: compiled = tree, continuous, gradient = derivative off creases.
TEST_P(RulesOfLines, CompiledIsTheTreeWithTextureToo) {
  Texture texture = ruled_.texture;
  texture.paper.push_back({ruled_.set.pages.front().sheet_P, {}, 2e-3});
  const TextureField field(texture);
  const double tolerance =
      1e-17 + 2 * field.greatest_slope() * 8 * 2.3e-16 * ruled_.set.page.height;
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> x(-0.005, 0.153), y(-0.005, 0.215);
  int turned = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec2 p(x(random), y(random));
    const Sample compiled = field.SampleAt(p), tree = SampleTree(texture, p);
    ASSERT_NEAR(compiled.displacement, tree.displacement, tolerance);
    turned += glm::length(compiled.gradient - tree.gradient) > 1e-9 ? 1 : 0;
  }
  EXPECT_LE(turned, 2);
  for (int walk = 0; walk < 200; ++walk) {
    const glm::dvec2 from(x(random), y(random));
    const glm::dvec2 step = 1e-6 * glm::normalize(glm::dvec2(x(random), y(random)) - from);
    double before = field.SampleAt(from).displacement;
    for (int i = 1; i < 5000; ++i) {
      const double now = field.SampleAt(from + step * static_cast<double>(i)).displacement;
      ASSERT_LE(std::abs(now - before), 1e-6 * field.greatest_slope() * (1 + 1e-6));
      before = now;
    }
  }
}

std::string ErrorOf(const TypeStyle& style, const PageSpec& page) {
  const Script script = FindScript("moon");
  try {
    const Typeset set = SetText("one two\nthree", script, style, page);
    RaisedLinesOf(set.pages.front(), script, style);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RulesRoom, IsToldWhereItLacks) {
  TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, FindScript("moon"));
  style.rules.lines = true;
  EXPECT_EQ(ErrorOf(style, FindPage("a5")), "");
  // strokes 10 + 1.165 mm high, twice a gap of 1 mm and a rule of 1 mm, and 1 mm between the rules;
  // hundredths rounded up
  style.line_pitch = 0.0151;
  EXPECT_EQ(ErrorOf(style, FindPage("a5")),
            "line pitch 15.1 mm leaves no room for rules 1 mm wide and 1 mm apart: choose a line "
            "pitch of 16.17 mm or more");
  style.line_pitch = 0.01617;
  EXPECT_EQ(ErrorOf(style, FindPage("a5")), "");
  style.rules.margin = true;
  PageSpec page = FindPage("a5");
  page.margin = 0.002;
  EXPECT_NE(ErrorOf(style, page).find("no room in a margin of 2 mm, choose 2.59 mm"),
            std::string::npos)
      << ErrorOf(style, page);
  page.margin = 0.015;
  style.rules.height = 0.002;
  EXPECT_EQ(ErrorOf(style, page),
            "line rules: height 2 mm is too steep for the width 1 mm: at most 1.5 mm");
  style.rules.height = -1;
  EXPECT_NE(ErrorOf(style, page), "");
}

// However small the letters: a rule and the next line's are two ridges, not one with a scratch.
TEST(RulesRoom, KeepsRulesOfTwoLinesApart) {
  const Script script = FindScript("moon");
  for (const double size : {0.002, 0.003, 0.005, 0.008, 0.020}) {
    TypeStyle style = DefaultStyle(size, Relief::kEngraved, script);
    style.rules.lines = true;
    style.line_pitch = 3 * size;
    for (int i = 0; i < 60; ++i) {  // down to the least pitch that is taken
      style.line_pitch -= 0.03 * size;
      const Typeset set = SetText("(o,\nt?)", script, style, FindPage("a5"));
      RaisedLines raised;
      try {
        raised = RaisedLinesOf(set.pages.front(), script, style);
      } catch (const InputError& error) {
        EXPECT_GT(i, 20) << error.what();  // 2.4 sizes are room enough
        break;
      }
      ASSERT_EQ(raised.rules.size(), 4U);
      std::vector<double> heights;
      for (const Line& rule : raised.rules) heights.push_back(rule.from.y);
      std::sort(heights.begin(), heights.end());
      const double rims = heights[2] - heights[1] - RuleProfile(style).width;
      ASSERT_GE(rims, std::max(0.1 * size, 0.5e-3) - 1e-9) << size << " " << style.line_pitch;
    }
  }
}

// Groove links turn between letters and rule: they keep their own gap, a quarter of the groove's
// width, to the rule's rim.
TEST(RulesRoom, IsLeftForLinks) {
  const Script script = FindScript("moon");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, script);
  style.rules.lines = true;
  style.links.reach = LinkReach::kLetters;
  const Typeset set = SetText("sphinx of quartz\njudge my vow", script, style, FindPage("a4"));
  const TextPage& page = set.pages.front();
  const RaisedLines raised = RaisedLinesOf(page, script, style);
  const GrooveLinks links = LinkPage(page, script, style);
  ASSERT_GT(links.links.size(), links.missing);
  const double least = 0.5 * style.width + 0.5 * RuleProfile(style).width + 0.25 * style.width;
  for (const GrooveLink& link : links.links) {
    for (const Piece& piece : SpineOf(links, link)) {
      for (double s = 0; s <= Length(piece); s += 1e-4) {
        for (const Line& rule : raised.rules) {
          ASSERT_GE(DistanceTo(Piece(rule), PointAt(piece, s)), least - 1e-9);
        }
      }
    }
  }
}

TEST(RulesForce, IsPressTimesSlope) {
  // h = D - s (d - ...): 0.25 mm over 0.5 - 0.2 mm
  EXPECT_NEAR(TurningForce({1e-3, 0.25e-3, 0.2e-3}, 1), 0.25 / 0.3, 1e-12);
  EXPECT_NEAR(TurningForce({1e-3, 0.25e-3, 0.2e-3}, 0.3), 0.25, 1e-12);
}

}  // namespace
}  // namespace moontrace
