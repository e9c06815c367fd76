#include "textures/relief/letter_links.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "textures/base/units.h"
#include "textures/relief/clearance.h"
#include "textures/typeset/rules.h"

namespace moontrace {

namespace {

constexpr int kRingRays = 12;
constexpr double kLeastTurn = 0.6, kWidestTurn = 1.25;  // radius of the sharpest turn [w]
constexpr double kReachTurn = 0.45;                     // of the room above and below a line
constexpr double kRoomAside = 1;                        // beyond both letters along the line [em]
constexpr double kOpenOwn = 2;      // own length of a link at a stroke's end [w]
constexpr double kOpenLevel = 0.5;  // of it as deep as the letters [w]
constexpr double kRingLevel = 2;    // until a tangent has parted from the ring's groove [w]

double Mean(double a, double b) { return 0.5 * (a + b); }

bool IsRing(const Stroke& stroke, double width) {
  const Piece &first = stroke.pieces.front(), &last = stroke.pieces.back();
  return glm::distance(EndOf(last), StartOf(first)) < 1e-2 * width &&
         glm::dot(TangentAt(last, Length(last)), TangentAt(first, 0)) > 0.94;
}

/// Whether some point of one is nearer than `least` to one of the other, which is moved by `at`.
bool AreNearer(const std::vector<Curve>& a, const std::vector<Curve>& b, glm::dvec2 at,
               double least) {
  for (const Curve& other : b) {
    const Box box = Moved(Grown(other.box, least), at);
    for (const Curve& curve : a) {
      if (Overlap(box, curve.box) && DistanceBetween(curve, Moved(other, at)) < least) return true;
    }
  }
  return false;
}

/// What lies between two lengths along a path.
std::vector<Piece> PartOf(const std::vector<Piece>& path, double from, double to) {
  std::vector<Piece> part;
  double begin = 0;
  for (const Piece& piece : path) {
    const double length = Length(piece);
    const double a = std::clamp(from - begin, 0.0, length), b = std::clamp(to - begin, 0.0, length);
    if (b > a) part.push_back(PartBetween(piece, a, b));
    begin += length;
  }
  return part;
}

}  // namespace

LetterLinks::LetterLinks(const Script& script, const TypeStyle& style, LineKind kind)
    : script_(script), style_(LineStyle(kind, style, script)), kind_(kind) {
  half_ = style_.width / 2;
  gap_ = style_.links.gap.value_or(style_.width / 4);
  const double between = Mean(style_.line_pitch, -style_.size);
  reach_ = std::max(between - half_ - gap_ / 2, 0.0);
  if (style.rules.lines) reach_ = std::min(reach_, std::max(RuleGap(style) - gap_, 0.0));
  // turns as wide as the space between lines lets them be
  radius_ = std::clamp(kReachTurn * reach_, kLeastTurn * style_.width, kWidestTurn * style_.width);
}

const LinkedLetter& LetterLinks::LetterOf(std::size_t glyph) {
  const auto [at, is_new] = letters_.try_emplace(glyph);
  if (is_new) at->second = MakeLetter(script_.glyphs.at(glyph));
  return at->second;
}

LetterLink LetterLinks::Between(std::size_t a, std::size_t b, glm::dvec2 offset,
                                const LinkSurroundings& about) {
  const LinkedLetter &first = LetterOf(a), &second = LetterOf(b);
  if (first.parts.empty() || second.parts.empty()) return {};
  LinkEnds from =
      EndsOf(first.parts.back(), true, about.arrived ? about.arrived : first.reaches_last);
  LinkEnds to = EndsOf(second.parts.front(), false, second.leaves_first);
  for (Ray& ray : to.end.rays) ray.point += offset;
  from.end.walls = first.walls;
  to.end.walls = WallsAt(b, offset);
  LinkTask task;
  task.from = std::move(from.end);
  task.to = std::move(to.end);
  task.others = about.others;
  task.links = about.links;
  task.may_cross = about.may_cross;
  LetterLink link{Find(std::move(task), first.box, Moved(second.box, offset)), from.level,
                  to.level};
  // a tip that comes fast out of a stroke is held through the turn behind its end
  if (!link.spine.empty() && ArcOf(link.spine.front())) {
    link.from_level = std::max(link.from_level, Length(link.spine.front()) + OpenLevel());
  }
  return link;
}

bool LetterLinks::IsNear(const std::vector<Curve>& link, std::size_t glyph, glm::dvec2 at) {
  const LinkedLetter& letter = LetterOf(glyph);
  const Box box = Moved(Grown(letter.box, 2 * half_ + gap_), at);
  for (const Curve& curve : link) {
    if (!Overlap(curve.box, box)) continue;
    for (const LinkWall& wall : letter.walls) {
      const Curve stroke = CurveOf(Placed(wall.piece, 1, at));
      if (DistanceBetween(stroke, curve) < wall.half + half_ + gap_) return true;
    }
  }
  return false;
}

bool LetterLinks::AreNear(const std::vector<Curve>& a, const std::vector<Curve>& b,
                          glm::dvec2 at) const {
  return AreNearer(a, b, at, 2 * half_ + gap_);
}

bool LetterLinks::RunInto(const std::vector<Piece>& a, const std::vector<Piece>& b, glm::dvec2 at,
                          bool share_dot) const {
  const double own = share_dot ? kOpenOwn * style_.width : 0;
  return AreNearer(CurvesOf(PartOf(a, 0, Length(a) - own)), CurvesOf(PartOf(b, own, Length(b))), at,
                   2 * half_);
}

Piece LetterLinks::WayOn(std::size_t glyph, glm::dvec2 at) {
  const LinkedLetter& letter = LetterOf(glyph);
  const Ray end = EndsOf(letter.parts.back(), true, std::nullopt).end.rays.front();
  const glm::dvec2 begin = end.point + at;
  return Line{begin + radius_ * end.direction, begin + style_.line_pitch * end.direction};
}

std::vector<LinkWall> LetterLinks::WallsAt(std::size_t glyph, glm::dvec2 at) {
  std::vector<LinkWall> walls;
  for (const LinkWall& wall : LetterOf(glyph).walls) {
    walls.push_back({Placed(wall.piece, 1, at), wall.half});
  }
  return walls;
}

LinkEnds LetterLinks::EndsOf(const Stroke& stroke, bool leaving,
                             std::optional<glm::dvec2> straight) const {
  LinkEnds ends{{{}, {}, kOpenOwn * style_.width}, OpenLevel()};
  if (stroke.kind == StrokeKind::kDot) {
    ends.end.is_dot = true;
    ends.end.goes_on = straight.has_value();
    ends.end.rays = {{CenterOf(stroke), straight.value_or(glm::dvec2(1, 0))}};
    ends.level += DotRadius(stroke);
  } else if (IsRing(stroke, style_.width)) {
    const double length = Length(stroke.pieces);
    for (int i = 0; i < kRingRays; ++i)
      ends.end.rays.push_back(RayAt(stroke, length * i / kRingRays));
    ends.end.own = kRingLinkOwn * style_.width;
    ends.end.is_ring = true;
    ends.level = kRingLevel * style_.width;
  } else if (leaving) {
    const Piece& last = stroke.pieces.back();
    ends.end.rays = {{EndOf(last), TangentAt(last, Length(last))}};
  } else {
    ends.end.rays = {{StartOf(stroke.pieces.front()), TangentAt(stroke.pieces.front(), 0)}};
  }
  return ends;
}

Ray LetterLinks::RayAt(const Stroke& stroke, double s) {
  for (const Piece& piece : stroke.pieces) {
    const double length = Length(piece);
    if (s < length) return {PointAt(piece, s), TangentAt(piece, s)};
    s -= length;
  }
  return {StartOf(stroke.pieces.front()), TangentAt(stroke.pieces.front(), 0)};
}

glm::dvec2 LetterLinks::CenterOf(const Stroke& dot) {
  Box box;
  for (const Piece& piece : dot.pieces) Include(box, BoundsOf(piece));
  return 0.5 * (box.min + box.max);
}

double LetterLinks::DotRadius(const Stroke& dot) const {
  Box box;
  for (const Piece& piece : dot.pieces) Include(box, BoundsOf(piece));
  return std::max(0.5 * (box.max.x - box.min.x), half_);
}

std::vector<LinkWall> LetterLinks::WallsOf(const Stroke& stroke) const {
  if (stroke.kind == StrokeKind::kDot) {
    const glm::dvec2 middle = CenterOf(stroke);
    return {{Line{middle, middle}, DotRadius(stroke)}};
  }
  std::vector<LinkWall> walls;
  const double half = stroke.kind == StrokeKind::kStroke ? half_ : 0;
  for (const Piece& piece : stroke.pieces) walls.push_back({piece, half});
  return walls;
}

bool LetterLinks::Touch(const Stroke& a, const std::vector<LinkWall>& walls) const {
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

LinkedLetter LetterLinks::MakeLetter(const Glyph& glyph) {
  LinkedLetter letter;
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

void LetterLinks::AddInner(const Stroke& a, const Stroke& b, LinkedLetter& letter) const {
  const std::optional<glm::dvec2> arrived = letter.reaches_last;
  letter.reaches_last.reset();
  LinkEnds from = EndsOf(a, true, arrived), to = EndsOf(b, false, std::nullopt);
  LinkTask task;
  task.from = std::move(from.end);
  task.from.walls = letter.walls;
  task.to = std::move(to.end);
  task.one_letter = true;
  std::vector<Piece> spine = Find(std::move(task), letter.box, letter.box);
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

std::vector<Piece> LetterLinks::Find(LinkTask task, const Box& a, const Box& b) const {
  task.half = half_;
  task.gap = gap_;
  task.radius = radius_;
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

double LetterLinks::OpenLevel() const { return kOpenLevel * style_.width; }

}  // namespace moontrace
