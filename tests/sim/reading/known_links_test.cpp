#include "sim/reading/known_links.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/reading/reading_setup.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/groove_links.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kSize = 0.008;

struct Known {
  explicit Known(LinkReach reach) : script(FindScript("moon")) {
    style = DefaultStyle(kSize, Relief::kEngraved, script);
    style.links.reach = reach;
    shapes = KnownShapes(script, {});
    links = KnownLinks(shapes, script, style)(kSize);
  }
  std::size_t SignOf(std::size_t glyph) const {
    std::size_t sign = 0;
    while (sign < shapes->size() && shapes->GlyphOf(sign) != glyph) ++sign;
    return sign;
  }

  Script script;
  TypeStyle style;
  std::shared_ptr<const SignShapes> shapes;
  std::shared_ptr<const LinkShapes> links;
};

/// The greatest distance of a page's links of two letters from what is known of them [em].
double Farthest(const Known& known, const std::string& text, bool over_a_space) {
  const Typeset set = SetText(text, known.script, known.style, FindPage("a4"));
  const TextPage& page = set.pages.front();
  const GrooveLinks found = LinkPage(page, known.script, known.style);
  double far = 0;
  for (const GrooveLink& link : found.links) {
    if (link.from == link.to) continue;
    const std::size_t a = known.SignOf(page.glyphs[link.from].glyph);
    const std::size_t b = known.SignOf(page.glyphs[link.to].glyph);
    const LinkShapes::Link& shape =
        over_a_space ? known.links->Across(a, b) : known.links->Next(a, b);
    const std::vector<Piece> spine = SpineOf(found, link);
    double along = 0;
    for (const Piece& piece : spine) {
      for (double s = 0; s < Length(piece); s += 0.02 * kSize) {
        const glm::dvec2 p = (PointAt(piece, s) - page.glyphs[link.from].origin_P) / kSize;
        far = std::max(far, shape.Distance(p));
        if (along + s < found.shapes[link.shape].from_level) {
          far = std::max(far, shape.DistanceToDeep(p));
        }
      }
      along += Length(piece);
    }
  }
  EXPECT_FALSE(found.links.empty()) << text;
  return far;
}

// Two letters have no neighbours that their link must go round. The bound is half a point's
// distance from the next, 0.015, and a cell's half diagonal, 0.021.
TEST(KnownLinks, AreThoseOfAPage) {
  const Known known(LinkReach::kLetters);
  for (const std::string text : {"sz", "yo", "um", "gd", "pa", "cc", "oe"}) {
    EXPECT_LT(Farthest(known, text, false), 0.036) << text;
  }
  EXPECT_FALSE(known.links->LinksWords());
}

TEST(KnownLinks, ReachOverSpacesWhereWordsAreLinked) {
  const Known known(LinkReach::kWords);
  EXPECT_LT(Farthest(known, "a t", true), 0.036);
}

TEST(KnownLinks, OutliveWhatTheyWereMadeOf) {
  std::function<std::shared_ptr<const LinkShapes>(double)> links;
  {
    const Known known(LinkReach::kLetters);
    links = KnownLinks(known.shapes, known.script, known.style);
  }
  EXPECT_TRUE(links(kSize)->Next(0, 1).exists());
}

}  // namespace
}  // namespace moontrace
