#include "textures/fonts/script_check.h"
#include "textures/fonts/script_library.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

namespace moontrace {
namespace {

using Kind = ScriptFinding::Kind;

Stroke LineStroke(std::vector<glm::dvec2> points) {
  Stroke stroke;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    stroke.pieces.emplace_back(Line{points[i], points[i + 1]});
  }
  return stroke;
}

Stroke ArcStroke(Arc arc) { return {StrokeKind::kStroke, {arc}}; }

std::vector<ScriptFinding> FindingsOf(std::vector<Stroke> strokes, const std::string& name = "a") {
  Script script;
  script.glyphs.push_back({name, 1, std::move(strokes)});
  return CheckGlyph(script, 0, {0.010, 0.001, 0.0012});
}

ScriptFinding OnlyFinding(std::vector<Stroke> strokes) {
  const std::vector<ScriptFinding> findings = FindingsOf(std::move(strokes));
  EXPECT_EQ(findings.size(), 1U);
  return findings.empty() ? ScriptFinding{} : findings[0];
}

TEST(CheckScript, IsSilentAboutMoonAtItsUsualSize) {
  // But for one variant, whose arc lies on the ring's outer edge so that both are one groove.
  const Script moon = FindScript("moon");
  const CheckSize usual{0.012, 0.1165 * 0.012, 0.0012};
  for (std::size_t glyph = 0; glyph < moon.glyphs.size(); ++glyph) {
    for (const ScriptFinding& finding : CheckGlyph(moon, glyph, usual)) {
      if (moon.glyphs[glyph].name == "h.arc" && finding.kind == Kind::kNarrowGap) continue;
      ADD_FAILURE() << moon.glyphs[glyph].name << " kind " << static_cast<int>(finding.kind)
                    << " figure " << finding.figure;
    }
  }
}

TEST(CheckScript, FindsAStrokeCutInTwo) {
  const ScriptFinding found =
      OnlyFinding({LineStroke({{0, 0}, {0.5, 0}}), LineStroke({{0.5, 0.004}, {1, 0.05}})});
  EXPECT_EQ(found.kind, Kind::kSplit);
  EXPECT_EQ(found.stroke, 0U);
  EXPECT_EQ(found.other, 1U);
  EXPECT_NEAR(found.figure, std::atan2(0.046, 0.5), 1e-9);
}

TEST(CheckScript, FindsANeedlessLiftAtACorner) {
  const ScriptFinding found =
      OnlyFinding({LineStroke({{0, 1}, {0, 0}}), LineStroke({{0, 0}, {1, 0}})});
  EXPECT_EQ(found.kind, Kind::kLift);
  EXPECT_NEAR(found.figure, std::numbers::pi / 2, 1e-9);
}

TEST(CheckScript, FindsAReversedStroke) {
  EXPECT_EQ(OnlyFinding({LineStroke({{0, 1}, {0, 0}}), LineStroke({{1, 0}, {0, 0}})}).kind,
            Kind::kReversed);
  EXPECT_EQ(OnlyFinding({LineStroke({{0.5, 0}, {0, 0}}), LineStroke({{0.5, 0}, {1, 0}})}).kind,
            Kind::kReversed);
}

TEST(CheckScript, LeavesTheOrderOfChineseCharactersAlone) {
  const std::vector<Stroke> corner = {LineStroke({{0, 1}, {0, 0}}), LineStroke({{0, 0}, {1, 0}})};
  EXPECT_TRUE(FindingsOf(corner, "\u53e3").empty());
}

TEST(CheckScript, MeasuresAnOverlap) {
  const ScriptFinding found =
      OnlyFinding({LineStroke({{0, 0}, {1, 0}}), LineStroke({{0.3, 0.005}, {0.7, 0.005}})});
  EXPECT_EQ(found.kind, Kind::kOverlap);
  EXPECT_NEAR(found.figure, 0.4 * 0.010, 0.02 * 0.010);  // two samples of 0.01 em
  const ScriptFinding back = OnlyFinding({LineStroke({{0, 0}, {1, 0}, {0.5, 0}})});
  EXPECT_EQ(back.kind, Kind::kOverlap);
  EXPECT_EQ(back.other, back.stroke);
}

TEST(CheckScript, MeasuresABendThatIsTooTight) {
  // A half circle of 0.04 em is 0.4 mm at 10 mm; the probe's radius is 0.6 mm.
  const ScriptFinding found = OnlyFinding({ArcStroke({{0, 0}, 0.04, 0, std::numbers::pi})});
  EXPECT_EQ(found.kind, Kind::kTightBend);
  EXPECT_NEAR(found.figure, 0.0004, 1e-12);
  EXPECT_NEAR(found.needed, 0.0006, 1e-12);
  EXPECT_TRUE(FindingsOf({ArcStroke({{0, 0}, 0.07, 0, std::numbers::pi})}).empty() ||
              FindingsOf({ArcStroke({{0, 0}, 0.07, 0, std::numbers::pi})})[0].kind !=
                  Kind::kTightBend);
}

TEST(CheckScript, MeasuresAGapThatIsTooNarrow) {
  // 0.15 em apart: 1.5 mm, less the groove of 1 mm leaves 0.5 mm.
  const ScriptFinding found =
      OnlyFinding({LineStroke({{0, 0}, {1, 0}}), LineStroke({{0, 0.15}, {1, 0.15}})});
  EXPECT_EQ(found.kind, Kind::kNarrowGap);
  EXPECT_NEAR(found.figure, 0.0005, 1e-9);
  EXPECT_NEAR(found.needed, 0.0012, 1e-12);
  EXPECT_TRUE(
      FindingsOf({LineStroke({{0, 0}, {1, 0}}), LineStroke({{0, 0.23}, {1, 0.23}})}).empty());
  // A hairpin of one stroke, its ways 0.15 em apart.
  const ScriptFinding itself = OnlyFinding({LineStroke({{0, 0}, {1, 0}, {1, 0.15}, {0, 0.15}})});
  EXPECT_EQ(itself.kind, Kind::kNarrowGap);
  EXPECT_EQ(itself.other, itself.stroke);
}

TEST(CheckScript, TakesCrossingsAndAnglesForWhatTheyAre) {
  EXPECT_TRUE(
      FindingsOf({LineStroke({{0, 0.5}, {1, 0.5}}), LineStroke({{0.5, 1}, {0.5, 0}})}).empty());
  EXPECT_TRUE(FindingsOf({LineStroke({{0, 0}, {0.5, 1}, {1, 0}})}).empty());
  EXPECT_TRUE(FindingsOf({LineStroke({{0, 0}, {0.2, 1}, {0.4, 0}})}).empty());
  EXPECT_TRUE(FindingsOf({ArcStroke({{0.5, 0.5}, 0.5, 1, 2 * std::numbers::pi})}).empty());
  std::vector<glm::dvec2> ring;  // not of one piece either
  for (int i = 0; i <= 16; ++i) ring.emplace_back(std::cos(i * 0.3927), std::sin(i * 0.3927));
  ring.back() = ring.front();
  EXPECT_TRUE(FindingsOf({LineStroke(ring)}).empty());
}

/// A line from one point to the other, of equal short ones.
Stroke CutLine(glm::dvec2 from, glm::dvec2 to, int pieces) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(from + (to - from) * (double(i) / pieces));
  return LineStroke(points);
}

// Were every piece's end a sample, this would take 10^11 comparisons.
TEST(CheckScript, FindsTheSameInStrokesOfVeryManyPieces) {
  const ScriptFinding found =
      OnlyFinding({CutLine({0, 0}, {1, 0}, 200000), CutLine({0, 0.15}, {1, 0.15}, 200000)});
  EXPECT_EQ(found.kind, Kind::kNarrowGap);
  EXPECT_NEAR(found.figure, 0.0005, 1e-9);
  EXPECT_TRUE(
      FindingsOf({CutLine({0, 0}, {1, 0}, 5000), CutLine({0, 0.23}, {1, 0.23}, 5000)}).empty());
}

TEST(CheckScript, LooksAtNoMoreStrokesThanAnyCharacterHasAndSaysSo) {
  std::vector<Stroke> strokes;
  for (int i = 0; i < 256; ++i) strokes.push_back(LineStroke({{0, 0.3 * i}, {1, 0.3 * i}}));
  EXPECT_TRUE(FindingsOf(strokes).empty());
  strokes.resize(100000, strokes.back());
  const ScriptFinding found = OnlyFinding(strokes);
  EXPECT_EQ(found.kind, Kind::kTooMany);
  EXPECT_EQ(found.figure, 100000);
}

TEST(IsOutlineFont, TellsPrintFromStrokes) {
  EXPECT_FALSE(IsOutlineFont(FindScript("moon")));
  Script script;
  Stroke area = LineStroke({{0, 0}, {1, 0}, {1, 1}, {0, 0}});
  area.kind = StrokeKind::kFill;
  script.glyphs.push_back({"a", 1, {area}});
  EXPECT_TRUE(IsOutlineFont(script));
}

}  // namespace
}  // namespace moontrace
