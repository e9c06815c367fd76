#include "textures/relief/clearance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "textures/base/units.h"

namespace moontrace {
namespace {

double Cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Whether the arc has a point in the direction `v` from its centre.
bool Covers(const Curve& arc, glm::dvec2 v) {
  if (arc.is_whole) return true;
  if (arc.is_long) return !(Cross(arc.last, v) > 0 && Cross(v, arc.first) > 0);
  return Cross(arc.first, v) >= 0 && Cross(v, arc.last) >= 0;
}

double ToLine(const Curve& line, glm::dvec2 p) {
  const glm::dvec2 along = line.to - line.from;
  const double square = glm::dot(along, along);
  const double t = square > 0 ? glm::dot(p - line.from, along) / square : 0;
  return glm::distance(p, line.from + std::clamp(t, 0.0, 1.0) * along);
}

double ToArc(const Curve& arc, glm::dvec2 p) {
  const glm::dvec2 v = p - arc.center;
  if (Covers(arc, v)) return std::abs(glm::length(v) - arc.radius);
  return std::min(glm::distance(p, arc.from), glm::distance(p, arc.to));
}

bool LinesCross(const Curve& a, const Curve& b) {
  const glm::dvec2 u = a.to - a.from, v = b.to - b.from, w = b.from - a.from;
  const double by = Cross(u, v);
  if (by == 0) return false;  // where they lie on one line their ends tell
  const double s = Cross(w, v) / by, t = Cross(w, u) / by;
  return s >= 0 && s <= 1 && t >= 0 && t <= 1;
}

bool LineCrossesArc(const Curve& line, const Curve& arc) {
  const glm::dvec2 u = line.to - line.from, w = line.from - arc.center;
  const double a = glm::dot(u, u), b = glm::dot(u, w);
  const double root = b * b - a * (glm::dot(w, w) - arc.radius * arc.radius);
  if (a <= 0 || root < 0) return false;
  for (const double sign : {-1.0, 1.0}) {
    const double t = (-b + sign * std::sqrt(root)) / a;
    if (t >= 0 && t <= 1 && Covers(arc, w + t * u)) return true;
  }
  return false;
}

bool ArcsCross(const Curve& a, const Curve& b) {
  const glm::dvec2 v = b.center - a.center;
  const double square = glm::dot(v, v);
  if (square <= 0) return false;
  // a crossing from the first centre: along the line of centres, and aside of it
  const double x = 0.5 * (1 + (a.radius * a.radius - b.radius * b.radius) / square);
  const double y2 = a.radius * a.radius / square - x * x;
  if (y2 < 0) return false;
  for (const double y : {std::sqrt(y2), -std::sqrt(y2)}) {
    const glm::dvec2 p = x * v + y * glm::dvec2(-v.y, v.x);
    if (Covers(a, p) && Covers(b, p - v)) return true;
  }
  return false;
}

bool Cross(const Curve& a, const Curve& b) {
  if (!Overlap(a.box, b.box)) return false;
  if (a.radius > 0) return b.radius > 0 ? ArcsCross(a, b) : LineCrossesArc(b, a);
  return b.radius > 0 ? LineCrossesArc(a, b) : LinesCross(a, b);
}

double LineBesideArc(const Curve& line, const Curve& arc) {
  const glm::dvec2 u = line.to - line.from;
  const double square = glm::dot(u, u);
  const double t = square > 0 ? glm::dot(arc.center - line.from, u) / square : -1;
  const glm::dvec2 v = line.from + t * u - arc.center;
  const double beyond = glm::length(v) - arc.radius;
  return t > 0 && t < 1 && beyond > 0 && Covers(arc, v) ? beyond
                                                        : std::numeric_limits<double>::infinity();
}

double ArcBesideArc(const Curve& a, const Curve& b) {
  const glm::dvec2 v = b.center - a.center;
  const double between = glm::length(v);
  const double apart = between - a.radius - b.radius;
  if (apart > 0 && Covers(a, v) && Covers(b, -v)) return apart;
  const double within = std::abs(a.radius - b.radius) - between;
  const glm::dvec2 way = a.radius > b.radius ? v : -v;
  if (within > 0 && between > 0 && Covers(a, way) && Covers(b, way)) return within;
  return std::numeric_limits<double>::infinity();
}

/// Where neither curve's end is nearest.
double Beside(const Curve& a, const Curve& b) {
  if (a.radius > 0) return b.radius > 0 ? ArcBesideArc(a, b) : LineBesideArc(b, a);
  return b.radius > 0 ? LineBesideArc(a, b) : std::numeric_limits<double>::infinity();
}

glm::dvec2 WayAt(const Curve& curve, glm::dvec2 p) {
  if (curve.radius <= 0) return glm::normalize(curve.to - curve.from);
  const glm::dvec2 out = (p - curve.center) / curve.radius;
  return curve.turns_left ? glm::dvec2(-out.y, out.x) : glm::dvec2(out.y, -out.x);
}

}  // namespace

glm::dvec2 WayAtStart(const Curve& curve) { return WayAt(curve, curve.from); }
glm::dvec2 WayAtEnd(const Curve& curve) { return WayAt(curve, curve.to); }

Curve ArcCurve(glm::dvec2 center, double radius, glm::dvec2 from, glm::dvec2 to, double sweep) {
  Curve arc;
  arc.from = from;
  arc.to = to;
  arc.center = center;
  arc.radius = radius;
  arc.first = ((sweep > 0 ? from : to) - center) / radius;
  arc.last = ((sweep > 0 ? to : from) - center) / radius;
  arc.turns_left = sweep > 0;
  arc.is_long = std::abs(sweep) > kTurn / 2;
  arc.is_whole = std::abs(sweep) >= kTurn;
  Include(arc.box, from);
  Include(arc.box, to);
  for (const glm::dvec2 way :
       {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(-1, 0), glm::dvec2(0, -1)}) {
    if (Covers(arc, way)) Include(arc.box, center + radius * way);
  }
  return arc;
}

Curve LineCurve(glm::dvec2 from, glm::dvec2 to) {
  Curve line;
  line.from = from;
  line.to = to;
  Include(line.box, from);
  Include(line.box, to);
  return line;
}

Curve CurveOf(const Piece& piece) {
  const glm::dvec2 from = StartOf(piece), to = EndOf(piece);
  const std::optional<Arc> arc = ArcOf(piece);
  return arc ? ArcCurve(arc->center, arc->radius, from, to, arc->sweep) : LineCurve(from, to);
}

std::vector<Curve> CurvesOf(const std::vector<Piece>& pieces) {
  std::vector<Curve> curves;
  curves.reserve(pieces.size());
  for (const Piece& piece : pieces) curves.push_back(CurveOf(piece));
  return curves;
}

Curve Moved(const Curve& curve, glm::dvec2 by) {
  Curve moved = curve;
  moved.from += by;
  moved.to += by;
  moved.center += by;
  moved.box = Moved(curve.box, by);
  return moved;
}

double DistanceTo(const Curve& curve, glm::dvec2 p) {
  return curve.radius > 0 ? ToArc(curve, p) : ToLine(curve, p);
}

double DistanceBetween(const Curve& a, const Curve& b) {
  if (Cross(a, b)) return 0;
  return std::min({DistanceTo(a, b.from), DistanceTo(a, b.to), DistanceTo(b, a.from),
                   DistanceTo(b, a.to), Beside(a, b)});
}

}  // namespace moontrace
