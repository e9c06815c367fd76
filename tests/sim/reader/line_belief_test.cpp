#include "sim/reader/line_belief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "sim/reader/line_frame.h"
#include "sim/reading/known_links.h"
#include "sim/reading/reading_setup.h"
#include "textures/base/units.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/groove_links.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kSize = 0.005, kWidth = 0.0015;

/// A line of Braille cells as a hand without any error would feel it, a place each tenth of an em.
struct BrailleLine {
  BrailleLine() : script(FindScript("braille")) { shapes = KnownShapes(script, {}); }
  std::size_t Sign(const std::string& name) const {
    for (std::size_t sign = 0; sign < shapes->size(); ++sign) {
      if (script.glyphs[shapes->GlyphOf(sign)].name == name) return sign;
    }
    return SignGuess::kUnknown;
  }
  /// An empty name is a space.
  std::vector<HatchPoint> Felt(const std::vector<std::string>& cells, const SignPlace& at) const {
    const double advance = 1.2;
    std::vector<glm::dvec2> dots;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (const char c : cells[i].substr(cells[i].empty() ? 0 : 5)) {
        const int dot = c - '1';
        dots.emplace_back(advance * static_cast<double>(i) + (dot / 3) * 0.5, 1 - 0.5 * (dot % 3));
      }
    }
    std::vector<HatchPoint> points;
    const double to = advance * static_cast<double>(cells.size()) + 3;
    for (double x = -0.5; x < to; x += 0.1) {
      for (double y = -0.35; y < 1.36; y += 0.1) {
        HatchPoint point{FromEm(at, {x, y}), false};
        bool slope = false;
        for (const glm::dvec2 dot : dots) {
          const double d = std::hypot(x - dot.x, y - dot.y);
          if (d < 0.12) point = {FromEm(at, dot), true};
          slope = slope || (d >= 0.12 && d < 0.15);
        }
        if (!slope) points.push_back(point);
      }
    }
    return points;
  }

  Script script;
  std::shared_ptr<const SignShapes> shapes;
};

TEST(LineBelief, KnowsTheCellsOfSixDotsWhereNoPageHasMore) {
  const BrailleLine line;
  EXPECT_EQ(line.shapes->size(), 63U);  // all patterns of six dots but the empty one
  EXPECT_NE(line.Sign("dots-123456"), SignGuess::kUnknown);
  EXPECT_EQ(line.Sign("dots-17"), SignGuess::kUnknown);
}

TEST(LineBelief, ReadsSignAfterSignAndFindsSpacesAndTheEnd) {
  const BrailleLine line;
  const SignPlace at{{0.01, -0.02}, kSize, 2 * kDegree};
  const std::vector<std::string> cells = {"dots-134", "dots-135", "dots-135", "",
                                          "dots-1",   "dots-36",  "dots-4"};
  const std::vector<HatchPoint> points = line.Felt(cells, at);
  const LineBelief belief(*line.shapes, kWidth, line.script.space_advance);
  LinePrior prior;
  prior.next = at;
  prior.anywhere = true;
  prior.before = 0.9;
  prior.behind = 0.2;
  bool space = false;
  for (const std::string& cell : cells) {
    if (cell.empty()) {
      space = true;
      continue;
    }
    prior.felt_to = ToEm(prior.next, FromEm(at, {11, 0})).x;
    const NextOnLine next = belief.Next(points, prior);
    ASSERT_FALSE(next.end) << cell;
    EXPECT_EQ(next.space, space) << cell;
    EXPECT_EQ(next.sign.sign, line.Sign(cell)) << cell;
    EXPECT_GT(next.sign.probability, 0.8) << cell;
    space = false;
    prior.next = next.sign.place;
    prior.next.origin = FromEm(prior.next, {line.shapes->Advance(next.sign.sign), 0});
    prior.anywhere = false;
  }
  EXPECT_TRUE(belief.Next(points, prior).end);
}

TEST(LineBelief, ReadsAllCells) {
  const BrailleLine line;
  const SignPlace at{{0, 0}, kSize, 0};
  const LineBelief belief(*line.shapes, kWidth, line.script.space_advance);
  for (std::size_t sign = 0; sign < line.shapes->size(); ++sign) {
    const std::string& name = line.script.glyphs[line.shapes->GlyphOf(sign)].name;
    LinePrior prior;
    prior.next = at;
    prior.felt_to = 4;
    EXPECT_EQ(belief.Next(line.Felt({name, "dots-12346"}, at), prior).sign.sign, sign) << name;
  }
}

TEST(LineBelief, WhatNoSignHasIsUnknown) {
  const BrailleLine line;
  const SignPlace at{{0, 0}, kSize, 0};
  std::vector<HatchPoint> points = line.Felt({"dots-1"}, at);
  // a bar as wide as a ridge, felt as closely as a hand feels one
  for (double x = 0; x < 0.7; x += 0.08) {
    for (double y = 0.15; y < 0.4; y += 0.075) points.push_back({FromEm(at, {x, y}), true});
  }
  const LineBelief belief(*line.shapes, kWidth, line.script.space_advance);
  LinePrior prior;
  prior.next = at;
  prior.felt_to = 4;
  EXPECT_EQ(belief.Next(points, prior).sign.sign, SignGuess::kUnknown);
}

// Signs may begin a little before the one before them ends; what both then cover is felt but once.
// Half of what ink on a line is worth is its cost.
TEST(LineBelief, InkIsNotClaimedByTwo) {
  const BrailleLine line;
  const SignPlace at{{0, 0}, kSize, 0};
  std::vector<HatchPoint> points;
  for (double y = -0.2; y < 1.2; y += 0.002) points.push_back({FromEm(at, {0.55, y}), true});
  const LineBelief belief(*line.shapes, kWidth, line.script.space_advance);
  LinePrior prior;
  prior.next = at;
  prior.felt_to = 4;
  prior.anywhere = true;
  prior.before = 0.9;
  prior.behind = 0.2;
  EXPECT_LT(belief.Fit(points, prior, LineBelief::Steps::kFine), 2 * belief.CostOfInk(points, at));
}

/// What a hand without any error feels of a page of one line of Moon whose letters are linked.
struct LinkedLine {
  explicit LinkedLine(const std::string& text) : script(FindScript("moon")) {
    style = DefaultStyle(kSize, Relief::kEngraved, script);
    style.links.reach = LinkReach::kLetters;
    set = SetText(text, script, style, FindPage("a4"));
    shapes = KnownShapes(script, set.pages);
    links = KnownLinks(shapes, script, style)(kSize);
    at = {set.pages.front().glyphs.front().origin_P, kSize, 0};
  }

  std::vector<HatchPoint> Felt() const {
    const TextPage& page = set.pages.front();
    const GrooveLinks found = LinkPage(page, script, style);
    std::vector<HatchPoint> points;
    for (double x = -0.5; x < 12; x += 0.1) {
      for (double y = -0.4; y < 1.4; y += 0.05) {
        HatchPoint point;
        point.p = point.felt = FromEm(at, {x, y});
        const double letter = ToLetters(page, point.p), link = ToLinks(found, point.p, false);
        point.of_link = letter > 0.25 * style.width && link < 0.25 * style.width &&
                        ToLinks(found, point.p, true) > 0.25 * style.width;
        point.ink = std::min(letter, link) < 0.25 * style.width;
        if (point.ink || std::min(letter, link) > 0.5 * style.width) points.push_back(point);
      }
    }
    return points;
  }
  bool IsOfLetter(glm::dvec2 p) const {
    return ToLetters(set.pages.front(), p) < 0.25 * style.width;
  }
  /// Without spaces.
  std::string Read(const std::vector<HatchPoint>& points) const {
    const LineBelief belief(*shapes, style.width, script.space_advance);
    LinePrior prior;
    prior.next = at;
    prior.links = links.get();
    std::string read;
    for (int i = 0; i < 20; ++i) {
      prior.felt_to = ToEm(prior.next, FromEm(at, {12, 0})).x;
      const NextOnLine next = belief.Next(points, prior);
      if (next.end) break;
      const bool known = next.sign.sign != SignGuess::kUnknown;
      read += known ? script.glyphs[shapes->GlyphOf(next.sign.sign)].name : "?";
      prior.next.origin =
          FromEm(next.sign.place, {known ? shapes->Advance(next.sign.sign) : 0.6, 0});
      prior.claimed = 1;
      prior.left = known ? std::optional(next.sign.sign) : std::nullopt;
    }
    return read;
  }

  Script script;
  TypeStyle style;
  Typeset set;
  std::shared_ptr<const SignShapes> shapes;
  std::shared_ptr<const LinkShapes> links;
  SignPlace at;

 private:
  double ToLetters(const TextPage& page, glm::dvec2 p) const {
    double least = 1;
    for (const PlacedGlyph& placed : page.glyphs) {
      for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
        for (const Piece& piece : stroke.pieces) {
          least = std::min(least, DistanceTo(Placed(piece, kSize, placed.origin_P), p));
        }
      }
    }
    return least;
  }
  static double ToLinks(const GrooveLinks& found, glm::dvec2 p, bool deep) {
    double least = 1;
    for (const GrooveLink& link : found.links) {
      const LinkShape& shape = found.shapes[link.shape];
      const double length = Length(shape.spine);
      double begin = 0;
      for (const Piece& piece : shape.spine) {
        for (double s = 0; s < Length(piece); s += 1e-4) {
          const double along = begin + s;
          if (deep && along > shape.from_level && along < length - shape.to_level) continue;
          least = std::min(least, glm::distance(PointAt(piece, s) + link.origin_P, p));
        }
        begin += Length(piece);
      }
    }
    return least;
  }
};

TEST(LineBelief, ReadsLinkedLettersBesideTheirLinks) {
  for (const std::string text : {"yes", "vapour", "jig", "moon"}) {
    const LinkedLine line(text);
    EXPECT_EQ(line.Read(line.Felt()), text);
  }
}

TEST(LineBelief, LinksExplainWhatIsFeltOfThemAndNothingElse) {
  const LinkedLine line("vapour");
  const LineBelief belief(*line.shapes, line.style.width, line.script.space_advance);
  LinePrior apart, linked;
  apart.next = linked.next = line.at;
  apart.felt_to = linked.felt_to = 12;
  apart.behind = linked.behind = 0.1;
  linked.links = line.links.get();
  std::vector<HatchPoint> points = line.Felt();
  const double gain = belief.Fit(points, linked, LineBelief::Steps::kFine) -
                      belief.Fit(points, apart, LineBelief::Steps::kFine);
  EXPECT_GT(gain, 20);
  std::vector<HatchPoint> letters;
  for (const HatchPoint& point : points) {
    if (!point.ink || line.IsOfLetter(point.p)) letters.push_back(point);
  }
  EXPECT_LT(belief.Fit(letters, linked, LineBelief::Steps::kFine) -
                belief.Fit(letters, apart, LineBelief::Steps::kFine),
            gain);
}

TEST(LineFrame, FindsSizeTurnAndBaseLineOfALine) {
  const BrailleLine line;
  const LineBelief belief(*line.shapes, kWidth, line.script.space_advance);
  for (const double turn : {-2.7}) {
    const SignPlace at{{0.003, -0.004}, kSize, turn * kDegree};
    // l, e, g, o, with dots in all rows
    const std::vector<HatchPoint> points =
        line.Felt({"dots-123", "dots-15", "dots-1245", "dots-135"}, at);
    FrameRange range;
    range.met = FromEm(at, {0.5, 0.5});
    range.from = -0.25;
    range.to = 1.25;
    for (const double scale : {0.82, 0.9, 0.98, 1.06, 1.2}) range.sizes.push_back(scale * kSize);
    range.turns = {-2 * kDegree, 0, 2 * kDegree};
    range.felt_to = FromEm(at, {6, 0});
    range.before = 0.9;
    range.behind = 0.2;
    const FrameFit fit = FitFrame(belief, points, range);
    EXPECT_GT(fit.log_likelihood, 20);
    // to half of the steps that are tried, 1 percent and 0.35 degrees, and a little more
    EXPECT_NEAR(fit.frame.size / kSize, 1, 0.025) << turn;
    EXPECT_NEAR(fit.frame.turn / kDegree, turn, 0.8) << turn;
    EXPECT_NEAR(ToEm(at, fit.frame.origin).y, 0, 0.06) << turn;
  }
}

// A frame that explains a line's beginning, off by what the first look may be off: a turn that
// lifts the line's end by a third of an em is beyond one step of each number.
TEST(LineFrame, ALongerLineMendsWhatItsBeginningTold) {
  const BrailleLine line;
  const LineBelief belief(*line.shapes, kWidth, line.script.space_advance);
  const SignPlace at{{0.003, -0.004}, kSize, 1 * kDegree};
  const std::vector<HatchPoint> points =
      line.Felt({"dots-123", "dots-15", "dots-1245", "dots-135", "", "dots-135", "dots-123",
                 "dots-15", "dots-1245", "dots-234", "dots-2345", "dots-15"},
                at);
  FrameRange range;
  range.felt_to = FromEm(at, {16, 0});
  range.before = 0.9;
  range.behind = 0.2;
  SignPlace told = at;
  told.turn += 1.3 * kDegree;
  told.size *= 1.02;
  told.origin = FromEm(at, {0, -0.05});
  const FrameFit fit = RefineFrame(belief, points, range, told);
  EXPECT_GT(fit.log_likelihood, 20);
  EXPECT_NEAR(fit.frame.turn / kDegree, 1, 0.35);  // a step
  EXPECT_NEAR(fit.frame.size / kSize, 1, 0.02);    // dots tell it hardly finer
  EXPECT_NEAR(ToEm(at, fit.frame.origin).y, 0, 0.06);
}

TEST(LineFrame, FindsNoneWhereThereIsNoInk) {
  const BrailleLine line;
  const LineBelief belief(*line.shapes, kWidth, line.script.space_advance);
  FrameRange range;
  range.from = 0;
  range.to = 1;
  range.sizes = {kSize};
  range.turns = {0};
  range.felt_to = {0.1, 0};
  EXPECT_LT(FitFrame(belief, line.Felt({""}, {{0, 0}, kSize, 0}), range).log_likelihood, 0);
}

}  // namespace
}  // namespace moontrace
