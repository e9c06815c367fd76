#include "textures/field/element.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>

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

std::optional<glm::dvec2> FromSpine(const Dot& dot, glm::dvec2 p) { return p - dot.center; }

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

glm::dvec2 NearestOn(const Piece& piece, glm::dvec2 p) {
  if (const Line* line = std::get_if<Line>(&piece)) {
    const glm::dvec2 along = line->to - line->from;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? glm::dot(p - line->from, along) / length2 : 0;
    return line->from + std::clamp(t, 0.0, 1.0) * along;
  }
  const Arc& arc = std::get<Arc>(piece);
  const glm::dvec2 v = p - arc.center;
  if (IsWhole(arc) || AngleAlong(arc, v) <= std::abs(arc.sweep)) {
    const double distance = glm::length(v);
    return distance > 0 ? arc.center + v * (arc.radius / distance)
                        : arc.center + arc.radius * Direction(arc.start);
  }
  const glm::dvec2 start = StartOf(piece), end = EndOf(piece);
  return glm::dot(p - start, p - start) <= glm::dot(p - end, p - end) ? start : end;
}

Magnitude ToMagnitude(const ProfileSample& sample, glm::dvec2 from_spine, double distance) {
  if (sample.height == 0) return {};
  return {sample.height,
          distance > 0 ? sample.slope / distance * from_spine : glm::dvec2(0.0, 0.0)};
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
  if (const Line* line = std::get_if<Line>(&piece)) return line->from;
  const Arc& arc = std::get<Arc>(piece);
  return arc.center + arc.radius * Direction(arc.start);
}

glm::dvec2 EndOf(const Piece& piece) {
  if (const Line* line = std::get_if<Line>(&piece)) return line->to;
  const Arc& arc = std::get<Arc>(piece);
  return arc.center + arc.radius * Direction(arc.start + SweepOf(arc));
}

double Length(const Piece& piece) {
  if (const Line* line = std::get_if<Line>(&piece)) return glm::length(line->to - line->from);
  const Arc& arc = std::get<Arc>(piece);
  return arc.radius * std::abs(SweepOf(arc));
}

glm::dvec2 PointAt(const Piece& piece, double s) {
  const double length = Length(piece);
  const double share = length > 0 ? std::clamp(s / length, 0.0, 1.0) : 0;
  if (const Line* line = std::get_if<Line>(&piece)) {
    return line->from + share * (line->to - line->from);
  }
  const Arc& arc = std::get<Arc>(piece);
  return arc.center + arc.radius * Direction(arc.start + share * SweepOf(arc));
}

glm::dvec2 TangentAt(const Piece& piece, double s) {
  const double length = Length(piece);
  if (const Line* line = std::get_if<Line>(&piece)) {
    return length > 0 ? (line->to - line->from) / length : glm::dvec2(1.0, 0.0);
  }
  const Arc& arc = std::get<Arc>(piece);
  const double share = length > 0 ? std::clamp(s / length, 0.0, 1.0) : 0;
  const glm::dvec2 outward = Direction(arc.start + share * SweepOf(arc));
  return arc.sweep < 0 ? glm::dvec2(outward.y, -outward.x) : glm::dvec2(-outward.y, outward.x);
}

double DistanceTo(const Piece& piece, glm::dvec2 p) { return glm::length(p - NearestOn(piece, p)); }

Piece Placed(const Piece& piece, double scale, glm::dvec2 origin) {
  if (const Line* line = std::get_if<Line>(&piece)) {
    return Line{scale * line->from + origin, scale * line->to + origin};
  }
  Arc arc = std::get<Arc>(piece);
  arc.center = scale * arc.center + origin;
  arc.radius *= scale;
  return arc;
}

Box BoundsOf(const Piece& piece) {
  Box box;
  Include(box, StartOf(piece));
  Include(box, EndOf(piece));
  if (const Arc* arc = std::get_if<Arc>(&piece)) {
    // the circle's four extreme points, as far as they lie on the arc
    for (int quarter = 0; quarter < 4; ++quarter) {
      const glm::dvec2 way = Direction(quarter * kTurn / 4);
      if (IsWhole(*arc) || AngleAlong(*arc, way) <= std::abs(arc->sweep)) {
        Include(box, arc->center + arc->radius * way);
      }
    }
  }
  return box;
}

Box BoundsOf(const Element& element) {
  Box box;
  if (const Fill* fill = std::get_if<Fill>(&element.shape)) {
    for (const Piece& piece : fill->outline) Include(box, BoundsOf(piece));
    return box;
  }
  if (const Dot* dot = std::get_if<Dot>(&element.shape)) Include(box, dot->center);
  if (const Line* line = std::get_if<Line>(&element.shape)) Include(box, BoundsOf(Piece(*line)));
  if (const Arc* arc = std::get_if<Arc>(&element.shape)) Include(box, BoundsOf(Piece(*arc)));
  return Grown(box, 0.5 * element.profile.width);
}

Magnitude Evaluate(const Element& element, glm::dvec2 p) {
  if (const Fill* fill = std::get_if<Fill>(&element.shape)) {
    if (!IsInside(fill->outline, p)) return {};
    double inside = std::numeric_limits<double>::infinity();
    glm::dvec2 from_edge(0.0, 0.0);
    for (const Piece& piece : fill->outline) {
      const glm::dvec2 v = p - NearestOn(piece, p);
      if (glm::length(v) < inside) {
        inside = glm::length(v);
        from_edge = v;
      }
    }
    return ToMagnitude(EvaluateFill(element.profile, inside), from_edge, inside);
  }
  std::optional<glm::dvec2> v;
  if (const Line* line = std::get_if<Line>(&element.shape)) v = FromSpine(*line, p);
  if (const Arc* arc = std::get_if<Arc>(&element.shape)) v = FromSpine(*arc, p);
  if (const Dot* dot = std::get_if<Dot>(&element.shape)) v = FromSpine(*dot, p);
  if (!v) return {};
  if (!element.fade.IsNone()) {
    if (const Line* line = std::get_if<Line>(&element.shape)) {
      return Faded(element, AlongSpine(*line, p), *v);
    }
    if (const Arc* arc = std::get_if<Arc>(&element.shape)) {
      return Faded(element, AlongSpine(*arc, p), *v);
    }
  }
  const double distance = glm::length(*v);
  return ToMagnitude(Evaluate(element.profile, distance), *v, distance);
}

}  // namespace moontrace
