// Every sign of moon.svg against the measured strokes of tests/data/moon-reference.json.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "tests/source_path.h"
#include "textures/base/resources.h"
#include "textures/fonts/script.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

using nlohmann::json;
constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 0.001;  ///< [em], the bar for the glyphs

const Script& Moon() {
  static const Script script = LoadScript(ResourcePath("textures/scripts/moon.svg"));
  return script;
}

const json& Reference() {
  static const json reference =
      json::parse(std::ifstream(SourcePath("tests/data/moon-reference.json")));
  return reference;
}

glm::dvec2 Point(const json& pair) { return {pair[0].get<double>(), pair[1].get<double>()}; }

/// A measured stroke as points, 0.002 em apart or closer, in writing order.
std::vector<glm::dvec2> Sampled(const json& stroke) {
  constexpr int kCount = 1500;  // the longest, a circle of radius 0.5, is 3.15 em
  std::vector<glm::dvec2> points;
  const bool line = stroke["type"] == "line";
  for (int i = 0; i <= kCount; ++i) {
    const double share = static_cast<double>(i) / kCount;
    if (line) {
      points.push_back(Point(stroke["from"]) * (1 - share) + Point(stroke["to"]) * share);
    } else {
      const double start = stroke.value("start_deg", 0.0), sweep = stroke.value("sweep_deg", 360.0);
      const double angle = (start + share * sweep) * kPi / 180;
      points.push_back(Point(stroke["centre"]) + stroke["radius"].get<double>() *
                                                     glm::dvec2(std::cos(angle), std::sin(angle)));
    }
  }
  return points;
}

double Distance(const std::vector<Piece>& pieces, glm::dvec2 p) {
  double nearest = 1e300;
  for (const Piece& piece : pieces) nearest = std::min(nearest, DistanceTo(piece, p));
  return nearest;
}

/// The pieces of the glyph that the reference measures: strokes and dots; fills are checked apart.
std::vector<Piece> DrawnPieces(const Glyph& glyph) {
  std::vector<Piece> pieces;
  for (const Stroke& stroke : glyph.strokes) {
    if (stroke.kind == StrokeKind::kFill) continue;
    pieces.insert(pieces.end(), stroke.pieces.begin(), stroke.pieces.end());
  }
  return pieces;
}

class MoonGlyph : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    for (const json& entry : Reference()["glyphs"]) {
      if (entry["glyph"] == GetParam()) measured_ = entry;
    }
    const std::size_t index = Moon().Find(GetParam());
    ASSERT_NE(index, Script::npos);
    glyph_ = Moon().glyphs[index];
  }
  json measured_;
  Glyph glyph_;
};

TEST_P(MoonGlyph, HasTheMeasuredAdvance) {
  EXPECT_NEAR(glyph_.advance, measured_["advance"].get<double>(), 1e-12);
}

TEST_P(MoonGlyph, HasTheMeasuredPiecesInTheirOrderAndDirection) {
  const std::vector<Piece> pieces = DrawnPieces(glyph_);
  ASSERT_EQ(pieces.size(), measured_["strokes"].size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const json& stroke = measured_["strokes"][i];
    const Arc* arc = std::get_if<Arc>(&pieces[i]);
    ASSERT_EQ(arc == nullptr, stroke["type"] == "line") << i;
    if (arc != nullptr) {
      EXPECT_NEAR(arc->radius, stroke["radius"].get<double>(), 1e-9) << i;
      EXPECT_LT(glm::length(arc->center - Point(stroke["centre"])), kTolerance) << i;
      // The reference rounds angles to 0.001 degrees and cuts at rounded points.
      EXPECT_NEAR(arc->sweep, stroke.value("sweep_deg", 360.0) * kPi / 180, 2e-3) << i;
    }
    if (stroke["type"] == "circle" || stroke["type"] == "dot") continue;  // they start anywhere
    const std::vector<glm::dvec2> points = Sampled(stroke);
    EXPECT_LT(glm::length(StartOf(pieces[i]) - points.front()), kTolerance) << i;
    EXPECT_LT(glm::length(EndOf(pieces[i]) - points.back()), kTolerance) << i;
  }
}

TEST_P(MoonGlyph, LiesWithinAThousandthOfAnEmBothWays) {
  const std::vector<Piece> pieces = DrawnPieces(glyph_);
  std::vector<glm::dvec2> measured;
  for (const json& stroke : measured_["strokes"]) {
    for (const glm::dvec2 p : Sampled(stroke)) {
      EXPECT_LT(Distance(pieces, p), kTolerance);
      measured.push_back(p);
    }
  }
  // Samples lie up to 0.0021 em apart, so the nearest may be half of that along the stroke; across
  // it the bar holds: hypot(0.00105, 0.001).
  for (const Piece& piece : pieces) {
    for (int i = 0; i <= 100; ++i) {
      const glm::dvec2 p = PointAt(piece, Length(piece) * i / 100);
      double nearest = 1e300;
      for (const glm::dvec2 q : measured) nearest = std::min(nearest, glm::length(p - q));
      EXPECT_LT(nearest, std::hypot(0.00105, kTolerance));
    }
  }
}

TEST_P(MoonGlyph, JoinsItsPiecesEndToEnd) {
  for (const Stroke& stroke : glyph_.strokes) {
    ASSERT_FALSE(stroke.pieces.empty());
    for (std::size_t i = 0; i + 1 < stroke.pieces.size(); ++i) {
      EXPECT_LT(glm::length(EndOf(stroke.pieces[i]) - StartOf(stroke.pieces[i + 1])), 1e-9);
    }
    if (stroke.kind != StrokeKind::kStroke) {
      EXPECT_LT(glm::length(EndOf(stroke.pieces.back()) - StartOf(stroke.pieces.front())), 1e-9);
    }
  }
}

std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const json& entry : Reference()["glyphs"]) names.push_back(entry["glyph"]);
  return names;
}

std::string TestName(const testing::TestParamInfo<std::string>& glyph) {
  std::string name = glyph.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, MoonGlyph, testing::ValuesIn(Names()), TestName);

TEST(MoonScript, HasEveryMeasuredSignAndNoOther) {
  std::set<std::string> measured, drawn;
  for (const std::string& name : Names()) measured.insert(name);
  for (const Glyph& glyph : Moon().glyphs) drawn.insert(glyph.name);
  EXPECT_EQ(drawn, measured);
  EXPECT_EQ(Moon().stroke_width, Reference()["stroke_width"].get<double>());
  EXPECT_EQ(Moon().space_advance, Reference()["space_advance"].get<double>());
}

const Stroke& FillOf(const std::string& name) {
  const Glyph& glyph = Moon().glyphs.at(Moon().Find(name));
  EXPECT_EQ(glyph.strokes.size(), 2U);
  EXPECT_EQ(glyph.strokes[0].kind, StrokeKind::kStroke);
  EXPECT_EQ(glyph.strokes[1].kind, StrokeKind::kFill);
  return glyph.strokes[1];
}

TEST(MoonScript, FillsHBetweenTheRingsOuterEdgeAndTheMeasuredArc) {
  const json& inner = Reference()["crescent_inner"];
  const std::vector<Piece>& outline = FillOf("h").pieces;
  ASSERT_EQ(outline.size(), 2U);
  const Arc& outer_arc = std::get<Arc>(outline[0]);
  const Arc& inner_arc = std::get<Arc>(outline[1]);
  EXPECT_NEAR(outer_arc.radius, 0.345 + 0.1165 / 2, 1e-9);
  EXPECT_LT(glm::length(outer_arc.center - glm::dvec2(0.345, 0.5)), 1e-6);
  EXPECT_NEAR(inner_arc.radius, inner["radius"].get<double>(), 1e-9);
  EXPECT_LT(glm::length(inner_arc.center - Point(inner["centre"])), 1e-6);
  // The ink at half height: from the outer edge to x = 0.204, 0.262 thick in the reference.
  EXPECT_NEAR(outer_arc.center.x - outer_arc.radius, 0.204 - 0.262, 5e-4);
  EXPECT_NEAR(inner_arc.center.x - inner_arc.radius, 0.204, 5e-4);
  // The area lies on the left: the outline runs counter-clockwise by the outer side.
  EXPECT_GT(outer_arc.sweep, kPi);
  EXPECT_LT(inner_arc.sweep, 0);
}

TEST(MoonScript, SinksThePocketAsTheLeftHalfToTheRingsOuterEdge) {
  const std::vector<Piece>& outline = FillOf("h.pocket").pieces;
  ASSERT_EQ(outline.size(), 2U);
  const Arc& arc = std::get<Arc>(outline[0]);
  EXPECT_NEAR(arc.radius, 0.345 + 0.1165 / 2, 1e-9);
  EXPECT_NEAR(arc.sweep, kPi, 1e-9);
  EXPECT_LT(PointAt(arc, Length(arc) / 2).x, 0);
  const Line& edge = std::get<Line>(outline[1]);
  EXPECT_NEAR(edge.from.x, 0.345, 1e-9);
  EXPECT_NEAR(edge.to.x, 0.345, 1e-9);
}

TEST(MoonScript, BindsLettersDigitsAndPunctuationOfTheReference) {
  for (char c = 'a'; c <= 'z'; ++c) {
    EXPECT_EQ(Moon().signs.at(static_cast<char32_t>(c)), std::string(1, c));
  }
  const std::string digits = "jabcdefghi";
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(Moon().digits.at(static_cast<char32_t>('0' + i)), std::string(1, digits[i]));
  }
  EXPECT_EQ(Moon().numeral_sign, "numeral");
  EXPECT_EQ(Moon().signs.at(U'?'), "question");
  for (const auto& [character, glyph] : Moon().signs) {
    EXPECT_NE(glyph, "mid-dot");
    EXPECT_NE(glyph, "three-dots");
    EXPECT_NE(glyph, "double-bar");
    EXPECT_NE(character, Moon().protect_mark);
  }
}

TEST(MoonScript, KnowsWhatGradeOneIsCertainOf) {
  EXPECT_EQ(Moon().grades, (std::vector<double>{0.5, 1, 2}));
  std::vector<std::string> rules;
  for (const Contraction& contraction : Moon().contractions) {
    if (contraction.grade > 1) continue;
    if (contraction.print == "...") {  // punctuation, at any grade: three dots, one in a comma
      EXPECT_EQ(contraction.signs, std::vector<std::string>(3, "comma"));
      EXPECT_EQ(contraction.grade, 0.5);
      continue;
    }
    ASSERT_EQ(contraction.signs.size(), 1U);
    const bool part = contraction.where == Contraction::Where::kPartOfWord;
    ASSERT_TRUE(part || contraction.where == Contraction::Where::kWholeWord);
    rules.push_back(contraction.print + (part ? "*" : "") + "=" + contraction.signs[0]);
    EXPECT_EQ(contraction.grade, 1);
  }
  EXPECT_EQ(rules, (std::vector<std::string>{"and=and", "the=th", "th*=th"}));
  const std::map<std::string, std::string> forms = {
      {"crescent", "h"}, {"arc", "h.arc"}, {"pocket", "h.pocket"}, {"reverse-n", "h.reverse-n"}};
  EXPECT_EQ(Moon().forms.at("h"), forms);
}

}  // namespace
}  // namespace moontrace
