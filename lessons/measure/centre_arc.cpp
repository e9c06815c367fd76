#include "lessons/measure/centre_arc.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr double kSame = 1e-6;  ///< lengths that differ by this share are the same

double Cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

bool IsSameCircle(const Arc& first, const Arc& arc) {
  return std::abs(arc.radius - first.radius) <= kSame * first.radius &&
         glm::length(arc.center - first.center) <= kSame * first.radius;
}

/// The first piece's centre, if that is an arc and all pieces lie on its circle.
std::optional<glm::dvec2> CircleCentre(const std::vector<Piece>& outline) {
  const std::optional<Arc> first = ArcOf(outline.front());
  if (!first) return std::nullopt;
  const bool circle = std::all_of(outline.begin(), outline.end(), [&first](const Piece& piece) {
    const std::optional<Arc> arc = ArcOf(piece);
    return arc && IsSameCircle(*first, *arc);
  });
  return circle ? std::optional(first->center) : std::nullopt;
}

/// The two corners farthest apart, as numbers of the pieces that begin there.
std::pair<std::size_t, std::size_t> Tips(const std::vector<Piece>& outline) {
  std::pair<std::size_t, std::size_t> tips{0, 0};
  double greatest = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (std::size_t j = i + 1; j < outline.size(); ++j) {
      const double apart = glm::length(StartOf(outline[i]) - StartOf(outline[j]));
      if (apart > greatest) {
        greatest = apart;
        tips = {i, j};
      }
    }
  }
  return tips;
}

/// The point halfway along the outline from the start of piece `begin` to that of piece `end`.
glm::dvec2 MiddleOfSide(const std::vector<Piece>& outline, std::size_t begin, std::size_t end) {
  double length = 0;
  for (std::size_t i = begin; i != end; i = (i + 1) % outline.size()) length += Length(outline[i]);
  double left = length / 2;
  for (std::size_t i = begin; i != end; i = (i + 1) % outline.size()) {
    if (left <= Length(outline[i])) return PointAt(outline[i], left);
    left -= Length(outline[i]);
  }
  return StartOf(outline[end]);
}

Piece ArcThrough(glm::dvec2 from, glm::dvec2 middle, glm::dvec2 to) {
  const glm::dvec2 a = middle - from, b = to - from;
  const double twice_area = Cross(a, b);
  if (std::abs(twice_area) <= kSame * glm::dot(b, b)) return Line{from, to};
  // Circumcentre, from the two equations |c|^2 = |c - a|^2 = |c - b|^2.
  const glm::dvec2 center = glm::dvec2(b.y * glm::dot(a, a) - a.y * glm::dot(b, b),
                                       a.x * glm::dot(b, b) - b.x * glm::dot(a, a)) /
                            (2 * twice_area);
  const double start = std::atan2(-center.y, -center.x);
  const glm::dvec2 end = b - center;
  double sweep = std::atan2(end.y, end.x) - start;
  // A middle to the right of the chord makes travel turn left, counter-clockwise.
  if (twice_area > 0 && sweep < 0) sweep += kTurn;
  if (twice_area < 0 && sweep > 0) sweep -= kTurn;
  return Arc{from + center, glm::length(center), start, sweep};
}

/// Distance of a point within the outline to it.
double Inside(const std::vector<Piece>& outline, glm::dvec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Piece& piece : outline) nearest = std::min(nearest, DistanceTo(piece, p));
  return nearest;
}

/// The part around the middle that lies `rim` inside; each end is found by bisection to 1e-12.
Piece Trimmed(const Piece& piece, const std::vector<Piece>& outline, double rim) {
  const double length = Length(piece), middle = length / 2;
  const double depth = std::min(rim, 0.9 * Inside(outline, PointAt(piece, middle)));
  const auto last_inside = [&](double out) {
    double in = middle;
    for (int i = 0; i < 40; ++i) {
      const double half = (in + out) / 2;
      (Inside(outline, PointAt(piece, half)) >= depth ? in : out) = half;
    }
    return in;
  };
  return PartBetween(piece, last_inside(0), last_inside(length));
}

}  // namespace

std::vector<Piece> CentreArc(const std::vector<Piece>& outline, double rim) {
  if (outline.empty()) return {};
  if (const std::optional<glm::dvec2> centre = CircleCentre(outline)) {
    return {Line{*centre, *centre}};
  }
  const auto [first, second] = Tips(outline);
  if (first == second) return {Line{StartOf(outline.front()), StartOf(outline.front())}};
  glm::dvec2 from = StartOf(outline[first]), to = StartOf(outline[second]);
  const glm::dvec2 middle =
      0.5 * (MiddleOfSide(outline, first, second) + MiddleOfSide(outline, second, first));
  const double level = kSame * glm::length(to - from);
  if (from.y < to.y - level || (from.y <= to.y + level && from.x > to.x)) std::swap(from, to);
  return {Trimmed(ArcThrough(from, middle, to), outline, rim)};
}

}  // namespace moontrace
