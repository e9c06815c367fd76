#include "textures/field/element.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <optional>

#include "textures/base/overload.h"
#include "textures/field/fill.h"

namespace moontrace {

namespace {

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

}  // namespace

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
