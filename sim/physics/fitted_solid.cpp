#include "sim/physics/fitted_solid.h"

#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace moontrace {
namespace {

constexpr double kFlat = 0.1e-3;        // a flat part keeps to its plane so closely [m]
constexpr double kRound = 0.5e-3;       // a round one to its surface [m] ...
constexpr double kRoundShare = 0.03;    // ... and, of its radius
constexpr double kSmooth = 0.9063;      // cosine of 25 degrees: between facets of one round part
constexpr double kClosed = 0.85;        // of a round surface; the rest may be where a handle joins
constexpr double kLeastSide = 5e-3;     // of a part that carries text [m]
constexpr double kGreatestRadius = 10;  // beyond this a part is flat [m]
constexpr std::size_t kEnoughFacets = 24;  // to tell a round surface by

using Face3 = std::array<std::size_t, 3>;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// The same place has several numbers where textures or normals part: it gets one.
TriangleMesh Merged(const TriangleMesh& mesh) {
  std::map<std::array<double, 3>, std::size_t> numbers;
  std::vector<std::size_t> number_of;
  TriangleMesh merged;
  number_of.reserve(mesh.points.size());
  for (const glm::dvec3& p : mesh.points) {
    const auto [at, is_new] = numbers.try_emplace({p.x, p.y, p.z}, merged.points.size());
    if (is_new) merged.points.push_back(p);
    number_of.push_back(at->second);
  }
  merged.faces.reserve(mesh.faces.size());
  for (const Face3& face : mesh.faces) {
    const Face3 joined{number_of[face[0]], number_of[face[1]], number_of[face[2]]};
    if (joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0]) continue;
    merged.faces.push_back(joined);
  }
  return merged;
}

/// A mesh with what is asked of its triangles again and again.
class Facets {
 public:
  explicit Facets(const TriangleMesh& mesh) : mesh_(Merged(mesh)) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> by_edge;
    neighbours_.resize(mesh_.faces.size(), {kNone, kNone, kNone});
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const glm::dvec3 cross = glm::cross(Corner(f, 1) - Corner(f, 0), Corner(f, 2) - Corner(f, 0));
      const double twice = glm::length(cross);
      areas_.push_back(0.5 * twice);
      normals_.push_back(twice > 0 ? cross / twice : glm::dvec3(0, 0, 0));
      for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = std::minmax(mesh_.faces[f][k], mesh_.faces[f][(k + 1) % 3]);
        const auto [at, is_new] = by_edge.try_emplace(edge, 3 * f + k);
        if (is_new) continue;
        neighbours_[f][k] = at->second / 3;
        neighbours_[at->second / 3][at->second % 3] = f;
      }
    }
  }

  std::size_t count() const { return mesh_.faces.size(); }
  const glm::dvec3& Corner(std::size_t f, std::size_t k) const {
    return mesh_.points[mesh_.faces[f][k]];
  }
  const glm::dvec3& Normal(std::size_t f) const { return normals_[f]; }
  double Area(std::size_t f) const { return areas_[f]; }

  /// How far along a ray the triangle lies [m]; infinite: it is not met. With `along` unit.
  double Met(std::size_t f, glm::dvec3 from, glm::dvec3 along) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const glm::dvec3 a = Corner(f, 1) - Corner(f, 0), b = Corner(f, 2) - Corner(f, 0);
    const glm::dvec3 h = glm::cross(along, b);
    const double determinant = glm::dot(a, h);
    if (std::abs(determinant) < 1e-300) return kFar;
    const glm::dvec3 s = from - Corner(f, 0);
    const double u = glm::dot(s, h) / determinant;
    const glm::dvec3 q = glm::cross(s, a);
    const double v = glm::dot(along, q) / determinant;
    constexpr double kHair = 1e-9;  // a ray along an edge meets one of its triangles
    if (u < -kHair || v < -kHair || u + v > 1 + kHair) return kFar;
    const double t = glm::dot(b, q) / determinant;
    return t > 0 ? t : kFar;
  }

  /// Triangles that hang together with `seed`, each taken if `takes(triangle, before)`.
  template <class Takes>
  std::vector<std::size_t> Grow(std::size_t seed, std::size_t most, const Takes& takes) const {
    std::vector<std::uint8_t> seen(count(), 0);
    std::vector<std::size_t> part{seed};
    seen[seed] = 1;
    for (std::size_t i = 0; i < part.size() && part.size() < most; ++i) {
      const std::size_t before = part[i];
      for (const std::size_t f : neighbours_[before]) {
        if (f == kNone || seen[f] != 0 || !takes(f, before)) continue;
        seen[f] = 1;
        part.push_back(f);
      }
    }
    return part;
  }

  double AreaOf(const std::vector<std::size_t>& part) const {
    double area = 0;
    for (const std::size_t f : part) area += areas_[f];
    return area;
  }

 private:
  TriangleMesh mesh_;
  std::vector<glm::dvec3> normals_;
  std::vector<double> areas_;  ///< [m2]
  std::vector<std::array<std::size_t, 3>> neighbours_;
};

struct Hit {
  std::size_t face = kNone;
  double distance = std::numeric_limits<double>::infinity();  ///< [m]
};
Hit FirstMet(const Facets& facets, glm::dvec3 from, glm::dvec3 along) {
  Hit hit;
  for (std::size_t f = 0; f < facets.count(); ++f) {
    const double distance = facets.Met(f, from, along);
    if (distance < hit.distance) hit = {f, distance};
  }
  return hit;
}

/// A smooth surface: its distance from a point, signed, and its normal there.
struct Plane {
  glm::dvec3 p{0, 0, 0}, n{0, 0, 1};
  double DistanceOf(glm::dvec3 q) const { return glm::dot(q - p, n); }
  glm::dvec3 NormalAt(glm::dvec3) const { return n; }
};
struct Ball {
  glm::dvec3 middle{0, 0, 0};
  double radius = 0;
  double DistanceOf(glm::dvec3 q) const { return glm::length(q - middle) - radius; }
  glm::dvec3 NormalAt(glm::dvec3 q) const { return glm::normalize(q - middle); }
};
struct Tube {
  glm::dvec3 middle{0, 0, 0}, axis{0, 0, 1};
  double radius = 0;
  glm::dvec3 Across(glm::dvec3 q) const {
    const glm::dvec3 v = q - middle;
    return v - glm::dot(v, axis) * axis;
  }
  double DistanceOf(glm::dvec3 q) const { return glm::length(Across(q)) - radius; }
  glm::dvec3 NormalAt(glm::dvec3 q) const { return glm::normalize(Across(q)); }
};

template <class Shape>
bool Keeps(const Facets& facets, std::size_t f, const Shape& shape, double tolerance,
           double least_cosine) {
  glm::dvec3 middle(0);
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(shape.DistanceOf(facets.Corner(f, k))) > tolerance) return false;
    middle += facets.Corner(f, k) / 3.0;
  }
  return glm::dot(shape.NormalAt(middle), facets.Normal(f)) >= least_cosine;
}

/// Greatest distance between facets and surface, at corners, edges and middles [m].
template <class Shape>
double ErrorOf(const Facets& facets, const std::vector<std::size_t>& part, const Shape& shape) {
  double error = 0;
  for (const std::size_t f : part) {
    glm::dvec3 middle(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 a = facets.Corner(f, k), b = facets.Corner(f, (k + 1) % 3);
      error = std::max(
          {error, std::abs(shape.DistanceOf(a)), std::abs(shape.DistanceOf(0.5 * (a + b)))});
      middle += a / 3.0;
    }
    error = std::max(error, std::abs(shape.DistanceOf(middle)));
  }
  return error;
}

Plane PlaneOf(const Facets& facets, const std::vector<std::size_t>& part) {
  Plane plane{{0, 0, 0}, {0, 0, 0}};
  double area = 0;
  for (const std::size_t f : part) {
    const glm::dvec3 sum = facets.Corner(f, 0) + facets.Corner(f, 1) + facets.Corner(f, 2);
    plane.p += facets.Area(f) / 3.0 * sum;
    plane.n += facets.Area(f) * facets.Normal(f);
    area += facets.Area(f);
  }
  plane.p /= area;
  plane.n = glm::normalize(plane.n);
  return plane;
}

/// Least squares of |q|^2 = 2 q.c + k over the corners.
Ball BallOf(const Facets& facets, const std::vector<std::size_t>& part) {
  const glm::dvec3 origin = facets.Corner(part.front(), 0);
  glm::dmat4 A(0.0);
  glm::dvec4 b(0.0);
  for (const std::size_t f : part) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 q = facets.Corner(f, k) - origin;
      const glm::dvec4 row(2.0 * q, 1);
      A += glm::outerProduct(row, row);
      b += glm::dot(q, q) * row;
    }
  }
  if (!(std::abs(glm::determinant(A)) > 0)) return {};
  const glm::dvec4 x = glm::inverse(A) * b;
  const glm::dvec3 c(x.x, x.y, x.z);
  return {origin + c, std::sqrt(std::max(0.0, x.w + glm::dot(c, c)))};
}

/// The direction that the normals have least of, then a circle across it by least squares.
Tube TubeOf(const Facets& facets, const std::vector<std::size_t>& part) {
  mjtNum sum[9] = {};
  for (const std::size_t f : part) {
    const glm::dvec3 n = facets.Normal(f);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) sum[3 * i + k] += facets.Area(f) * n[i] * n[k];
    }
  }
  mjtNum values[3], vectors[9], quat[4];
  mju_eig3(values, vectors, quat, sum);  // in decreasing order, as columns
  Tube tube;
  tube.axis = {vectors[2], vectors[5], vectors[8]};
  const glm::dvec3 u = glm::normalize(glm::cross(
      tube.axis, std::abs(tube.axis.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 v = glm::cross(tube.axis, u);
  const glm::dvec3 origin = facets.Corner(part.front(), 0);
  glm::dmat3 A(0.0);
  glm::dvec3 b(0.0);
  for (const std::size_t f : part) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 q3 = facets.Corner(f, k) - origin;
      const glm::dvec2 q(glm::dot(q3, u), glm::dot(q3, v));
      const glm::dvec3 row(2.0 * q, 1);
      A += glm::outerProduct(row, row);
      b += glm::dot(q, q) * row;
    }
  }
  if (!(std::abs(glm::determinant(A)) > 0)) return {};
  const glm::dvec3 x = glm::inverse(A) * b;
  tube.middle = origin + x.x * u + x.y * v;
  tube.radius = std::sqrt(std::max(0.0, x.z + x.x * x.x + x.y * x.y));
  return tube;
}

template <class Shape>
struct Part {
  Shape shape;
  std::vector<std::size_t> faces;
  double area = 0;  ///< [m2]; 0: no such part
};

Part<Plane> FlatPart(const Facets& facets, std::size_t seed) {
  constexpr double kLeastCosine = 0.995;  // 6 degrees: slivers have poor normals
  Part<Plane> part{PlaneOf(facets, {seed}), {}, 0};
  for (int turn = 0; turn < 3; ++turn) {
    part.faces = facets.Grow(seed, facets.count(), [&](std::size_t f, std::size_t) {
      return Keeps(facets, f, part.shape, kFlat, kLeastCosine);
    });
    if (turn < 2) part.shape = PlaneOf(facets, part.faces);
  }
  part.area = facets.AreaOf(part.faces);
  return part;
}

template <class Shape, class FitTo>
Part<Shape> RoundPart(const Facets& facets, const std::vector<std::size_t>& around,
                      const FitTo& fit) {
  constexpr double kLeastCosine = 0.94;  // 20 degrees: half of what a facet may turn, and more
  Part<Shape> part{fit(facets, around), {}, 0};
  for (int turn = 0; turn < 4; ++turn) {
    const double radius = part.shape.radius;
    if (!(radius > 1e-4 && radius < kGreatestRadius)) return part;
    const double tolerance = std::min(kRound, kRoundShare * radius);
    const auto keeps = [&](std::size_t f) {
      return Keeps(facets, f, part.shape, tolerance, kLeastCosine);
    };
    if (!keeps(around.front())) return part;
    part.faces = facets.Grow(around.front(), facets.count(),
                             [&](std::size_t f, std::size_t) { return keeps(f); });
    if (turn < 3) part.shape = fit(facets, part.faces);
  }
  if (ErrorOf(facets, part.faces, part.shape) > std::min(kRound, kRoundShare * part.shape.radius)) {
    return part;
  }
  part.area = facets.AreaOf(part.faces);
  return part;
}

/// Which squares of a raster over a flat part lie within it wholly.
struct Raster {
  static constexpr std::size_t kSide = 128;
  glm::dvec2 low{0, 0}, step{0, 0};  ///< [m]
  std::vector<std::uint8_t> corners = std::vector<std::uint8_t>((kSide + 1) * (kSide + 1), 0);
  bool Holds(std::size_t column, std::size_t row) const {
    const std::size_t at = row * (kSide + 1) + column;
    return (corners[at] & corners[at + 1] & corners[at + kSide + 1] & corners[at + kSide + 2]) != 0;
  }
};

/// Axes of a flat part: u to the right, v up, n out of it; columns of R.
Raster RasterOf(const Facets& facets, const Part<Plane>& part, const Pose& X_FR) {
  Raster raster;
  glm::dvec2 low(1e300), high(-1e300);
  const auto in_plane = [&](glm::dvec3 p_F) { return glm::dvec2(FromWorld(X_FR, p_F)); };
  for (const std::size_t f : part.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      low = glm::min(low, in_plane(facets.Corner(f, k)));
      high = glm::max(high, in_plane(facets.Corner(f, k)));
    }
  }
  raster.low = low;
  raster.step = (high - low) / static_cast<double>(Raster::kSide);
  for (const std::size_t f : part.faces) {
    const glm::dvec2 a = in_plane(facets.Corner(f, 0)), b = in_plane(facets.Corner(f, 1)),
                     c = in_plane(facets.Corner(f, 2));
    const auto side = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
      return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const glm::dvec2 from = (glm::min(a, glm::min(b, c)) - low) / raster.step;
    const glm::dvec2 to = (glm::max(a, glm::max(b, c)) - low) / raster.step;
    const double hair = 1e-9 * (high.x - low.x + high.y - low.y);
    const double slack = hair * glm::length(high - low);
    for (double row = std::floor(from.y); row <= to.y + 1; ++row) {
      for (double column = std::floor(from.x); column <= to.x + 1; ++column) {
        if (row < 0 || column < 0 || row > Raster::kSide || column > Raster::kSide) continue;
        const glm::dvec2 p = low + raster.step * glm::dvec2(column, row);
        if (side(a, b, p) < -slack || side(b, c, p) < -slack || side(c, a, p) < -slack) continue;
        raster.corners[static_cast<std::size_t>(row) * (Raster::kSide + 1) +
                       static_cast<std::size_t>(column)] = 1;
      }
    }
  }
  return raster;
}

struct Rectangle {
  glm::dvec2 low{0, 0}, high{0, 0};  ///< [m]
  double Area() const { return (high.x - low.x) * (high.y - low.y); }
};

/// The largest rectangle of squares that lie within the part: for each row, how far down each
/// column reaches, and then over the columns.
Rectangle LargestWithin(const Raster& raster) {
  Rectangle best;
  std::vector<std::size_t> height(Raster::kSide, 0);
  for (std::size_t row = 0; row < Raster::kSide; ++row) {
    for (std::size_t column = 0; column < Raster::kSide; ++column) {
      height[column] = raster.Holds(column, row) ? height[column] + 1 : 0;
    }
    for (std::size_t first = 0; first < Raster::kSide; ++first) {
      std::size_t least = height[first];
      for (std::size_t last = first; last < Raster::kSide && least > 0; ++last) {
        least = std::min(least, height[last]);
        const Rectangle found{raster.low + raster.step * glm::dvec2(first, row + 1 - least),
                              raster.low + raster.step * glm::dvec2(last + 1, row + 1)};
        if (found.Area() > best.Area()) best = found;
      }
    }
  }
  return best;
}

Fit BoxOf(const Facets& facets, const Part<Plane>& part, glm::dvec3 at, glm::dvec3 right) {
  const glm::dvec3 n = part.shape.n;
  const glm::dvec3 u = glm::normalize(right - glm::dot(right, n) * n);
  const Pose X_FR{glm::dmat3(u, glm::cross(n, u), n), part.shape.p};
  const Rectangle room = LargestWithin(RasterOf(facets, part, X_FR));
  const glm::dvec2 size = room.high - room.low;
  if (!(std::min(size.x, size.y) >= kLeastSide)) {
    return {{},
            fmt::format("the flat part there has no room for a rectangle of {:g} mm",
                        1e3 * kLeastSide)};
  }
  const glm::dvec2 middle = 0.5 * (room.low + room.high);
  const glm::dvec3 middle_F = ToWorld(X_FR, {middle, 0});
  // as deep as the mesh is below its middle
  constexpr double kJustBelow = 1e-4, kSheet = 2e-3;  // [m]
  const Hit back = FirstMet(facets, middle_F - kJustBelow * n, -n);
  const double depth = back.face == kNone ? kSheet : std::max(kSheet, back.distance + kJustBelow);
  FittedSolid fitted;
  fitted.solid = {SolidKind::kBox, {0.5 * size.x, 0.5 * size.y, 0.5 * depth}};
  fitted.X_FO = {X_FR.R, middle_F - 0.5 * depth * n};
  fitted.error = ErrorOf(facets, part.faces, part.shape);
  fitted.on_face = glm::dvec2(FromWorld(X_FR, at)) - middle;
  return {fitted, {}};
}

std::string OnlyPartly(const char* what, double share) {
  return fmt::format("{} there is closed to {:.0f} percent only; {:.0f} are needed", what,
                     100 * share, 100 * kClosed);
}

/// The chart's right hand is around the axis; text that runs along it is turned.
double TurnTo(glm::dvec3 right, glm::dvec3 u, glm::dvec3 v) {
  return std::atan2(glm::dot(right, v), glm::dot(right, u));
}

Fit CylinderOf(const Facets& facets, const Part<Tube>& part, glm::dvec3 at, glm::dvec3 right) {
  const Tube& tube = part.shape;
  double low = 1e300, high = -1e300;
  for (const std::size_t f : part.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = glm::dot(facets.Corner(f, k) - tube.middle, tube.axis);
      low = std::min(low, along);
      high = std::max(high, along);
    }
  }
  const double share = part.area / (2 * std::numbers::pi * tube.radius * (high - low));
  if (share < kClosed) return {{}, OnlyPartly("the cylinder", share)};
  // the axis points up, or to the back where it lies; the front is as near to -y as can be
  glm::dvec3 z = tube.axis;
  if (z.z < -1e-6 ||
      (std::abs(z.z) <= 1e-6 && (z.y < -1e-6 || (std::abs(z.y) <= 1e-6 && z.x < 0)))) {
    z = -z;
  }
  const glm::dvec3 back = std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 y = glm::normalize(back - glm::dot(back, z) * z);
  const glm::dvec3 x = glm::cross(y, z);
  FittedSolid fitted;
  fitted.solid = {SolidKind::kCylinder, {tube.radius, 0.5 * (high - low), 0}};
  fitted.X_FO = {glm::dmat3(x, y, z), tube.middle + 0.5 * (low + high) * tube.axis};
  fitted.error = ErrorOf(facets, part.faces, tube);
  const glm::dvec3 p = FromWorld(fitted.X_FO, at);
  const double angle = std::atan2(p.x, -p.y);
  fitted.on_face = {tube.radius * angle, p.z};
  fitted.turn = TurnTo(right, std::cos(angle) * x + std::sin(angle) * y, z);
  return {fitted, {}};
}

Fit SphereOf(const Facets& facets, const Part<Ball>& part, glm::dvec3 at, glm::dvec3 right) {
  const Ball& ball = part.shape;
  const double share = part.area / (4 * std::numbers::pi * ball.radius * ball.radius);
  if (share < kClosed) return {{}, OnlyPartly("the sphere", share)};
  FittedSolid fitted;
  fitted.solid = {SolidKind::kSphere, {ball.radius, 0, 0}};
  fitted.X_FO.p = ball.middle;
  fitted.error = ErrorOf(facets, part.faces, ball);
  const glm::dvec3 p = at - ball.middle;
  const double longitude = std::atan2(p.x, -p.y), across = std::hypot(p.x, p.y);
  fitted.on_face = {ball.radius * longitude, ball.radius * std::atan2(p.z, across)};
  const glm::dvec3 u(std::cos(longitude), std::sin(longitude), 0);
  fitted.turn = TurnTo(right, u, glm::cross(p / glm::length(p), u));
  return {fitted, {}};
}

}  // namespace

Fit FitSolid(const TriangleMesh& mesh, glm::dvec3 from_F, glm::dvec3 along_F, glm::dvec3 right_F) {
  const Facets facets(mesh);
  const Hit hit = FirstMet(facets, from_F, along_F);
  if (hit.face == kNone) return {{}, "nothing of the geom is met there"};
  const glm::dvec3 at = from_F + hit.distance * along_F;
  if (glm::dot(facets.Normal(hit.face), along_F) > -0.1) {
    return {{}, "the surface there is turned away from that face"};
  }
  const Part<Plane> flat = FlatPart(facets, hit.face);
  const std::vector<std::size_t> around = facets.Grow(
      hit.face, flat.faces.size() + kEnoughFacets, [&](std::size_t f, std::size_t before) {
        return glm::dot(facets.Normal(f), facets.Normal(before)) >= kSmooth;
      });
  const Part<Tube> tube = RoundPart<Tube>(facets, around, TubeOf);
  const Part<Ball> ball = RoundPart<Ball>(facets, around, BallOf);
  // facets of a round part are flat too, but small
  if (flat.area >= std::max(tube.area, ball.area)) return BoxOf(facets, flat, at, right_F);
  return tube.area > ball.area ? CylinderOf(facets, tube, at, right_F)
                               : SphereOf(facets, ball, at, right_F);
}

}  // namespace moontrace
