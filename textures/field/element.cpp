#include "textures/field/element.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>

#include "textures/base/overload.h"
#include "textures/field/fill.h"

namespace moontrace {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

glm::dvec2 Direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
bool IsWhole(const Arc& arc) { return std::abs(arc.sweep) >= kTurn; }
/// A whole circle ends where it starts, however far beyond a turn its sweep says.
double SweepOf(const Arc& arc) { return std::clamp(arc.sweep, -kTurn, kTurn); }

/// How far along the sweep the direction of `v` lies, in [0, 2 pi), counted in the arc's own sense.
double AngleAlong(const Arc& arc, glm::dvec2 v) {
  const double turned = std::atan2(v.y, v.x) - arc.start;
  const double along = std::fmod(arc.sweep < 0 ? -turned : turned, kTurn);
  return along < 0 ? along + kTurn : along;
}

/// Vector from the spine to `p`, or nothing where the butt-ended shape does not reach.
std::optional<glm::dvec2> FromSpine(const Line& line, glm::dvec2 p) {
  const glm::dvec2 along = line.to - line.from;
  const double length = glm::length(along);
  if (length == 0) return std::nullopt;
  const glm::dvec2 unit = along / length;
  const double t = glm::dot(p - line.from, unit);
  if (t < 0 || t > length) return std::nullopt;
  return p - line.from - t * unit;
}

std::optional<glm::dvec2> FromSpine(const Arc& arc, glm::dvec2 p) {
  const glm::dvec2 v = p - arc.center;
  if (!IsWhole(arc) && AngleAlong(arc, v) > std::abs(arc.sweep)) return std::nullopt;
  const double distance = glm::length(v);
  // at the centre every direction is nearest: choose none, the gradient there is on the crease set
  if (distance == 0) return glm::dvec2(-arc.radius, 0);
  return v * (1 - arc.radius / distance);
}

/// How far along the spine the foot of `p` lies, 0 at the start and 1 at the end, and its gradient.
struct Along {
  double share = 0;
  glm::dvec2 gradient{0.0, 0.0};  ///< [1/m]
};
Along AlongSpine(const Line& line, glm::dvec2 p) {
  const glm::dvec2 along = line.to - line.from;
  const double length2 = glm::dot(along, along);
  return {glm::dot(p - line.from, along) / length2, along / length2};
}
Along AlongSpine(const Arc& arc, glm::dvec2 p) {
  const glm::dvec2 v = p - arc.center;
  const double square = glm::dot(v, v);
  if (square == 0) return {};
  return {AngleAlong(arc, v) / std::abs(arc.sweep), glm::dvec2(-v.y, v.x) / (square * arc.sweep)};
}

/// The magnitude of a fading profile: by q^2 h(d/q), whose derivative by q is 2 q h - d h'.
Magnitude Faded(const Element& element, const Along& along, glm::dvec2 from_spine) {
  const double u = std::clamp(along.share, 0.0, 1.0);
  const double change = element.fade.to - element.fade.from;
  const double q = element.fade.from + change * u * u * (3 - 2 * u);
  const double distance = glm::length(from_spine);
  const ProfileSample sample = Evaluate(element.profile, distance / q);
  if (sample.height == 0) return {};
  const glm::dvec2 away = distance > 0 ? from_spine / distance : glm::dvec2(0.0, 0.0);
  const double by_q = (2 * q * sample.height - distance * sample.slope) * change * 6 * u * (1 - u);
  return {q * q * sample.height, q * sample.slope * away + by_q * along.gradient};
}

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
                        : arc.center + arc.radius * Direction(arc.start);
  }
  const glm::dvec2 start = StartOf(arc), end = EndOf(arc);
  return glm::dot(p - start, p - start) <= glm::dot(p - end, p - end) ? start : end;
}

glm::dvec2 NearestOn(const Piece& piece, glm::dvec2 p) {
  return std::visit(Overload{[p](const Line& line) { return NearestOnLine(line, p); },
                             [p](const Arc& arc) { return NearestOnArc(arc, p); }},
                    piece);
}

Magnitude ToMagnitude(const ProfileSample& sample, glm::dvec2 from_spine, double distance) {
  if (sample.height == 0) return {};
  return {sample.height,
          distance > 0 ? sample.slope / distance * from_spine : glm::dvec2(0.0, 0.0)};
}

Magnitude Unfaded(const Element& element, glm::dvec2 from_spine) {
  const double distance = glm::length(from_spine);
  return ToMagnitude(Evaluate(element.profile, distance), from_spine, distance);
}

/// `spine` is the element's line or arc.
template <class Spine>
Magnitude OfGroove(const Element& element, const Spine& spine, glm::dvec2 p) {
  const std::optional<glm::dvec2> v = FromSpine(spine, p);
  if (!v) return {};
  return element.fade.IsNone() ? Unfaded(element, *v) : Faded(element, AlongSpine(spine, p), *v);
}

Magnitude OfFill(const Fill& fill, const Profile& profile, glm::dvec2 p) {
  if (!IsInside(fill.outline, p)) return {};
  double inside = std::numeric_limits<double>::infinity();
  glm::dvec2 from_edge(0.0, 0.0);
  for (const Piece& piece : fill.outline) {
    const glm::dvec2 v = p - NearestOn(piece, p);
    if (glm::length(v) < inside) {
      inside = glm::length(v);
      from_edge = v;
    }
  }
  return ToMagnitude(EvaluateFill(profile, inside), from_edge, inside);
}

/// The box of an arc's ends, grown by the circle's four extreme points, as far as they lie on the
/// arc.
void IncludeExtremes(Box& box, const Arc& arc) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const glm::dvec2 way = Direction(quarter * kTurn / 4);
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

glm::dvec2 StartOf(const Piece& piece) {
  return std::visit(
      Overload{
          [](const Line& line) { return line.from; },
          [](const Arc& arc) { return arc.center + arc.radius * Direction(arc.start); },
      },
      piece);
}

glm::dvec2 EndOf(const Piece& piece) {
  return std::visit(Overload{
                        [](const Line& line) { return line.to; },
                        [](const Arc& arc) {
                          return arc.center + arc.radius * Direction(arc.start + SweepOf(arc));
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

glm::dvec2 PointAt(const Piece& piece, double s) {
  const double length = Length(piece);
  const double share = length > 0 ? std::clamp(s / length, 0.0, 1.0) : 0;
  return std::visit(
      Overload{
          [share](const Line& line) { return line.from + share * (line.to - line.from); },
          [share](const Arc& arc) {
            return arc.center + arc.radius * Direction(arc.start + share * SweepOf(arc));
          },
      },
      piece);
}

glm::dvec2 TangentAt(const Piece& piece, double s) {
  const double length = Length(piece);
  const auto of_line = [length](const Line& line) {
    return length > 0 ? (line.to - line.from) / length : glm::dvec2(1.0, 0.0);
  };
  const auto of_arc = [length, s](const Arc& arc) {
    const double share = length > 0 ? std::clamp(s / length, 0.0, 1.0) : 0;
    const glm::dvec2 outward = Direction(arc.start + share * SweepOf(arc));
    return arc.sweep < 0 ? glm::dvec2(outward.y, -outward.x) : glm::dvec2(-outward.y, outward.x);
  };
  return std::visit(Overload{of_line, of_arc}, piece);
}

double DistanceTo(const Piece& piece, glm::dvec2 p) { return glm::length(p - NearestOn(piece, p)); }

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

Box BoundsOf(const Element& element) {
  const double half = 0.5 * element.profile.width;
  const auto of_fill = [](const Fill& fill) {
    Box box;
    for (const Piece& piece : fill.outline) Include(box, BoundsOf(piece));
    return box;
  };
  return std::visit(Overload{
                        [half](const Line& line) { return Grown(BoundsOf(Piece(line)), half); },
                        [half](const Arc& arc) { return Grown(BoundsOf(Piece(arc)), half); },
                        [half](const Dot& dot) {
                          return Grown({dot.center, dot.center}, half);
                        },
                        of_fill,
                    },
                    element.shape);
}

Magnitude Evaluate(const Element& element, glm::dvec2 p) {
  return std::visit(
      Overload{
          [&element, p](const Line& line) { return OfGroove(element, line, p); },
          [&element, p](const Arc& arc) { return OfGroove(element, arc, p); },
          [&element, p](const Dot& dot) { return Unfaded(element, p - dot.center); },
          [&element, p](const Fill& fill) { return OfFill(fill, element.profile, p); },
      },
      element.shape);
}

}  // namespace moontrace
