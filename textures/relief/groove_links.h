#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "textures/field/texture.h"
#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"
#include "textures/typeset/typeset.h"

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
  std::size_t crossings = 0;      ///< pairs of links that run into each other, ends at a dot aside
};

/// Joins what `style.links` asks for: from the end of a letter's last stroke to the start of the
/// next letter's first, and between the separate strokes of one letter (of letters that are
/// joined). Not from line to line. A ring is left and entered anywhere, in its direction of travel;
/// a dot from any side; a filled area lies within its letter's strokes and is not joined. Links
/// keep the gap to all strokes of both letters and of their neighbours in the line (FindLink), and
/// to their own line's half of the space between lines, so that they never meet those of other
/// lines. They keep it to each other as well where there is room: for a link that has none the one
/// before makes room, if it can; else they cross, steeply if possible, and are counted.
GrooveLinks LinkPage(const TextPage& page, const Script& script, const TypeStyle& style);

class LinkFinder;

/// Finds the links of pages one by one. Equal letters that stand equally are searched once for all
/// of them. Script and style must outlive it.
class PageLinker {
 public:
  PageLinker(const Script& script, const TypeStyle& style);
  ~PageLinker();
  PageLinker(const PageLinker&) = delete;
  PageLinker& operator=(const PageLinker&) = delete;

  /// Finds a page's links and keeps them there (TextPage::links); nothing where none are asked for.
  void Keep(TextPage& page);

 private:
  std::unique_ptr<LinkFinder> finder_;  ///< none where no links are asked for
};

/// Keeps the links of all pages. `alive` is told the share done, 0 to 1, before each page.
void LinkPages(Typeset& set, const Script& script, const std::function<void(double)>& alive = {});

/// The links that a page keeps, or else those that LinkPage finds; never null.
std::shared_ptr<const GrooveLinks> LinksOf(const TextPage& page, const Script& script,
                                           const TypeStyle& style);

/// A link's elements: at each end as deep as the letters, then fading to its own depth, since a tip
/// does not climb a step.
Group BuildLink(const LinkShape& shape, const TypeStyle& line_style);

/// The links of a page as shared groups where they stand, in the order of `links`.
std::vector<Placement> LinkPlacements(const GrooveLinks& links, const Script& script,
                                      const TypeStyle& style);

/// A link's centre line on the page.
std::vector<Piece> SpineOf(const GrooveLinks& links, const GrooveLink& link);

}  // namespace moontrace
