#include "textures/objects/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moontrace {
namespace {

constexpr std::array<std::string_view, 7> kNames = {"top",  "bottom", "front", "back",
                                                    "left", "right",  "round"};

/// How far beyond its two faces a point is along one axis [m], and on which side.
struct Beyond {
  double by = 0;
  double side = 1;
};

Beyond BeyondOf(double p, double half, double remembered) noexcept {
  const double side = remembered != 0 ? remembered : (p < 0 ? -1.0 : 1.0);
  return {side * p - half, side};
}

Face FaceAlong(int axis, double side) noexcept {
  constexpr Face kFaces[3][2] = {
      {Face::kLeft, Face::kRight}, {Face::kFront, Face::kBack}, {Face::kBottom, Face::kTop}};
  return kFaces[axis][side > 0 ? 1 : 0];
}

Nearest NearestOfBox(const glm::dvec3& half, const glm::dvec3& p, const Sides& sides) noexcept {
  // z first, as Face has it
  constexpr int kOrder[3] = {2, 1, 0};
  glm::dvec3 out(0), side(1);
  int nearest = 2;
  double best = -std::numeric_limits<double>::infinity();
  for (const int axis : kOrder) {
    const Beyond beyond = BeyondOf(p[axis], half[axis], sides.of[axis]);
    side[axis] = beyond.side;
    out[axis] = std::max(0.0, beyond.by);
    if (beyond.by <= best) continue;
    best = beyond.by;
    nearest = axis;
  }
  Nearest result{FaceAlong(nearest, side[nearest]), best, glm::dvec3(0)};
  result.normal_O[nearest] = side[nearest];
  if (best > 0 && out[nearest] != out.x + out.y + out.z) {  // beyond an edge
    result.height = glm::length(out);
    result.normal_O = side * out / result.height;
  }
  return result;
}

/// Outwards from the z axis; towards the front on it.
glm::dvec3 Outwards(const glm::dvec3& p, double distance) noexcept {
  if (!(distance > 0)) return {0, -1, 0};
  return {p.x / distance, p.y / distance, 0};
}

Nearest NearestOfCylinder(const glm::dvec3& half, const glm::dvec3& p,
                          const Sides& sides) noexcept {
  const double distance = std::hypot(p.x, p.y);
  const double out = distance - half.x;
  const Beyond along = BeyondOf(p.z, half.y, sides.of.z);
  const glm::dvec3 across = Outwards(p, distance), axis(0, 0, along.side);
  const Face cap = FaceAlong(2, along.side);
  if (out > 0 && along.by > 0) {
    const double height = std::hypot(out, along.by);
    return {along.by >= out ? cap : Face::kRound, height,
            (out * across + along.by * axis) / height};
  }
  if (along.by >= out) return {cap, along.by, axis};
  return {Face::kRound, out, across};
}

Nearest NearestOfBall(double radius, const glm::dvec3& p) noexcept {
  const double distance = glm::length(p);
  const glm::dvec3 normal = distance > 0 ? p / distance : glm::dvec3(0, -1, 0);
  return {Face::kRound, distance - radius, normal};
}

Nearest NearestOfEllipsoid(const glm::dvec3& a, const glm::dvec3& p) noexcept {
  if (p == glm::dvec3(0)) {
    const int least = a.x <= a.y && a.x <= a.z ? 0 : (a.y <= a.z ? 1 : 2);
    glm::dvec3 normal(0);
    normal[least] = 1;
    return {Face::kRound, -a[least], normal};
  }
  const double t = EllipsoidParameter(a, p);
  const glm::dvec3 gradient = p / (a * a + t);  // of the ellipsoid's equation at the nearest point
  const double steep = glm::length(gradient);
  // p - x = t * gradient
  return {Face::kRound, t * steep, gradient / steep};
}

double LeastRadius(const Solid& solid) noexcept {
  switch (solid.kind) {
    case SolidKind::kPlane:
    case SolidKind::kBox:
      break;
    case SolidKind::kCylinder:
    case SolidKind::kSphere:
    case SolidKind::kCapsule:
      return solid.half.x;
    case SolidKind::kEllipsoid: {
      const double least = std::min({solid.half.x, solid.half.y, solid.half.z});
      return least * least / std::max({solid.half.x, solid.half.y, solid.half.z});
    }
  }
  return std::numeric_limits<double>::infinity();
}

/// Whether a point is beside neither the other faces of a box nor the round one of a cylinder.
bool IsWithin(const Solid& solid, int axis, const glm::dvec3& p) noexcept {
  if (solid.kind == SolidKind::kCylinder) return std::hypot(p.x, p.y) <= solid.half.x;
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  return std::abs(p[a]) <= solid.half[a] && std::abs(p[b]) <= solid.half[b];
}

}  // namespace

std::string_view NameOf(Face face) noexcept { return kNames[static_cast<std::size_t>(face)]; }

std::optional<Face> FaceOf(std::string_view name) noexcept {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Face>(found - kNames.begin());
}

bool HasFace(const Solid& solid, Face face) noexcept {
  switch (solid.kind) {
    case SolidKind::kPlane:
      return face == Face::kTop;
    case SolidKind::kBox:
      return face != Face::kRound;
    case SolidKind::kCylinder:
      return face == Face::kTop || face == Face::kBottom || face == Face::kRound;
    case SolidKind::kSphere:
    case SolidKind::kCapsule:
    case SolidKind::kEllipsoid:
      break;
  }
  return face == Face::kRound;
}

Face UsualFace(const Solid& solid) noexcept {
  const bool flat = solid.kind == SolidKind::kPlane || solid.kind == SolidKind::kBox;
  return flat ? Face::kTop : Face::kRound;
}

void Remember(const Solid& solid, double thin, glm::dvec3 p_O, Sides& sides) noexcept {
  const bool box = solid.kind == SolidKind::kBox;
  if (!box && solid.kind != SolidKind::kCylinder) return;
  for (int axis = box ? 0 : 2; axis < 3; ++axis) {
    const double half = box ? solid.half[axis] : solid.half.y;
    if (!(half < thin) || !(std::abs(p_O[axis]) > half)) continue;
    const double side = p_O[axis] < 0 ? -1 : 1;
    // right behind it: pressed through, not gone round
    const bool pressed = sides.of[axis] == -side && IsWithin(solid, axis, p_O);
    if (!pressed) sides.of[axis] = side;
  }
}

Nearest NearestOf(const Solid& solid, glm::dvec3 p_O, const Sides& sides) noexcept {
  switch (solid.kind) {
    case SolidKind::kPlane:
      break;
    case SolidKind::kBox:
      return NearestOfBox(solid.half, p_O, sides);
    case SolidKind::kCylinder:
      return NearestOfCylinder(solid.half, p_O, sides);
    case SolidKind::kSphere:
      return NearestOfBall(solid.half.x, p_O);
    case SolidKind::kCapsule: {
      const double on_axis = std::clamp(p_O.z, -solid.half.y, solid.half.y);
      return NearestOfBall(solid.half.x, p_O - glm::dvec3(0, 0, on_axis));
    }
    case SolidKind::kEllipsoid:
      return NearestOfEllipsoid(solid.half, p_O);
  }
  return {Face::kTop, p_O.z, {0, 0, 1}};
}

double GreatestDepth(const Solid& solid) noexcept { return 0.5 * LeastRadius(solid); }

double ShrinkAt(const Solid& solid, double depth) noexcept {
  return 1 / (1 - depth / LeastRadius(solid));
}

double Radius(const Solid& solid) noexcept {
  switch (solid.kind) {
    case SolidKind::kPlane:
      break;
    case SolidKind::kBox:
      return glm::length(solid.half);
    case SolidKind::kCylinder:
      return std::hypot(solid.half.x, solid.half.y);
    case SolidKind::kSphere:
      return solid.half.x;
    case SolidKind::kCapsule:
      return solid.half.x + solid.half.y;
    case SolidKind::kEllipsoid:
      return std::max({solid.half.x, solid.half.y, solid.half.z});
  }
  return std::numeric_limits<double>::infinity();
}

double EllipsoidParameter(glm::dvec3 a, glm::dvec3 p) noexcept {
  // sum (a_i p_i / (a_i^2 + t))^2 - 1 falls and is convex for t above -min a_i^2: Newton's steps
  // from the left of the root never pass it.
  const glm::dvec3 a2 = a * a, ap = glm::abs(a * p);
  double t = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (ap[i] > 0) t = std::max(t, ap[i] - a2[i]);  // one term alone is one there: left of the root
  }
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 below = a2 + t;
    double sum = -1, fall = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (ap[axis] == 0) continue;
      const double share = ap[axis] / below[axis];
      sum += share * share;
      fall += share * share / below[axis];
    }
    const double step = 0.5 * sum / fall;
    if (!(step > 1e-16 * std::abs(t) + 1e-18 * a2.x)) break;
    t += step;
  }
  return t;
}

}  // namespace moontrace
