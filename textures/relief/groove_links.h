#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "textures/field/texture.h"
#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// The centre line of a link, from the origin of the glyph where it begins. Shared: a page has few
/// different pairs of glyphs.
struct LinkShape {
  std::vector<Piece> spine;             ///< [m], in the direction of travel, without a corner
  double from_level = 0, to_level = 0;  ///< first and last length that are as deep as letters [m]
  LineKind kind = LineKind::kPlain;     ///< of the line: decides size and depth
};

/// A link on a page.
struct GrooveLink {
  std::size_t shape = 0;
  std::size_t from = 0, to = 0;  ///< indices into the page's glyphs; equal within a letter
  glm::dvec2 origin_P{0, 0};     ///< [m]
};

struct GrooveLinks {
  std::vector<LinkShape> shapes;
  std::vector<GrooveLink> links;  ///< in the order of the text
  std::size_t missing = 0;        ///< places where none keeps the gap: there the hand must lift
};

/// Joins what `style.links` asks for: from the end of a letter's last stroke to the start of the
/// next letter's first, and between the separate strokes of one letter (of letters that are
/// joined). Not from line to line. A ring is left and entered anywhere, in its direction of travel;
/// a dot from any side; a filled area lies within its letter's strokes and is not joined. Links
/// keep the gap to all strokes of both letters and of their neighbours in the line (FindLink), and
/// to their own line's half of the space between lines, so that they never meet those of other
/// lines. Links may cross each other.
GrooveLinks LinkPage(const TextPage& page, const Script& script, const TypeStyle& style);

/// A link's elements: at each end as deep as the letters, then fading to its own depth, since a tip
/// does not climb a step.
Group BuildLink(const LinkShape& shape, const TypeStyle& line_style);

/// The links of a page as shared groups where they stand, in the order of `links`.
std::vector<Placement> LinkPlacements(const GrooveLinks& links, const Script& script,
                                      const TypeStyle& style);

/// A link's centre line on the page.
std::vector<Piece> SpineOf(const GrooveLinks& links, const GrooveLink& link);

}  // namespace moontrace
