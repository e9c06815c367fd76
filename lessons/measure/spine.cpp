#include "lessons/measure/spine.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

#include "textures/base/units.h"

namespace moontrace {

void CoveredLength::Add(double begin, double end) {
  if (!(end >= begin)) return;
  // The first that reaches up to `begin`; it and those after it may meet the new one.
  const auto first =
      std::lower_bound(intervals_.begin(), intervals_.end(), begin,
                       [](const Interval& interval, double at) { return interval.end < at; });
  if (first == intervals_.end() || first->begin > end) {
    intervals_.insert(first, {begin, end});
    return;
  }
  first->begin = std::min(first->begin, begin);
  if (end <= first->end) return;
  first->end = end;
  auto next = std::next(first);
  for (; next != intervals_.end() && next->begin <= end; ++next) {
    first->end = std::max(end, next->end);
  }
  intervals_.erase(std::next(first), next);
}

double CoveredLength::Total() const noexcept {
  double total = 0;
  for (const Interval& interval : intervals_) total += interval.end - interval.begin;
  return total;
}

Spine::Spine(const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces) {
    parts_.push_back({PartOf(piece, length_), StartOf(piece), EndOf(piece)});
    length_ += parts_.back().path.length;
  }
  if (!parts_.empty()) start_ = parts_.front().from;
}

Spine::Foot Spine::FootOf(glm::dvec2 p) const noexcept {
  Foot foot;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Part& part : parts_) {
    glm::dvec2 tangent{1, 0};
    const glm::dvec2 point = NearestOn(part, p, tangent), off = p - point;
    const double square = glm::dot(off, off);
    if (square >= nearest) continue;
    nearest = square;
    foot.point = point;
    foot.tangent = tangent;
    foot.aside = tangent.x * off.y - tangent.y * off.x;
  }
  return foot;
}

glm::dvec2 Spine::NearestOn(const Part& part, glm::dvec2 p, glm::dvec2& tangent) noexcept {
  const PathPart& path = part.path;
  if (!path.is_arc) {
    tangent = path.direction;
    const double along = glm::dot(p - path.anchor, tangent);
    return PointAt(path, std::clamp(along, 0.0, path.length));
  }
  double angle = AngleTo(path, p);
  if (angle > path.sweep) {
    const glm::dvec2 to_start = p - part.from, to_end = p - part.to;
    angle = glm::dot(to_start, to_start) < glm::dot(to_end, to_end) ? 0 : path.sweep;
  }
  tangent = TangentAtAngle(path, angle);
  return PointAtAngle(path, angle);
}

double Spine::Cover(glm::dvec2 p, double radius, CoveredLength& covered) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Part& part : parts_) {
    const double distance = part.path.is_arc ? CoverArc(part, p, radius, nearest, covered)
                                             : CoverLine(part.path, p, radius, covered);
    nearest = std::min(nearest, distance);
  }
  return nearest;
}

double Spine::CoverLine(const PathPart& part, glm::dvec2 p, double radius, CoveredLength& covered) {
  const glm::dvec2 v = p - part.anchor;
  const double along = glm::dot(v, part.direction);
  const double aside = part.direction.x * v.y - part.direction.y * v.x;
  if (std::abs(aside) < radius) {
    const double half = std::sqrt(radius * radius - aside * aside);
    const double begin = std::max(along - half, 0.0);
    const double end = std::min(along + half, part.length);
    if (end > begin) covered.Add(part.offset + begin, part.offset + end);
  }
  const double beyond = along - std::clamp(along, 0.0, part.length);
  return std::sqrt(aside * aside + beyond * beyond);
}

double Spine::CoverArc(const Part& part, glm::dvec2 p, double radius, double nearest,
                       CoveredLength& covered) {
  const PathPart& arc = part.path;
  const double reach = glm::length(p - arc.anchor);
  const double aside = std::abs(reach - arc.radius);
  if (aside >= radius && aside >= nearest) return aside;
  const double along = AngleTo(arc, p);
  if (aside < radius) {
    // |p - q|^2 = reach^2 + R^2 - 2 reach R cos(angle between) <= radius^2.
    const double product = 2 * reach * arc.radius;
    const double cosine =
        (reach * reach + arc.radius * arc.radius - radius * radius) / std::max(product, 1e-300);
    const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
    for (const double shift : {-kTurn, 0.0, kTurn}) {
      const double begin = std::max(along + shift - half, 0.0);
      const double end = std::min(along + shift + half, arc.sweep);
      if (end > begin) {
        covered.Add(arc.offset + arc.radius * begin, arc.offset + arc.radius * end);
      }
    }
  }
  if (along <= arc.sweep) return aside;
  return std::sqrt(
      std::min(glm::dot(p - part.from, p - part.from), glm::dot(p - part.to, p - part.to)));
}

}  // namespace moontrace
