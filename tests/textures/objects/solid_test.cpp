#include "textures/objects/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "textures/base/random.h"

namespace moontrace {
namespace {

/// Evenly between two numbers.
double Between(Random& random, double low, double high) {
  return low + (high - low) * random.Uniform();
}

std::vector<Solid> Solids() {
  return {{SolidKind::kPlane, {0.1, 0.1, 0}},        {SolidKind::kBox, {0.03, 0.02, 0.01}},
          {SolidKind::kCylinder, {0.03, 0.05, 0}},   {SolidKind::kSphere, {0.05, 0, 0}},
          {SolidKind::kCapsule, {0.02, 0.03, 0}},    {SolidKind::kEllipsoid, {0.06, 0.04, 0.03}},
          {SolidKind::kEllipsoid, {0.03, 0.03, 0.1}}};
}

glm::dvec3 Anywhere(Random& random, double reach) {
  return {Between(random, -reach, reach), Between(random, -reach, reach),
          Between(random, -reach, reach)};
}

// From the point against the normal by the height lies the surface: height zero. That point is the
// nearest: no point of the surface found from a neighbour is nearer.
TEST(Solid, NearestPointLiesOnTheSurfaceAndNoneIsNearer) {
  for (const Solid& solid : Solids()) {
    Random random(4);
    for (int i = 0; i < 3000; ++i) {
      const glm::dvec3 p = Anywhere(random, 0.12);
      const Nearest nearest = NearestOf(solid, p);
      EXPECT_NEAR(glm::length(nearest.normal_O), 1, 1e-12);
      const glm::dvec3 foot = p - nearest.height * nearest.normal_O;
      EXPECT_NEAR(NearestOf(solid, foot).height, 0, 1e-12) << static_cast<int>(solid.kind);
      const glm::dvec3 other = p + Anywhere(random, 0.03);
      const Nearest from_other = NearestOf(solid, other);
      const glm::dvec3 other_foot = other - from_other.height * from_other.normal_O;
      EXPECT_GE(glm::distance(p, other_foot), std::abs(nearest.height) - 1e-12);
    }
  }
}

TEST(Solid, HeightIsPositiveOutsideByTheSolidsOwnEquation) {
  for (const Solid& solid : Solids()) {
    Random random(5);
    for (int i = 0; i < 3000; ++i) {
      const glm::dvec3 p = Anywhere(random, 0.1), q = glm::abs(p);
      const glm::dvec3& a = solid.half;
      bool inside = p.z < 0;
      if (solid.kind == SolidKind::kBox) inside = q.x < a.x && q.y < a.y && q.z < a.z;
      if (solid.kind == SolidKind::kCylinder) inside = std::hypot(p.x, p.y) < a.x && q.z < a.y;
      if (solid.kind == SolidKind::kSphere) inside = glm::length(p) < a.x;
      if (solid.kind == SolidKind::kCapsule) {
        inside = glm::length(glm::dvec3(p.x, p.y, std::max(0.0, q.z - a.y))) < a.x;
      }
      if (solid.kind == SolidKind::kEllipsoid) inside = glm::length(p / a) < 1;
      EXPECT_EQ(NearestOf(solid, p).height < 0, inside) << static_cast<int>(solid.kind);
    }
  }
}

TEST(Solid, NormalIsTheGradientOfTheHeight) {
  constexpr double kStep = 1e-6;
  for (const Solid& solid : Solids()) {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 p = Anywhere(random, 0.1);
      const Nearest nearest = NearestOf(solid, p);
      if (nearest.height < -0.5 * GreatestDepth(solid)) continue;
      glm::dvec3 slope(0);
      bool smooth = true;
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0);
        step[axis] = kStep;
        const double after = NearestOf(solid, p + step).height;
        const double before = NearestOf(solid, p - step).height;
        slope[axis] = (after - before) / (2 * kStep);
        smooth = smooth && std::abs(after + before - 2 * nearest.height) < 1e-9;
      }
      if (!smooth) continue;
      EXPECT_NEAR(glm::distance(slope, nearest.normal_O), 0, 1e-6);
    }
  }
}

TEST(Solid, PointsOfNoDirectionGetOne) {
  for (const Solid& solid : Solids()) {
    const Nearest nearest = NearestOf(solid, {0, 0, 0});
    EXPECT_NEAR(glm::length(nearest.normal_O), 1, 1e-12);
    EXPECT_TRUE(std::isfinite(nearest.height));
  }
}

TEST(Solid, FacesHaveNamesThatAreRead) {
  for (const Face face : {Face::kTop, Face::kBottom, Face::kFront, Face::kBack, Face::kLeft,
                          Face::kRight, Face::kRound}) {
    EXPECT_EQ(FaceOf(NameOf(face)), face);
  }
  EXPECT_EQ(FaceOf("lid"), std::nullopt);
}

}  // namespace
}  // namespace moontrace
