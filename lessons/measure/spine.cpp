#include "lessons/measure/spine.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

namespace moontrace {
namespace {

constexpr double kTurn = 6.283185307179586476925;

}  // namespace

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
    Part part;
    part.offset = length_;
    part.length = Length(piece);
    part.from = StartOf(piece);
    part.to = EndOf(piece);
    if (const Arc* arc = std::get_if<Arc>(&piece)) {
      part.is_arc = true;
      part.anchor = arc->center;
      part.radius = arc->radius;
      part.start = arc->start;
      part.sweep = std::min(std::abs(arc->sweep), kTurn);
      part.clockwise = arc->sweep < 0;
    } else {
      part.anchor = part.from;
      part.direction = TangentAt(piece, 0);
    }
    length_ += part.length;
    parts_.push_back(part);
  }
  if (!parts_.empty()) start_ = parts_.front().from;
}

Spine::Foot Spine::FootOf(glm::dvec2 p) const noexcept {
  Foot foot;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Part& part : parts_) {
    glm::dvec2 tangent{1, 0};
    const glm::dvec2 off = p - NearestOn(part, p, tangent);
    const double square = glm::dot(off, off);
    if (square >= nearest) continue;
    nearest = square;
    foot.tangent = tangent;
    foot.aside = tangent.x * off.y - tangent.y * off.x;
  }
  return foot;
}

glm::dvec2 Spine::NearestOn(const Part& part, glm::dvec2 p, glm::dvec2& tangent) noexcept {
  const glm::dvec2 v = p - part.anchor;
  if (!part.is_arc) {
    tangent = part.direction;
    return part.anchor + std::clamp(glm::dot(v, tangent), 0.0, part.length) * tangent;
  }
  const double sense = part.clockwise ? -1 : 1;
  const double turned = (std::atan2(v.y, v.x) - part.start) * sense;
  double along = turned - kTurn * std::floor(turned / kTurn);
  if (along > part.sweep) {
    const glm::dvec2 to_start = p - part.from, to_end = p - part.to;
    along = glm::dot(to_start, to_start) < glm::dot(to_end, to_end) ? 0 : part.sweep;
  }
  const double angle = part.start + sense * along;
  const glm::dvec2 out(std::cos(angle), std::sin(angle));
  tangent = sense * glm::dvec2(-out.y, out.x);
  return part.anchor + part.radius * out;
}

double Spine::Cover(glm::dvec2 p, double radius, CoveredLength& covered) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Part& part : parts_) {
    const double distance = part.is_arc ? CoverArc(part, p, radius, nearest, covered)
                                        : CoverLine(part, p, radius, covered);
    nearest = std::min(nearest, distance);
  }
  return nearest;
}

double Spine::CoverLine(const Part& part, glm::dvec2 p, double radius, CoveredLength& covered) {
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
  const glm::dvec2 v = p - part.anchor;
  const double reach = glm::length(v);
  const double aside = std::abs(reach - part.radius);
  if (aside >= radius && aside >= nearest) return aside;
  // Angle from the arc's start in its own sense, in [0, 2 pi).
  const double turned = (std::atan2(v.y, v.x) - part.start) * (part.clockwise ? -1 : 1);
  const double along = turned - kTurn * std::floor(turned / kTurn);
  if (aside < radius) {
    // |p - q|^2 = reach^2 + R^2 - 2 reach R cos(angle between) <= radius^2.
    const double product = 2 * reach * part.radius;
    const double cosine =
        (reach * reach + part.radius * part.radius - radius * radius) / std::max(product, 1e-300);
    const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
    for (const double shift : {-kTurn, 0.0, kTurn}) {
      const double begin = std::max(along + shift - half, 0.0);
      const double end = std::min(along + shift + half, part.sweep);
      if (end > begin) {
        covered.Add(part.offset + part.radius * begin, part.offset + part.radius * end);
      }
    }
  }
  if (along <= part.sweep) return aside;
  return std::sqrt(
      std::min(glm::dot(p - part.from, p - part.from), glm::dot(p - part.to, p - part.to)));
}

}  // namespace moontrace
