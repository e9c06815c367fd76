#include "textures/groove_links.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "textures/link.h"

namespace moontrace {
namespace {

constexpr int kRingRays = 12, kDotRays = 8;
constexpr double kTurn = 6.283185307179586476925;
constexpr double kLeastTurn = 0.6, kWidestTurn = 1.25;  // radius of the sharpest turn [w]
constexpr double kReachTurn = 0.45;                     // of the room above and below a line
constexpr double kRoomAside = 1;                        // beyond both letters along the line [em]
constexpr double kOpenOwn = 2;      // own length of a link at a stroke's end [w]
constexpr double kRingOwn = 3.5;    // at a ring, which it leaves along a tangent [w]
constexpr double kOpenLevel = 0.5;  // of it as deep as the letters [w]
constexpr double kRingLevel = 2;    // until a tangent has parted from the ring's groove [w]

double Mean(double a, double b) { return 0.5 * (a + b); }

bool IsRing(const Stroke& stroke, double width) {
  const Piece &first = stroke.pieces.front(), &last = stroke.pieces.back();
  return glm::distance(EndOf(last), StartOf(first)) < 1e-2 * width &&
         glm::dot(TangentAt(last, Length(last)), TangentAt(first, 0)) > 0.94;
}

/// A glyph made ready for linking, in its own frame [m].
struct Letter {
  std::vector<Stroke> parts;    ///< strokes and dots in writing order
  std::vector<LinkWall> walls;  ///< with its inner links
  Box box;                      ///< of the centre lines
  std::vector<std::vector<Piece>> inner;
  /// Directions of inner links where they leave the first part and reach the last; of dots only.
  std::optional<glm::dvec2> leaves_first, reaches_last;
  std::size_t missing = 0;
};

struct LinkEnds {
  LinkEnd end;
  double level = 0;  ///< [m]
};

class PageLinker {
 public:
  PageLinker(const Script& script, const TypeStyle& style, LineKind kind)
      : script_(script), style_(LineStyle(kind, style, script)), kind_(kind) {
    half_ = style_.width / 2;
    gap_ = style_.links.gap.value_or(style_.width / 4);
    const double between = Mean(style_.line_pitch, -style_.size);
    reach_ = std::max(between - half_ - gap_ / 2, 0.0);
    if (style.rules.lines) reach_ = std::min(reach_, std::max(RuleGap(style) - gap_, 0.0));
    // turns as wide as the space between lines lets them be
    radius_ =
        std::clamp(kReachTurn * reach_, kLeastTurn * style_.width, kWidestTurn * style_.width);
  }

  LineKind kind() const { return kind_; }

  const Letter& LetterOf(std::size_t glyph) {
    const auto [at, is_new] = letters_.try_emplace(glyph);
    if (is_new) at->second = MakeLetter(script_.glyphs.at(glyph));
    return at->second;
  }

  /// From a glyph's last stroke to the next glyph's first; frames by `offset`.
  std::vector<Piece> Between(std::size_t a, std::size_t b, glm::dvec2 offset,
                             const std::vector<LinkWall>& others, const std::vector<Ray>& crossed,
                             std::optional<glm::dvec2> arrived, LinkShape& shape) {
    const Letter &first = LetterOf(a), &second = LetterOf(b);
    if (first.parts.empty() || second.parts.empty()) return {};
    LinkEnds from = EndsOf(first.parts.back(), true, arrived ? arrived : first.reaches_last);
    LinkEnds to = EndsOf(second.parts.front(), false, second.leaves_first);
    for (Ray& ray : to.end.rays) ray.point += offset;
    from.end.walls = first.walls;
    for (const LinkWall& wall : second.walls) {
      to.end.walls.push_back({Placed(wall.piece, 1, offset), wall.half});
    }
    shape.from_level = from.level;
    shape.to_level = to.level;
    return Find(from.end, to.end, first.box, Moved(second.box, offset), others, crossed, false);
  }

  /// Where further letters stand in a link's way; empty if they do not.
  bool IsNear(const std::vector<Piece>& spine, std::size_t glyph, glm::dvec2 at) {
    Box box;
    for (const Piece& piece : spine) Include(box, BoundsOf(piece));
    const Letter& letter = LetterOf(glyph);
    if (letter.walls.empty() || !Overlap(Grown(box, 3 * half_ + gap_), Moved(letter.box, at))) {
      return false;
    }
    for (const LinkWall& wall : WallsAt(glyph, at)) {
      if (LeastGap(spine, half_, wall, 0, 0, gap_ / 4 + half_ / 8) < gap_) return true;
    }
    return false;
  }

  std::vector<LinkWall> WallsAt(std::size_t glyph, glm::dvec2 at) {
    std::vector<LinkWall> walls;
    for (const LinkWall& wall : LetterOf(glyph).walls) {
      walls.push_back({Placed(wall.piece, 1, at), wall.half});
    }
    return walls;
  }

  double OpenLevel() const { return kOpenLevel * style_.width; }
  const TypeStyle& style() const { return style_; }

 private:
  /// `straight`: the direction in which another link passes this end. A dot is left within 60
  /// degrees of it, since a tip that turned back would find the groove that it came by.
  LinkEnds EndsOf(const Stroke& stroke, bool leaving, std::optional<glm::dvec2> straight) const {
    LinkEnds ends{{{}, {}, kOpenOwn * style_.width}, OpenLevel()};
    if (stroke.kind == StrokeKind::kDot) {
      const glm::dvec2 middle = CenterOf(stroke);
      for (int i = 0; i < kDotRays; ++i) {
        const double angle = kTurn * i / kDotRays;
        const glm::dvec2 way(std::cos(angle), std::sin(angle));
        if (!straight || glm::dot(way, *straight) > 0.49) ends.end.rays.push_back({middle, way});
      }
      ends.level += DotRadius(stroke);
    } else if (IsRing(stroke, style_.width)) {
      double length = 0;
      for (const Piece& piece : stroke.pieces) length += Length(piece);
      for (int i = 0; i < kRingRays; ++i)
        ends.end.rays.push_back(RayAt(stroke, length * i / kRingRays));
      ends.end.own = kRingOwn * style_.width;
      ends.level = kRingLevel * style_.width;
    } else if (leaving) {
      const Piece& last = stroke.pieces.back();
      ends.end.rays = {{EndOf(last), TangentAt(last, Length(last))}};
    } else {
      ends.end.rays = {{StartOf(stroke.pieces.front()), TangentAt(stroke.pieces.front(), 0)}};
    }
    return ends;
  }

  static Ray RayAt(const Stroke& stroke, double s) {
    for (const Piece& piece : stroke.pieces) {
      const double length = Length(piece);
      if (s < length) return {PointAt(piece, s), TangentAt(piece, s)};
      s -= length;
    }
    return {StartOf(stroke.pieces.front()), TangentAt(stroke.pieces.front(), 0)};
  }

  static glm::dvec2 CenterOf(const Stroke& dot) {
    Box box;
    for (const Piece& piece : dot.pieces) Include(box, BoundsOf(piece));
    return 0.5 * (box.min + box.max);
  }
  double DotRadius(const Stroke& dot) const {
    Box box;
    for (const Piece& piece : dot.pieces) Include(box, BoundsOf(piece));
    return std::max(0.5 * (box.max.x - box.min.x), half_);
  }

  std::vector<LinkWall> WallsOf(const Stroke& stroke) const {
    if (stroke.kind == StrokeKind::kDot) {
      const glm::dvec2 middle = CenterOf(stroke);
      return {{Line{middle, middle}, DotRadius(stroke)}};
    }
    std::vector<LinkWall> walls;
    const double half = stroke.kind == StrokeKind::kStroke ? half_ : 0;
    for (const Piece& piece : stroke.pieces) walls.push_back({piece, half});
    return walls;
  }

  /// Whether a tip gets from one to the other without a link: their grooves run into each other.
  bool Touch(const Stroke& a, const std::vector<LinkWall>& walls) const {
    for (const LinkWall& own : WallsOf(a)) {
      const double length = Length(own.piece);
      const int count = 1 + static_cast<int>(length / (half_ / 2));
      for (int i = 0; i <= count; ++i) {
        const glm::dvec2 p = PointAt(own.piece, length * i / count);
        for (const LinkWall& wall : walls) {
          if (DistanceTo(wall.piece, p) < half_) return true;
        }
      }
    }
    return false;
  }

  Letter MakeLetter(const Glyph& glyph) {
    Letter letter;
    for (const Stroke& stroke : glyph.strokes) {
      if (stroke.pieces.empty()) continue;
      Stroke placed{stroke.kind, {}};
      for (const Piece& piece : stroke.pieces) {
        if (Length(piece) > 0) placed.pieces.push_back(Placed(piece, style_.size, {0, 0}));
      }
      if (placed.pieces.empty()) continue;
      for (const LinkWall& wall : WallsOf(placed)) {
        letter.walls.push_back(wall);
        Include(letter.box, BoundsOf(wall.piece));
      }
      if (stroke.kind != StrokeKind::kFill) letter.parts.push_back(std::move(placed));
    }
    std::vector<LinkWall> joined;
    for (std::size_t i = 0; i < letter.parts.size(); ++i) {
      const Stroke& part = letter.parts[i];
      if (i > 0 && !Touch(part, joined)) AddInner(letter.parts[i - 1], part, letter);
      for (const LinkWall& wall : WallsOf(part)) joined.push_back(wall);
    }
    return letter;
  }

  void AddInner(const Stroke& a, const Stroke& b, Letter& letter) const {
    const std::optional<glm::dvec2> arrived = letter.reaches_last;
    letter.reaches_last.reset();
    LinkEnds from = EndsOf(a, true, arrived), to = EndsOf(b, false, std::nullopt);
    from.end.walls = letter.walls;
    std::vector<Piece> spine = Find(from.end, to.end, letter.box, letter.box, {}, {}, true);
    if (spine.empty()) {
      ++letter.missing;
      return;
    }
    for (const Piece& piece : spine) {
      letter.walls.push_back({piece, half_});
      Include(letter.box, BoundsOf(piece));
    }
    if (&a == &letter.parts.front()) letter.leaves_first = TangentAt(spine.front(), 0);
    letter.reaches_last = TangentAt(spine.back(), Length(spine.back()));
    letter.inner.push_back(std::move(spine));
  }

  /// Places below, above, beside, between and in the letters, and four directions through each.
  std::vector<Ray> Ways(const Box& a, const Box& b) const {
    const double aside = 2 * half_ + 1.2 * gap_;
    const auto along = [aside](double a0, double a1, double b0, double b1) {
      std::vector<double> all = {std::min(a0, b0) - aside, Mean(a0, a1), Mean(b0, b1),
                                 std::max(a1, b1) + aside};
      if (a1 < b0) all.push_back(Mean(a1, b0));
      if (b1 < a0) all.push_back(Mean(b1, a0));
      return all;
    };
    std::vector<double> ys = along(a.min.y, a.max.y, b.min.y, b.max.y);
    // a second way below and above, farther out, beyond a link that runs there already
    ys.push_back(std::min(a.min.y, b.min.y) - aside - 2 * half_ - gap_);
    ys.push_back(std::max(a.max.y, b.max.y) + aside + 2 * half_ + gap_);
    std::vector<Ray> ways;
    for (const double x : along(a.min.x, a.max.x, b.min.x, b.max.x)) {
      for (const double y : ys) {
        for (const glm::dvec2 way :
             {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
          ways.push_back({{x, y}, way});
        }
      }
    }
    return ways;
  }

  std::vector<Piece> Find(const LinkEnd& from, const LinkEnd& to, const Box& a, const Box& b,
                          const std::vector<LinkWall>& others, const std::vector<Ray>& crossed,
                          bool one_letter) const {
    LinkTask task{from, to, one_letter, others, crossed, half_, gap_, radius_, {}, Ways(a, b)};
    task.room = a;
    Include(task.room, b);
    const double em = style_.size, beyond = kRoomAside * em;
    if (style_.lines == LineDirection::kVertical) {
      const double middle = Mean(a.min.x, a.max.x);
      task.room = {{middle - em / 2 - reach_, task.room.min.y - beyond},
                   {middle + em / 2 + reach_, task.room.max.y + beyond}};
    } else {
      task.room = {{task.room.min.x - beyond, -reach_}, {task.room.max.x + beyond, em + reach_}};
    }
    return FindLink(task);
  }

  const Script& script_;
  TypeStyle style_;
  LineKind kind_;
  double half_ = 0, gap_ = 0;  // [m]
  double radius_ = 0;          // of the sharpest turn [m]
  double reach_ = 0;           // above the top line and below the base line [m]
  std::map<std::size_t, Letter> letters_;
};

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

  PageLinker& LinkerOf(std::size_t i) {
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
    PageLinker& linker = LinkerOf(i);
    const std::size_t glyph = page_.glyphs[i].glyph;
    const Letter& letter = linker.LetterOf(glyph);
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
    const Letter& letter = LinkerOf(i).LetterOf(page_.glyphs[i].glyph);
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
        if (begin + s < kRingOwn * width) continue;
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
    PageLinker& linker = LinkerOf(i);
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
    LinkShape shape;
    shape.kind = linker.kind();
    shape.spine = linker.Between(page_.glyphs[i].glyph, page_.glyphs[i + 1].glyph, Offset(i, i + 1),
                                 others, crossed, Arrival(i), shape);
    if (shape.spine.empty()) return kNone;
    list_.shapes.push_back(std::move(shape));
    return at->second = list_.shapes.size() - 1;
  }

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const TextPage& page_;
  LinkReach reach_;
  PageLinker plain_, heading_;
  std::map<Key, std::size_t> found_;
  GrooveLinks list_;
};

}  // namespace

std::optional<LinkReach> LinkReachOf(std::string_view name) {
  for (const LinkReach reach : {LinkReach::kNone, LinkReach::kLetters, LinkReach::kWords}) {
    if (NameOf(reach) == name) return reach;
  }
  return std::nullopt;
}

std::string NameOf(LinkReach reach) {
  if (reach == LinkReach::kNone) return "none";
  return reach == LinkReach::kLetters ? "letters" : "words";
}

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
