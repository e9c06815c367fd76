#include "textures/relief/groove_links.h"

#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <utility>

#include "textures/relief/letter_links.h"

namespace moontrace {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::size_t kBefore = 2;  // links that one may meet: longer ones are none's

}  // namespace

/// Finds the links of pages, and keeps the shapes found for all of them.
class LinkFinder {
 public:
  LinkFinder(const Script& script, const TypeStyle& style)
      : reach_(style.links.reach),
        plain_(script, style, LineKind::kPlain),
        heading_(script, style, LineKind::kHeading) {}

  GrooveLinks Find(const TextPage& page) {
    page_ = &page;
    list_ = {};
    not_free_.clear();
    listed_.clear();
    between_.assign(page.glyphs.size(), kNone);
    for (std::size_t i = 0; i < page.glyphs.size(); ++i) {
      if (Joins(i) && !AddBetween(i)) ++list_.missing;
    }
    for (std::size_t i = 0; i < page.glyphs.size(); ++i) {
      ListInner(i);
      if (between_[i] != kNone) List(between_[i], i, i + 1);
    }
    for (const std::size_t i : not_free_) {
      for (const std::size_t j : LinksBefore(i)) list_.crossings += Meet(j, i);
    }
    return std::move(list_);
  }

 private:
  using Key = std::vector<long>;
  /// How a link keeps to others: apart from them, and from the way on from the letter that it leads
  /// to, or across them.
  enum class Way { kApart, kLeavesWayOn, kCrossing };

  LetterLinks& LinkerOf(std::size_t i) {
    return GlyphAt(i).kind == LineKind::kHeading ? heading_ : plain_;
  }
  const PlacedGlyph& GlyphAt(std::size_t i) const { return page_->glyphs[i]; }
  const std::vector<Piece>& SpineAt(std::size_t i) const { return shapes_[between_[i]].spine; }

  bool InLine(std::size_t i, std::size_t j) const {
    return j < page_->glyphs.size() && GlyphAt(i).line == GlyphAt(j).line;
  }

  bool Joins(std::size_t i) const {
    // a running head is not read on from its words to the page's number
    if (!InLine(i, i + 1) || GlyphAt(i).kind == LineKind::kHead) return false;
    return reach_ == LinkReach::kWords || GlyphAt(i).word == GlyphAt(i + 1).word;
  }

  void List(std::size_t shape, std::size_t from, std::size_t to) {
    const auto [at, is_new] = listed_.try_emplace(shape, list_.shapes.size());
    if (is_new) list_.shapes.push_back(shapes_[shape]);
    list_.links.push_back({at->second, from, to, GlyphAt(from).origin_P});
  }

  void ListInner(std::size_t i) {
    LetterLinks& linker = LinkerOf(i);
    const std::size_t glyph = GlyphAt(i).glyph;
    const LinkedLetter& letter = linker.LetterOf(glyph);
    list_.missing += letter.missing;
    for (std::size_t n = 0; n < letter.inner.size(); ++n) {
      const Key key = {-1, static_cast<long>(linker.kind()), static_cast<long>(glyph),
                       static_cast<long>(n)};
      const auto [at, is_new] = found_.try_emplace(key, shapes_.size());
      if (is_new) {
        curves_.push_back(CurvesOf(letter.inner[n]));
        shapes_.push_back({letter.inner[n], linker.OpenLevel(), linker.OpenLevel(), linker.kind()});
      }
      List(at->second, i, i);
    }
  }

  /// The place of glyph `j` seen from `i`, to a nanometre: what stands equally is then equal, in
  /// whatever order it is found.
  glm::dvec2 Offset(std::size_t i, std::size_t j) const {
    return 1e-9 * glm::round(1e9 * (GlyphAt(j).origin_P - GlyphAt(i).origin_P));
  }

  /// The letters before and behind a pair.
  std::vector<std::size_t> Neighbours(std::size_t i) const {
    std::vector<std::size_t> neighbours;
    if (i > 0 && InLine(i, i - 1)) neighbours.push_back(i - 1);
    if (InLine(i, i + 2)) neighbours.push_back(i + 2);
    return neighbours;
  }

  /// The letters before whose links may come near to that of letter `i`.
  std::vector<std::size_t> LinksBefore(std::size_t i) const {
    std::vector<std::size_t> before;
    for (std::size_t n = 1; n <= kBefore && n <= i; ++n) {
      if (InLine(i, i - n) && between_[i - n] != kNone) before.push_back(i - n);
    }
    return before;
  }

  bool MeetsNeighbour(std::size_t i, std::size_t shape) {
    for (const std::size_t j : Neighbours(i)) {
      if (LinkerOf(i).IsNear(curves_[shape], GlyphAt(j).glyph, Offset(i, j))) return true;
    }
    return false;
  }

  bool MeetsLink(std::size_t i, std::size_t shape, const std::vector<std::size_t>& links) {
    for (const std::size_t j : links) {
      if (LinkerOf(i).AreNear(curves_[shape], curves_[between_[j]], Offset(i, j))) return true;
    }
    return false;
  }

  bool IsOneDot(std::size_t i) {
    const LinkedLetter& letter = LinkerOf(i).LetterOf(GlyphAt(i).glyph);
    return letter.parts.size() == 1 && letter.parts[0].kind == StrokeKind::kDot;
  }

  /// Whether a link is found for the letter and the next.
  bool AddBetween(std::size_t i) {
    const std::vector<std::size_t> before = LinksBefore(i);
    std::size_t alone = ShapeOf(i, false, {}, Way::kApart);
    const bool meets = alone != kNone && MeetsNeighbour(i, alone);
    if (meets) alone = ShapeOf(i, true, {}, Way::kApart);
    between_[i] = alone;
    if (alone == kNone || !MeetsLink(i, alone, before)) return alone != kNone;
    between_[i] = ShapeOf(i, true, before, Way::kApart);
    if (between_[i] != kNone || MakesRoom(i, alone)) return true;
    const std::size_t crossing = ShapeOf(i, true, before, Way::kCrossing);
    between_[i] = crossing != kNone ? crossing : alone;
    not_free_.push_back(i);
    return true;
  }

  /// Leads the link before another way, if both are then free of each other: round the link
  /// that is in its way, or so that it leaves the way on from the letter between free.
  bool MakesRoom(std::size_t i, std::size_t shape) {
    if (i == 0 || between_[i - 1] == kNone || IsOneDot(i) || IsOneDot(i - 1)) return false;
    const std::size_t before = between_[i - 1];
    std::vector<std::size_t> about = LinksBefore(i - 1);
    between_[i] = shape;
    if (!MeetsLink(i, shape, about)) {
      about.push_back(i);
      between_[i - 1] = ShapeOf(i - 1, true, about, Way::kApart);
      if (between_[i - 1] != kNone) return true;
      about.pop_back();
    }
    between_[i - 1] = ShapeOf(i - 1, true, about, Way::kLeavesWayOn);
    if (between_[i - 1] != kNone) {
      between_[i] = ShapeOf(i, true, LinksBefore(i), Way::kApart);
      if (between_[i] != kNone) return true;
    }
    between_[i - 1] = before;
    return false;
  }

  /// The direction in which the link before reaches a letter that is one dot.
  std::optional<glm::dvec2> Arrival(std::size_t i) {
    if (i == 0 || !InLine(i, i - 1) || between_[i - 1] == kNone || !IsOneDot(i)) {
      return std::nullopt;
    }
    const Piece& last = SpineAt(i - 1).back();
    return TangentAt(last, Length(last));
  }

  /// The number of a shape, found once for equal pairs that stand equally.
  std::size_t ShapeOf(std::size_t i, bool with_neighbours, const std::vector<std::size_t>& links,
                      Way way) {
    LetterLinks& linker = LinkerOf(i);
    Key key = {static_cast<long>(linker.kind()), static_cast<long>(way),
               static_cast<long>(GlyphAt(i).glyph)};
    const auto add = [&](std::size_t what, std::size_t at) {
      const glm::dvec2 offset = 1e9 * Offset(i, at);
      key.insert(key.end(),
                 {static_cast<long>(what), std::lround(offset.x), std::lround(offset.y)});
    };
    const std::vector<std::size_t> near =
        with_neighbours ? Neighbours(i) : std::vector<std::size_t>();
    add(GlyphAt(i + 1).glyph, i + 1);
    for (const std::size_t j : near) add(GlyphAt(j).glyph, j);
    key.push_back(-2);
    for (const std::size_t j : links) add(between_[j], j);
    LinkSurroundings about;
    about.arrived = Arrival(i);
    if (about.arrived) {
      key.insert(key.end(),
                 {-3, std::lround(1e3 * std::atan2(about.arrived->y, about.arrived->x))});
    }
    const auto [at, is_new] = found_.try_emplace(key, kNone);
    if (!is_new) return at->second;
    for (const std::size_t j : near) {
      for (const LinkWall& wall : linker.WallsAt(GlyphAt(j).glyph, Offset(i, j))) {
        about.others.push_back(wall);
      }
    }
    for (const std::size_t j : links) {
      for (const Piece& piece : SpineAt(j)) about.links.push_back(Placed(piece, 1, Offset(i, j)));
    }
    about.may_cross = way == Way::kCrossing;
    if (way == Way::kLeavesWayOn) {
      about.links.push_back(linker.WayOn(GlyphAt(i + 1).glyph, Offset(i, i + 1)));
    }
    LetterLink link =
        linker.Between(GlyphAt(i).glyph, GlyphAt(i + 1).glyph, Offset(i, i + 1), about);
    if (link.spine.empty()) return kNone;
    curves_.push_back(CurvesOf(link.spine));
    shapes_.push_back({std::move(link.spine), link.from_level, link.to_level, linker.kind()});
    return at->second = shapes_.size() - 1;
  }

  /// Whether the grooves of two links run into each other, where they share a dot aside.
  bool Meet(std::size_t i, std::size_t j) {
    return LinkerOf(i).RunInto(SpineAt(i), SpineAt(j), Offset(i, j), i + 1 == j && IsOneDot(j));
  }

  LinkReach reach_;
  LetterLinks plain_, heading_;
  std::map<Key, std::size_t> found_;
  std::vector<LinkShape> shapes_;
  std::vector<std::vector<Curve>> curves_;     ///< of the shapes
  const TextPage* page_ = nullptr;             ///< that is looked at now
  std::vector<std::size_t> between_;           ///< shapes by the glyph where they begin
  std::vector<std::size_t> not_free_;          ///< letters whose links come near to one before
  std::map<std::size_t, std::size_t> listed_;  ///< numbers of shapes in the page's list
  GrooveLinks list_;
};

GrooveLinks LinkPage(const TextPage& page, const Script& script, const TypeStyle& style) {
  if (style.links.reach == LinkReach::kNone) return {};
  return LinkFinder(script, style).Find(page);
}

PageLinker::PageLinker(const Script& script, const TypeStyle& style) {
  if (style.links.reach != LinkReach::kNone) finder_ = std::make_unique<LinkFinder>(script, style);
}

PageLinker::~PageLinker() = default;

void PageLinker::Keep(TextPage& page) {
  if (finder_ != nullptr) page.links = std::make_shared<const GrooveLinks>(finder_->Find(page));
}

void LinkPages(Typeset& set, const Script& script, const std::function<void(double)>& alive) {
  if (set.style.links.reach == LinkReach::kNone) return;
  PageLinker linker(script, set.style);
  for (std::size_t i = 0; i < set.pages.size(); ++i) {
    if (alive) alive(static_cast<double>(i) / static_cast<double>(set.pages.size()));
    linker.Keep(set.pages[i]);
  }
}

std::shared_ptr<const GrooveLinks> LinksOf(const TextPage& page, const Script& script,
                                           const TypeStyle& style) {
  if (page.links != nullptr) return page.links;
  return std::make_shared<const GrooveLinks>(LinkPage(page, script, style));
}

std::vector<Placement> LinkPlacements(const GrooveLinks& links, const Script& script,
                                      const TypeStyle& style) {
  std::vector<std::shared_ptr<const Group>> groups;
  for (const LinkShape& shape : links.shapes) {
    groups.push_back(Finish(BuildLink(shape, LineStyle(shape.kind, style, script))));
  }
  std::vector<Placement> placements;
  for (const GrooveLink& link : links.links) {
    placements.push_back({groups[link.shape], link.origin_P});
  }
  return placements;
}

std::vector<Piece> SpineOf(const GrooveLinks& links, const GrooveLink& link) {
  std::vector<Piece> spine;
  for (const Piece& piece : links.shapes[link.shape].spine) {
    spine.push_back(Placed(piece, 1, link.origin_P));
  }
  return spine;
}

}  // namespace moontrace
