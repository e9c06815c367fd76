#include "textures/relief/groove_links.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <utility>

#include "textures/relief/letter_links.h"

namespace moontrace {
namespace {

/// One page's links, and the shapes found for them.
class LinkList {
 public:
  LinkList(const TextPage& page, const Script& script, const TypeStyle& style)
      : page_(page),
        reach_(style.links.reach),
        plain_(script, style, LineKind::kPlain),
        heading_(script, style, LineKind::kHeading) {}

  GrooveLinks Take() {
    for (std::size_t i = 0; i < page_.glyphs.size(); ++i) {
      AddInner(i);
      if (Joins(i)) AddBetween(i);
    }
    return std::move(list_);
  }

 private:
  using Key = std::vector<long>;

  LetterLinks& LinkerOf(std::size_t i) {
    return page_.glyphs[i].kind == LineKind::kHeading ? heading_ : plain_;
  }

  bool InLine(std::size_t i, std::size_t j) const {
    return j < page_.glyphs.size() && page_.glyphs[i].line == page_.glyphs[j].line;
  }

  bool Joins(std::size_t i) const {
    if (!InLine(i, i + 1)) return false;
    return reach_ == LinkReach::kWords || page_.glyphs[i].word == page_.glyphs[i + 1].word;
  }

  void AddInner(std::size_t i) {
    LetterLinks& linker = LinkerOf(i);
    const std::size_t glyph = page_.glyphs[i].glyph;
    const LinkedLetter& letter = linker.LetterOf(glyph);
    list_.missing += letter.missing;
    for (std::size_t n = 0; n < letter.inner.size(); ++n) {
      const Key key = {-1, static_cast<long>(linker.kind()), static_cast<long>(glyph),
                       static_cast<long>(n)};
      const auto [at, is_new] = found_.try_emplace(key, list_.shapes.size());
      if (is_new) {
        list_.shapes.push_back(
            {letter.inner[n], linker.OpenLevel(), linker.OpenLevel(), linker.kind()});
      }
      list_.links.push_back({at->second, i, i, page_.glyphs[i].origin_P});
    }
  }

  void AddBetween(std::size_t i) {
    std::size_t shape = ShapeBetween(i, false, {});
    const bool meets = shape != kNone && MeetsNeighbour(i, list_.shapes[shape].spine);
    if (meets) shape = ShapeBetween(i, true, {});
    if (shape == kNone) {
      ++list_.missing;
      return;
    }
    // the link by which this letter is reached: another way, if there is one, that parts from it
    const std::vector<Ray> before = RaysBefore(i);
    if (RunsAlong(list_.shapes[shape].spine, before, LinkerOf(i).style().width)) {
      const std::size_t apart = ShapeBetween(i, meets, before);
      if (apart != kNone) shape = apart;
    }
    list_.links.push_back({shape, i, i + 1, page_.glyphs[i].origin_P});
  }

  glm::dvec2 Offset(std::size_t i, std::size_t j) const {
    return page_.glyphs[j].origin_P - page_.glyphs[i].origin_P;
  }

  /// The letters before and behind a pair.
  std::vector<std::size_t> Neighbours(std::size_t i) const {
    std::vector<std::size_t> neighbours;
    if (i > 0 && InLine(i, i - 1)) neighbours.push_back(i - 1);
    if (InLine(i, i + 2)) neighbours.push_back(i + 2);
    return neighbours;
  }

  bool MeetsNeighbour(std::size_t i, const std::vector<Piece>& spine) {
    for (const std::size_t j : Neighbours(i)) {
      if (LinkerOf(i).IsNear(spine, page_.glyphs[j].glyph, Offset(i, j))) return true;
    }
    return false;
  }

  /// The direction in which the link before reaches a letter that is one dot.
  std::optional<glm::dvec2> Arrival(std::size_t i) {
    const LinkedLetter& letter = LinkerOf(i).LetterOf(page_.glyphs[i].glyph);
    if (letter.parts.size() != 1 || letter.parts[0].kind != StrokeKind::kDot) return std::nullopt;
    if (list_.links.empty() || list_.links.back().to != i) return std::nullopt;
    const Piece& last = list_.shapes[list_.links.back().shape].spine.back();
    return TangentAt(last, Length(last));
  }

  /// Points of the link before, seen from glyph `i`.
  std::vector<Ray> RaysBefore(std::size_t i) {
    std::vector<Ray> rays;
    if (list_.links.empty() || list_.links.back().to != i) return rays;
    const GrooveLink& link = list_.links.back();
    const double spacing = LinkerOf(i).style().width / 4;
    for (const Piece& piece : list_.shapes[link.shape].spine) {
      const double length = Length(piece);
      const int count = 1 + static_cast<int>(length / spacing);
      for (int n = 0; n <= count; ++n) {
        const double s = length * n / count;
        rays.push_back({PointAt(piece, s) + Offset(i, link.from), TangentAt(piece, s)});
      }
    }
    return rays;
  }

  static bool RunsAlong(const std::vector<Piece>& spine, const std::vector<Ray>& rays,
                        double width) {
    double begin = 0;
    for (const Piece& piece : spine) {
      const double length = Length(piece);
      const int count = 1 + static_cast<int>(4 * length / width);
      for (int n = 0; n <= count; ++n) {
        const double s = length * n / count;
        if (begin + s < kRingLinkOwn * width) continue;
        const glm::dvec2 p = PointAt(piece, s), way = TangentAt(piece, s);
        for (const Ray& ray : rays) {
          const glm::dvec2 a = ray.direction;
          if (glm::distance(ray.point, p) < width && std::abs(a.x * way.y - a.y * way.x) < 0.6) {
            return true;
          }
        }
      }
      begin += length;
    }
    return false;
  }

  /// The number of a shape, found once for equal pairs that stand equally to a nanometre.
  std::size_t ShapeBetween(std::size_t i, bool with_neighbours, const std::vector<Ray>& crossed) {
    LetterLinks& linker = LinkerOf(i);
    std::vector<std::size_t> letters = {i, i + 1};
    if (with_neighbours) {
      for (const std::size_t j : Neighbours(i)) letters.push_back(j);
    }
    Key key = {static_cast<long>(linker.kind())};
    std::vector<LinkWall> others;
    for (std::size_t n = 0; n < letters.size(); ++n) {
      const std::size_t glyph = page_.glyphs[letters[n]].glyph;
      const glm::dvec2 offset = Offset(i, letters[n]);
      key.push_back(static_cast<long>(glyph));
      key.push_back(std::lround(1e9 * offset.x));
      key.push_back(std::lround(1e9 * offset.y));
      if (n < 2) continue;
      for (const LinkWall& wall : linker.WallsAt(glyph, offset)) others.push_back(wall);
    }
    if (const std::optional<glm::dvec2> arrived = Arrival(i)) {
      key.push_back(-3);
      key.push_back(std::lround(1e3 * std::atan2(arrived->y, arrived->x)));
    }
    if (!crossed.empty()) {
      key.push_back(-2);
      key.push_back(static_cast<long>(list_.links.back().shape));
    }
    const auto [at, is_new] = found_.try_emplace(key, kNone);
    if (!is_new) return at->second;
    LetterLink link = linker.Between(page_.glyphs[i].glyph, page_.glyphs[i + 1].glyph,
                                     Offset(i, i + 1), others, crossed, Arrival(i));
    if (link.spine.empty()) return kNone;
    list_.shapes.push_back({std::move(link.spine), link.from_level, link.to_level, linker.kind()});
    return at->second = list_.shapes.size() - 1;
  }

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const TextPage& page_;
  LinkReach reach_;
  LetterLinks plain_, heading_;
  std::map<Key, std::size_t> found_;
  GrooveLinks list_;
};

}  // namespace

GrooveLinks LinkPage(const TextPage& page, const Script& script, const TypeStyle& style) {
  if (style.links.reach == LinkReach::kNone) return {};
  return LinkList(page, script, style).Take();
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
