// What is fitted to a mesh is known from how the mesh was made: inscribed prisms and polyhedra,
// whose facets' middles lie below the surface by the sagitta r (1 - cos(half a facet)).
#include "sim/physics/fitted_solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace moontrace {
namespace {

constexpr double kPi = std::numbers::pi;

/// A cylinder of `facets` facets around z, of which the first `made` are there; with caps if all
/// are.
TriangleMesh Cylinder(std::size_t facets, std::size_t made, double radius, double half) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < facets; ++i) {
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(facets);
    for (const double z : {-half, half}) {
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  for (const double z : {-half, half}) mesh.points.emplace_back(0, 0, z);
  for (std::size_t i = 0; i < made; ++i) {
    const std::size_t a = 2 * i, b = 2 * ((i + 1) % facets);
    mesh.faces.push_back({a, b, b + 1});
    mesh.faces.push_back({a, b + 1, a + 1});
    if (made < facets) continue;
    mesh.faces.push_back({2 * facets, b, a});
    mesh.faces.push_back({2 * facets + 1, a + 1, b + 1});
  }
  return mesh;
}

/// A ring around z (a torus), or with `around` of zero a sphere of radius `tube`.
TriangleMesh Ring(std::size_t n, double around, double tube) {
  TriangleMesh mesh;
  const bool ball = around == 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const double a = 2 * kPi * static_cast<double>(i) / static_cast<double>(n);
      const double b = ball ? kPi * (static_cast<double>(k) / static_cast<double>(n - 1) - 0.5)
                            : 2 * kPi * static_cast<double>(k) / static_cast<double>(n);
      const double across = k == 0 || k + 1 == n ? (ball ? 0 : around + tube * std::cos(b))
                                                 : around + tube * std::cos(b);
      mesh.points.emplace_back(across * std::cos(a), across * std::sin(a), tube * std::sin(b));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k + (ball ? 1 : 0) < n; ++k) {
      const std::size_t next = (i + 1) % n, up = (k + 1) % n;
      mesh.faces.push_back({i * n + k, next * n + k, next * n + up});
      mesh.faces.push_back({i * n + k, next * n + up, i * n + up});
    }
  }
  return mesh;
}

TriangleMesh Box(glm::dvec3 half) {
  TriangleMesh mesh;
  for (const double z : {-half.z, half.z}) {
    for (const double y : {-half.y, half.y}) {
      for (const double x : {-half.x, half.x}) mesh.points.emplace_back(x, y, z);
    }
  }
  constexpr std::size_t kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& s : kSides) {
    mesh.faces.push_back({s[0], s[1], s[2]});
    mesh.faces.push_back({s[0], s[2], s[3]});
  }
  return mesh;
}

/// Turned about an axis that is nobody's, and moved.
struct Moved {
  TriangleMesh mesh;
  Pose X_FM;
};
Moved MovedAway(TriangleMesh mesh) {
  const double a = 0.7, c = std::cos(a), s = std::sin(a), d = std::cos(0.4), e = std::sin(0.4);
  const Pose X_FM{glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * glm::dmat3(1, 0, 0, 0, d, e, 0, -e, d),
                  {0.3, -0.2, 0.5}};
  for (glm::dvec3& p : mesh.points) p = ToWorld(X_FM, p);
  return {std::move(mesh), X_FM};
}

Fit From(const Moved& moved, glm::dvec3 out_M, glm::dvec3 right_M, glm::dvec3 at_M = {0, 0, 0}) {
  return FitSolid(moved.mesh, ToWorld(moved.X_FM, at_M + out_M), TurnToWorld(moved.X_FM, -out_M),
                  TurnToWorld(moved.X_FM, right_M));
}

TEST(FittedSolid, FindsACylinderUnderItsFacets) {
  const Moved moved = MovedAway(Cylinder(48, 48, 0.04, 0.05));
  const Fit fit = From(moved, {0, -1, 0}, {1, 0, 0}, {0, 0, 0.01});
  ASSERT_TRUE(fit.solid) << fit.why;
  EXPECT_EQ(fit.solid->solid.kind, SolidKind::kCylinder);
  EXPECT_NEAR(fit.solid->solid.half.x, 0.04, 1e-9);
  EXPECT_NEAR(fit.solid->solid.half.y, 0.05, 1e-9);
  EXPECT_NEAR(fit.solid->error, 0.04 * (1 - std::cos(kPi / 48)), 1e-9);
  const glm::dvec3 axis_M = TurnFromWorld(moved.X_FM, fit.solid->X_FO.R[2]);
  EXPECT_NEAR(std::abs(axis_M.z), 1, 1e-9);
  EXPECT_NEAR(fit.solid->on_face.y, axis_M.z > 0 ? 0.01 : -0.01, 1e-9);
  EXPECT_NEAR(std::cos(fit.solid->turn), axis_M.z > 0 ? 1 : -1, 1e-9);
}

// Text that is to run along a lying cylinder is turned by a quarter.
TEST(FittedSolid, TextRunsAsItIsSeen) {
  const Moved moved{Cylinder(48, 48, 0.04, 0.05), {}};
  const Fit fit = From(moved, {0, -1, 0}, {0, 0, 1});
  ASSERT_TRUE(fit.solid) << fit.why;
  EXPECT_NEAR(fit.solid->turn, kPi / 2, 1e-9);
}

TEST(FittedSolid, FindsASphere) {
  const Moved moved = MovedAway(Ring(64, 0, 0.05));
  const Fit fit = From(moved, {1, 0, 0}, {0, 1, 0});
  ASSERT_TRUE(fit.solid) << fit.why;
  EXPECT_EQ(fit.solid->solid.kind, SolidKind::kSphere);
  EXPECT_NEAR(fit.solid->solid.half.x, 0.05, 1e-9);
  EXPECT_NEAR(glm::length(fit.solid->X_FO.p - moved.X_FM.p), 0, 1e-9);
}

TEST(FittedSolid, TakesAFlatSideAsDeepAsTheMeshIs) {
  const Moved moved = MovedAway(Box({0.1, 0.06, 0.004}));
  const Fit fit = From(moved, {0, 0, 1}, {1, 0, 0}, {0.02, -0.01, 0});
  ASSERT_TRUE(fit.solid) << fit.why;
  EXPECT_EQ(fit.solid->solid.kind, SolidKind::kBox);
  EXPECT_NEAR(glm::length(fit.solid->solid.half - glm::dvec3(0.1, 0.06, 0.004)), 0, 1e-9);
  EXPECT_NEAR(glm::length(fit.solid->X_FO.p - moved.X_FM.p), 0, 1e-9);
  EXPECT_NEAR(glm::length(fit.solid->on_face - glm::dvec2(0.02, -0.01)), 0, 1e-9);
  EXPECT_NEAR(fit.solid->error, 0, 1e-9);
}

// The largest square in a circle; a raster of 128 finds its sides to two of its squares.
TEST(FittedSolid, TakesARectangleWithinADisc) {
  const Fit fit = From({Cylinder(96, 96, 0.06, 0.005), {}}, {0, 0, 1}, {1, 0, 0});
  ASSERT_TRUE(fit.solid) << fit.why;
  const glm::dvec3 half = fit.solid->solid.half;
  EXPECT_LE(glm::length(glm::dvec2(half)), 0.06);
  EXPECT_NEAR(half.x * half.y, 0.5 * 0.06 * 0.06, 0.06 * 4 * 0.12 / 128);
}

TEST(FittedSolid, SaysWhyNothingFits) {
  const Fit ring = From({Ring(48, 0.05, 0.02), {}}, {0, 0, 1}, {1, 0, 0}, {0.05, 0, 0});
  EXPECT_FALSE(ring.solid);
  EXPECT_FALSE(ring.why.empty());
  const Fit hole = From({Ring(48, 0.05, 0.02), {}}, {0, 0, 1}, {1, 0, 0});
  EXPECT_NE(hole.why.find("nothing"), std::string::npos) << hole.why;
  // half of it, met from outside
  const Fit half = From({Cylinder(48, 24, 0.04, 0.05), {}}, {0, 1, 0}, {-1, 0, 0});
  EXPECT_FALSE(half.solid);
  EXPECT_NE(half.why.find("50 percent"), std::string::npos) << half.why;
  const Fit small = From({Box({0.002, 0.002, 0.002}), {}}, {0, 0, 1}, {1, 0, 0});
  EXPECT_FALSE(small.solid);
  EXPECT_NE(small.why.find("room"), std::string::npos) << small.why;
}

TEST(FittedSolid, BrokenMeshesEndInALine) {
  EXPECT_FALSE(From({{}, {}}, {0, 0, 1}, {1, 0, 0}).solid);
  TriangleMesh flat;
  flat.points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  flat.faces = {{0, 1, 2}, {0, 0, 0}};
  EXPECT_FALSE(From({flat, {}}, {0, 0, 1}, {1, 0, 0}).solid);
}

}  // namespace
}  // namespace moontrace
