#include "textures/relief/groove_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <set>

#include "tests/textures/sample_page.h"
#include "textures/field/field.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/relief/link.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

SamplePage Linked(const std::string& text, double size, LinkReach reach = LinkReach::kWords) {
  SamplePage sample;
  sample.script = FindScript("moon");
  TypeStyle style = DefaultStyle(size, Relief::kEngraved, sample.script);
  style.links.reach = reach;
  sample.typeset = SetText(text, sample.script, style, {"custom", 0.5, 0.5, 0.02});
  return sample;
}

GrooveLinks LinksOf(const SamplePage& sample) {
  return LinkPage(sample.typeset.pages.front(), sample.script, sample.typeset.style);
}

double LengthOf(const std::vector<Piece>& path) {
  double length = 0;
  for (const Piece& piece : path) length += Length(piece);
  return length;
}

/// Walls of a placed glyph's strokes, taken from the script itself; dots as their centres.
std::vector<LinkWall> WallsOf(const SamplePage& sample, const PlacedGlyph& placed) {
  std::vector<LinkWall> walls;
  const TypeStyle& style = sample.typeset.style;
  for (const Stroke& stroke : sample.script.glyphs[placed.glyph].strokes) {
    if (stroke.kind == StrokeKind::kFill) continue;  // within the ring of H
    Box box;
    for (const Piece& piece : stroke.pieces) {
      const Piece at = Placed(piece, style.size, placed.origin_P);
      Include(box, BoundsOf(at));
      if (stroke.kind == StrokeKind::kStroke) walls.push_back({at, style.width / 2});
    }
    const glm::dvec2 middle = 0.5 * (box.min + box.max);
    const double radius = std::max(0.5 * (box.max.x - box.min.x), style.width / 2);
    if (stroke.kind == StrokeKind::kDot) walls.push_back({Line{middle, middle}, radius});
  }
  return walls;
}

const char* const kText =
    "the quick brown fox jumps over the lazy dog. sphinx of black quartz, judge my vow! 1984 "
    "(30-27) 56?";

class LinkedSizes : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Sizes, LinkedSizes, ::testing::Values(0.020, 0.012));

TEST_P(LinkedSizes, JoinsEveryLetterOfALineWithoutACorner) {
  const SamplePage sample = Linked(kText, GetParam());
  const GrooveLinks links = LinksOf(sample);
  const auto& glyphs = sample.typeset.pages.front().glyphs;
  EXPECT_EQ(links.missing, 0u);
  std::set<std::size_t> joined;
  for (const GrooveLink& link : links.links) {
    if (link.from != link.to) joined.insert(link.from);
    const std::vector<Piece> spine = SpineOf(links, link);
    for (std::size_t i = 1; i < spine.size(); ++i) {
      EXPECT_LT(glm::distance(EndOf(spine[i - 1]), StartOf(spine[i])), 1e-12);
      EXPECT_GT(glm::dot(TangentAt(spine[i - 1], Length(spine[i - 1])), TangentAt(spine[i], 0)),
                1 - 1e-9);
    }
  }
  for (std::size_t i = 0; i + 1 < glyphs.size(); ++i) {
    EXPECT_EQ(joined.count(i), glyphs[i].line == glyphs[i + 1].line ? 1u : 0u) << i;
  }
}

// At an open stroke's end the link goes on in the direction of travel.
TEST_P(LinkedSizes, LeavesAndArrivesInTheDirectionOfTravel) {
  const SamplePage sample = Linked("lak", GetParam());
  const GrooveLinks links = LinksOf(sample);
  ASSERT_EQ(links.links.size(), 2u);
  const auto& glyphs = sample.typeset.pages.front().glyphs;
  for (const GrooveLink& link : links.links) {
    const auto& from = sample.script.glyphs[glyphs[link.from].glyph].strokes.back().pieces.back();
    const auto& to = sample.script.glyphs[glyphs[link.to].glyph].strokes.front().pieces.front();
    const std::vector<Piece> spine = SpineOf(links, link);
    const double em = sample.typeset.style.size;
    EXPECT_LT(glm::distance(StartOf(spine.front()), EndOf(from) * em + glyphs[link.from].origin_P),
              1e-9);  // a shape is shared by places that are equal to a nanometre
    EXPECT_LT(glm::distance(EndOf(spine.back()), StartOf(to) * em + glyphs[link.to].origin_P),
              1e-9);
    EXPECT_GT(glm::dot(TangentAt(spine.front(), 0), TangentAt(from, Length(from))), 1 - 1e-9);
    EXPECT_GT(glm::dot(TangentAt(spine.back(), Length(spine.back())), TangentAt(to, 0)), 1 - 1e-9);
  }
}

// Everywhere but over its first and last part (3.5 w at a ring, 2 w else; to the other letters
// everywhere) a link keeps a quarter of the width to every stroke of the line.
TEST_P(LinkedSizes, KeepTheGapToAllStrokesOfTheirLine) {
  const SamplePage sample = Linked(kText, GetParam());
  const GrooveLinks links = LinksOf(sample);
  const double w = sample.typeset.style.width;
  const auto& glyphs = sample.typeset.pages.front().glyphs;
  for (const GrooveLink& link : links.links) {
    const std::vector<Piece> spine = SpineOf(links, link);
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
      if (glyphs[i].line != glyphs[link.from].line) continue;
      const double begin = i == link.from ? 3.5 * w : 0, end = i == link.to ? 3.5 * w : 0;
      for (const LinkWall& wall : WallsOf(sample, glyphs[i])) {
        EXPECT_GE(LeastGap(spine, w / 2, wall, begin, end, w / 50), 0.25 * w * (1 - 1e-9))
            << "link " << link.from << " to " << link.to << ", glyph " << i;
      }
    }
  }
}

// Half the line pitch above and below the letters' middle, less half the link's width.
TEST(GrooveLinks, KeepToTheirLine) {
  const SamplePage sample = Linked(kText, 0.012);
  const TypeStyle& style = sample.typeset.style;
  const GrooveLinks links = LinksOf(sample);
  for (const GrooveLink& link : links.links) {
    const double base = sample.typeset.pages.front().glyphs[link.from].origin_P.y;
    for (const Piece& piece : SpineOf(links, link)) {
      const double far = (style.line_pitch - style.width) / 2;
      EXPECT_LE(std::abs(BoundsOf(piece).max.y - base - style.size / 2), far);
      EXPECT_LE(std::abs(BoundsOf(piece).min.y - base - style.size / 2), far);
    }
  }
}

TEST(GrooveLinks, ReachAsFarAsAskedFor) {
  const auto between = [](LinkReach reach) {
    std::vector<std::size_t> from;
    for (const GrooveLink& link : LinksOf(Linked("la la", 0.012, reach)).links) {
      if (link.from != link.to) from.push_back(link.from);
    }
    return from;
  };
  EXPECT_EQ(between(LinkReach::kNone), (std::vector<std::size_t>{}));
  EXPECT_EQ(between(LinkReach::kLetters), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(between(LinkReach::kWords), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(GrooveLinks, JoinTheSeparateStrokesOfALetterButNotThoseThatTouch) {
  const GrooveLinks th = LinksOf(Linked("the", 0.012));  // bar and dot
  ASSERT_EQ(th.links.size(), 1u);
  EXPECT_EQ(th.links[0].from, th.links[0].to);
  EXPECT_TRUE(LinksOf(Linked("h", 0.012)).links.empty());  // the ring holds its filled part
}

TEST(GrooveLinks, OfEqualPairsAreStoredOnce) {
  const GrooveLinks links = LinksOf(Linked("lalalala", 0.012));
  EXPECT_EQ(links.links.size(), 7u);
  EXPECT_LE(links.shapes.size(), 4u);  // la and al, first and next to another link
}

// With a gap that no letters leave, there are none, and they are counted.
TEST(GrooveLinks, AreCountedWhereThereIsNoRoom) {
  SamplePage sample = Linked("mean", 0.012);
  sample.typeset.style.links.gap = 0.012;
  const GrooveLinks links = LinksOf(sample);
  EXPECT_EQ(links.links.size(), 0u);
  EXPECT_EQ(links.missing, 3u);
}

// Along every link's centre line: full depth at its ends, its own in the middle of a long one,
// and never a step.
TEST(GrooveLinks, BecomeShallowerWithoutAStep) {
  const SamplePage sample = Linked("l a", 0.012);
  const TypeStyle& style = sample.typeset.style;
  const GrooveLinks links = LinksOf(sample);
  ASSERT_EQ(links.links.size(), 1u);
  const TextureField field(BuildTexture(sample.typeset.pages.front(), sample.script, style));
  const std::vector<Piece> spine = SpineOf(links, links.links[0]);
  const double length = LengthOf(spine), step = 1e-6;
  double before = -style.depth, deepest = 0, shallowest = 1;
  for (const Piece& piece : spine) {
    for (double s = 0; s <= Length(piece); s += step) {
      const double now = field.SampleAt(PointAt(piece, s)).displacement;
      ASSERT_LE(std::abs(now - before), field.greatest_slope() * step * 1.01);
      before = now;
      deepest = std::min(deepest, now);
      shallowest = std::min(shallowest, -now);
    }
  }
  EXPECT_GT(length, 0.012);
  EXPECT_NEAR(-deepest, style.depth, 1e-9);
  EXPECT_NEAR(shallowest, 0.6 * style.depth, 1e-9);
  EXPECT_NEAR(-before, style.depth, 1e-6);
}

}  // namespace
}  // namespace moontrace
