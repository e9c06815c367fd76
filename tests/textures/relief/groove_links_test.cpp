#include "textures/relief/groove_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

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

/// 220 of the commonest words of English.
const char* const kCommonWords =
    "the of and to in is you that it he was for on are as with his they at be this have "
    "from or one had by word but not what all were we when your can said there use an "
    "each which she do how their if will up other about out many then them these so "
    "some her would make like him into time has look two more write go see number no "
    "way could people my than first water been call who its now find long down day did "
    "get come made may part over new sound take only little work know place year live "
    "me back give most very after thing our just name good sentence man think say great "
    "where help through much before line right too mean old any same tell boy follow "
    "came want show also around form three small set put end does another well large "
    "must big even such because turn here why ask went men read need land different "
    "home us move try kind hand picture again change off play spell air away animal "
    "house point page letter mother answer found study still learn should world high "
    "every near add food between own below country plant last school father keep tree "
    "never start city earth eye light thought head under ";

/// Pairs of links that come nearer to each other than their grooves' rims, by points along both, an
/// eighth of the width apart: no more than 0.1 widths from the truth, and links that keep their gap
/// are 1.25 apart. The two at a letter of one dot share it: 2 widths from there are left out.
std::size_t PairsThatMeet(const SamplePage& sample, const GrooveLinks& links) {
  const double w = sample.typeset.style.width;
  std::vector<std::vector<glm::dvec2>> all;
  for (const GrooveLink& link : links.links) {
    std::vector<glm::dvec2> points;
    for (const Piece& piece : SpineOf(links, link)) {
      for (double s = 0; s <= Length(piece); s += w / 8) points.push_back(PointAt(piece, s));
    }
    if (link.from != link.to) all.push_back(points);
  }
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < std::min(i + 3, all.size()); ++j) {
      const bool share = glm::distance(all[i].back(), all[j].front()) < w / 4;
      const std::size_t own = share ? 16 : 0;
      bool meet = false;
      for (std::size_t a = 0; a + own < all[i].size() && !meet; ++a) {
        for (std::size_t b = own; b < all[j].size() && !meet; ++b) {
          meet = glm::distance(all[i][a], all[j][b]) < 1.15 * w;
        }
      }
      pairs += meet ? 1 : 0;
    }
  }
  return pairs;
}

/// The longest part of a link that runs beside a stroke of the letter which it leaves [m]: within
/// 30 degrees of its direction and 2.25 widths, the link's first 2 widths aside.
double RunsBesideItsLetter(const SamplePage& sample, const GrooveLinks& links,
                           const GrooveLink& link) {
  const double w = sample.typeset.style.width, step = w / 20;
  const std::vector<LinkWall> walls = WallsOf(sample, sample.typeset.pages[0].glyphs[link.from]);
  double at = 0, beside = 0, longest = 0;
  for (const Piece& piece : SpineOf(links, link)) {
    for (double s = 0; s < Length(piece); s += step, at += step) {
      const auto is_beside = [&](const LinkWall& wall) {
        const double own = Length(wall.piece);
        for (double u = 0; u <= own; u += step) {
          if (glm::distance(PointAt(wall.piece, u), PointAt(piece, s)) > 2.25 * w) continue;
          if (std::abs(glm::dot(TangentAt(wall.piece, u), TangentAt(piece, s))) > 0.866)
            return true;
        }
        return false;
      };
      beside = at > 2 * w && std::any_of(walls.begin(), walls.end(), is_beside) ? beside + step : 0;
      longest = std::max(longest, beside);
    }
  }
  return longest;
}

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

// Where lines are 1.8 em apart the sharpest turn is 1.25 widths.
TEST_P(LinkedSizes, BendGently) {
  const SamplePage sample = Linked(kText, GetParam());
  const GrooveLinks links = LinksOf(sample);
  for (const LinkShape& shape : links.shapes) {
    for (const Piece& piece : shape.spine) {
      const std::optional<Arc> arc = ArcOf(piece);
      EXPECT_TRUE(!arc || arc->radius >= 1.25 * sample.typeset.style.width * (1 - 1e-9));
    }
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

// A finger on the way back along a bar would take the link for a second one.
TEST_P(LinkedSizes, LeaveACornerWithoutRunningBackAlongIt) {
  std::vector<std::string> texts = {"army", "mammal", "mmm", "yyy"};
  for (const char a : std::string("elmy")) {
    for (char b = 'a'; b <= 'z'; ++b) texts.push_back({a, b});
  }
  for (const std::string& text : texts) {
    const SamplePage sample = Linked(text, GetParam());
    const GrooveLinks links = LinksOf(sample);
    for (const GrooveLink& link : links.links) {
      if (std::string("elmy").find(text[link.from]) == std::string::npos) continue;
      EXPECT_LT(RunsBesideItsLetter(sample, links, link), 2 * sample.typeset.style.width)
          << text << " from " << link.from;
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

TEST(GrooveLinks, OfCommonWordsDoNotCross) {
  std::istringstream words(kCommonWords);
  std::size_t count = 0, crossings = 0;
  for (std::string word; words >> word; ++count) {
    const SamplePage sample = Linked(word, 0.012);
    const GrooveLinks links = LinksOf(sample);
    EXPECT_EQ(PairsThatMeet(sample, links), links.crossings) << word;
    EXPECT_EQ(links.missing, 0u) << word;
    crossings += links.crossings;
  }
  EXPECT_EQ(count, 220u);
  EXPECT_EQ(crossings, 0u);
}

// Letters without a space between them, and a wide gap: there is not room for all.
TEST(GrooveLinks, ThatCrossAreCounted) {
  SamplePage sample = Linked("gugmgy", 0.012);
  TypeStyle style = sample.typeset.style;
  style.letter_gap = -0.004;
  sample.typeset = SetText("gugmgy", sample.script, style, {"custom", 0.5, 0.5, 0.02});
  const GrooveLinks links = LinksOf(sample);
  EXPECT_EQ(PairsThatMeet(sample, links), links.crossings);
  EXPECT_GT(links.crossings, 0u);
}

TEST(LinkPages, KeepsTheLinksForAllWhoReadThePage) {
  SamplePage sample = Linked("the moon", 0.012);
  const TextPage& page = sample.typeset.pages.front();
  EXPECT_EQ(page.links, nullptr);
  LinkPages(sample.typeset, sample.script);
  const auto kept = LinksOf(page, sample.script, sample.typeset.style);
  EXPECT_EQ(kept, page.links);
  EXPECT_EQ(kept, LinksOf(TextPage(page), sample.script, sample.typeset.style));
  EXPECT_EQ(kept->links.size(), 5u);
  const GrooveLinks found = LinksOf(sample);
  ASSERT_EQ(found.links.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(SpineOf(*kept, kept->links[i]), SpineOf(found, found.links[i]));
  }
}

// What is built of a page follows the links that it keeps, and looks for no others.
TEST(LinkPages, IsWhatTheTextureIsBuiltOf) {
  SamplePage sample = Linked("la", 0.012);
  TextPage& page = sample.typeset.pages.front();
  page.links = std::make_shared<const GrooveLinks>();
  const TextureField field(BuildTexture(page, sample.script, sample.typeset.style));
  const GrooveLinks links = LinkPage(page, sample.script, sample.typeset.style);
  const std::vector<Piece> spine = SpineOf(links, links.links.front());
  EXPECT_EQ(field.SampleAt(PointAlong(spine, LengthOf(spine) / 2)).displacement, 0);
}

TEST(LinkPages, GivesEqualLettersThatStandEquallyTheSameLinksOnAllPages) {
  SamplePage sample = Linked("moon", 0.012);
  std::string text;
  for (int i = 0; i < 50; ++i) text += "moon\n";
  sample.typeset = SetText(text, sample.script, sample.typeset.style, {"custom", 0.2, 0.1, 0.01});
  ASSERT_GT(sample.typeset.pages.size(), 5u);
  std::vector<double> shares;
  LinkPages(sample.typeset, sample.script, [&](double done) { shares.push_back(done); });
  const GrooveLinks& first = *sample.typeset.pages.front().links;
  for (const TextPage& page : sample.typeset.pages) {
    ASSERT_EQ(page.links->shapes.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(page.links->shapes[i].spine, first.shapes[i].spine);
    }
  }
  EXPECT_EQ(shares.size(), sample.typeset.pages.size());
  EXPECT_EQ(shares.front(), 0);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LT(shares.back(), 1);
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

// A tip that comes out of a stroke is held through the first turn.
TEST(GrooveLinks, AreAsDeepAsTheLettersThroughTheTurnBehindAStroke) {
  const SamplePage sample = Linked("it", 0.012);  // a bar downwards, then over to the right
  const GrooveLinks links = LinksOf(sample);
  ASSERT_EQ(links.links.size(), 1u);
  const std::vector<Piece> spine = SpineOf(links, links.links.front());
  ASSERT_TRUE(ArcOf(spine.front()));
  const TypeStyle& style = sample.typeset.style;
  const TextureField field(BuildTexture(sample.typeset.pages.front(), sample.script, style));
  for (double s = 0; s <= Length(spine.front()); s += 1e-5) {
    ASSERT_NEAR(field.SampleAt(PointAt(spine.front(), s)).displacement, -style.depth, 1e-9);
  }
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
