#include "textures/field/piece.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "textures/base/overload.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

glm::dvec2 NearestOnLine(const Line& line, glm::dvec2 p) {
  const glm::dvec2 along = line.to - line.from;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? glm::dot(p - line.from, along) / length2 : 0;
  return line.from + std::clamp(t, 0.0, 1.0) * along;
}

glm::dvec2 NearestOnArc(const Arc& arc, glm::dvec2 p) {
  const glm::dvec2 v = p - arc.center;
  if (IsWhole(arc) || AngleAlong(arc, v) <= std::abs(arc.sweep)) {
    const double distance = glm::length(v);
    return distance > 0 ? arc.center + v * (arc.radius / distance)
                        : arc.center + arc.radius * DirectionOf(arc.start);
  }
  const glm::dvec2 start = StartOf(arc), end = EndOf(arc);
  return glm::dot(p - start, p - start) <= glm::dot(p - end, p - end) ? start : end;
}

/// The box of an arc's ends, grown by the circle's four extreme points, as far as they lie on the
/// arc.
void IncludeExtremes(Box& box, const Arc& arc) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const glm::dvec2 way = DirectionOf(quarter * kTurn / 4);
    if (IsWhole(arc) || AngleAlong(arc, way) <= std::abs(arc.sweep)) {
      Include(box, arc.center + arc.radius * way);
    }
  }
}

}  // namespace

void Include(Box& box, glm::dvec2 p) {
  box.min = glm::min(box.min, p);
  box.max = glm::max(box.max, p);
}
void Include(Box& box, const Box& other) {
  box.min = glm::min(box.min, other.min);
  box.max = glm::max(box.max, other.max);
}
Box Grown(const Box& box, double by) { return {box.min - by, box.max + by}; }
Box Moved(const Box& box, glm::dvec2 by) { return {box.min + by, box.max + by}; }
bool Contains(const Box& box, glm::dvec2 p) noexcept {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
}
bool Overlap(const Box& a, const Box& b) noexcept {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

bool IsWhole(const Arc& arc) noexcept { return std::abs(arc.sweep) >= kTurn; }

double SweepOf(const Arc& arc) noexcept { return std::clamp(arc.sweep, -kTurn, kTurn); }

double AngleFrom(double start, double sense, glm::dvec2 v) noexcept {
  const double turned = sense * (std::atan2(v.y, v.x) - start);
  return turned - kTurn * std::floor(turned / kTurn);
}

double AngleAlong(const Arc& arc, glm::dvec2 v) noexcept {
  return AngleFrom(arc.start, arc.sweep < 0 ? -1 : 1, v);
}

std::optional<Arc> ArcOf(const Piece& piece) {
  return std::visit(Overload{[](const Line&) { return std::optional<Arc>(); },
                             [](const Arc& arc) { return std::optional(arc); }},
                    piece);
}

glm::dvec2 StartOf(const Piece& piece) {
  return std::visit(
      Overload{
          [](const Line& line) { return line.from; },
          [](const Arc& arc) { return arc.center + arc.radius * DirectionOf(arc.start); },
      },
      piece);
}

glm::dvec2 EndOf(const Piece& piece) {
  return std::visit(Overload{
                        [](const Line& line) { return line.to; },
                        [](const Arc& arc) {
                          return arc.center + arc.radius * DirectionOf(arc.start + SweepOf(arc));
                        },
                    },
                    piece);
}

double Length(const Piece& piece) {
  return std::visit(Overload{
                        [](const Line& line) { return glm::length(line.to - line.from); },
                        [](const Arc& arc) { return arc.radius * std::abs(SweepOf(arc)); },
                    },
                    piece);
}

double Length(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces) length += Length(piece);
  return length;
}

glm::dvec2 PointAt(const Piece& piece, double s) {
  const double length = Length(piece);
  const double share = length > 0 ? std::clamp(s / length, 0.0, 1.0) : 0;
  return std::visit(
      Overload{
          [share](const Line& line) { return line.from + share * (line.to - line.from); },
          [share](const Arc& arc) {
            return arc.center + arc.radius * DirectionOf(arc.start + share * SweepOf(arc));
          },
      },
      piece);
}

glm::dvec2 PointAlong(const std::vector<Piece>& pieces, double s) {
  for (const Piece& piece : pieces) {
    const double length = Length(piece);
    if (s <= length) return PointAt(piece, s);
    s -= length;
  }
  return EndOf(pieces.back());
}

glm::dvec2 TangentAt(const Piece& piece, double s) {
  const double length = Length(piece);
  const auto of_line = [length](const Line& line) {
    return length > 0 ? (line.to - line.from) / length : glm::dvec2(1.0, 0.0);
  };
  const auto of_arc = [length, s](const Arc& arc) {
    const double share = length > 0 ? std::clamp(s / length, 0.0, 1.0) : 0;
    const glm::dvec2 outward = DirectionOf(arc.start + share * SweepOf(arc));
    return arc.sweep < 0 ? glm::dvec2(outward.y, -outward.x) : glm::dvec2(-outward.y, outward.x);
  };
  return std::visit(Overload{of_line, of_arc}, piece);
}

glm::dvec2 NearestOn(const Piece& piece, glm::dvec2 p) {
  return std::visit(Overload{[p](const Line& line) { return NearestOnLine(line, p); },
                             [p](const Arc& arc) { return NearestOnArc(arc, p); }},
                    piece);
}

double DistanceTo(const Piece& piece, glm::dvec2 p) { return glm::length(p - NearestOn(piece, p)); }

Piece PartBetween(const Piece& piece, double from, double to) {
  const auto of_line = [=](const Line& line) {
    return Line{PointAt(line, from), PointAt(line, to)};
  };
  const auto of_arc = [=](const Arc& arc) {
    const double rate = arc.sweep / Length(arc);
    return Arc{arc.center, arc.radius, arc.start + from * rate, (to - from) * rate};
  };
  return std::visit<Piece>(Overload{of_line, of_arc}, piece);
}

Piece Placed(const Piece& piece, double scale, glm::dvec2 origin) {
  const auto of_line = [=](const Line& line) {
    return Line{scale * line.from + origin, scale * line.to + origin};
  };
  const auto of_arc = [=](Arc arc) {
    arc.center = scale * arc.center + origin;
    arc.radius *= scale;
    return arc;
  };
  return std::visit<Piece>(Overload{of_line, of_arc}, piece);
}

Box BoundsOf(const Piece& piece) {
  Box box;
  Include(box, StartOf(piece));
  Include(box, EndOf(piece));
  std::visit(Overload{[](const Line&) {}, [&box](const Arc& arc) { IncludeExtremes(box, arc); }},
             piece);
  return box;
}

}  // namespace moontrace
