#include "textures/objects/label_chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "textures/base/random.h"

namespace moontrace {
namespace {

/// Evenly between two numbers.
double Between(Random& random, double low, double high) {
  return low + (high - low) * random.Uniform();
}

constexpr double kPi = std::numbers::pi;

const Solid kBox{SolidKind::kBox, {0.03, 0.02, 0.01}};
const Solid kCylinder{SolidKind::kCylinder, {0.03, 0.05, 0}};
const Solid kSphere{SolidKind::kSphere, {0.05, 0, 0}};
const Solid kCapsule{SolidKind::kCapsule, {0.02, 0.03, 0}};
const Solid kEllipsoid{SolidKind::kEllipsoid, {0.06, 0.04, 0.03}};

/// Every face of every solid, the label away from its middle and turned.
std::vector<std::pair<Solid, LabelPlace>> Everywhere() {
  std::vector<std::pair<Solid, LabelPlace>> all;
  for (const Solid& solid :
       {Solid{SolidKind::kPlane, {0.1, 0.1, 0}}, kBox, kCylinder, kSphere, kCapsule, kEllipsoid}) {
    for (const Face face : {Face::kTop, Face::kBottom, Face::kFront, Face::kBack, Face::kLeft,
                            Face::kRight, Face::kRound}) {
      if (!HasFace(solid, face)) continue;
      all.push_back({solid, {face, {0.004, -0.003}, {0.02, 0.01}, 0.6}});
    }
  }
  return all;
}

double PathLength(const LabelChart& chart, glm::dvec2 from, glm::dvec2 to) {
  constexpr int kSteps = 20000;
  double length = 0;
  glm::dvec3 last = chart.ToObject({from, 0});
  for (int i = 1; i <= kSteps; ++i) {
    const glm::dvec2 p = from + static_cast<double>(i) / kSteps * (to - from);
    const glm::dvec3 next = chart.ToObject({p, 0});
    length += glm::distance(last, next);
    last = next;
  }
  return length;
}

TEST(LabelChart, ThereAndBackIsTheSamePoint) {
  for (const auto& [solid, place] : Everywhere()) {
    const LabelChart chart(solid, place);
    Random random(1);
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 p_P(place.on_page.x + Between(random, -0.003, 0.003),
                           place.on_page.y + Between(random, -0.003, 0.003),
                           Between(random, -0.002, 0.002));
      const glm::dvec3 p_O = chart.ToObject(p_P);
      const Nearest nearest = NearestOf(solid, p_O);
      EXPECT_EQ(nearest.face, place.face);
      EXPECT_NEAR(nearest.height, p_P.z, 1e-12);
      EXPECT_NEAR(glm::distance(chart.At(p_O).p_P, glm::dvec2(p_P)), 0, 1e-12);
      EXPECT_NEAR(chart.Above(p_O).height, p_P.z, 1e-12);
      EXPECT_NEAR(glm::distance(chart.Above(p_O).normal_O, nearest.normal_O), 0, 1e-12);
    }
  }
}

TEST(LabelChart, ItsFaceGoesOnBeyondItsEdges) {
  const LabelChart side(kCylinder, {Face::kRound, {0, 0}, {0, 0}, 0});
  EXPECT_NEAR(side.Above({0, -0.031, 0.07}).height, 0.001, 1e-15);
  const LabelChart front(kBox, {Face::kFront, {0, 0}, {0, 0}, 0});
  EXPECT_NEAR(front.Above({0.2, -0.019, 0}).height, -0.001, 1e-15);
}

TEST(LabelChart, ReadsFromLeftToRightFromOutside) {
  for (const auto& [solid, place] : Everywhere()) {
    const LabelChart chart(solid, place);
    const glm::dvec3 p_O = chart.ToObject({place.on_page, 0});
    const LabelChart::Point at = chart.At(p_O);
    EXPECT_GT(glm::dot(glm::cross(at.dx_O, at.dy_O), NearestOf(solid, p_O).normal_O), 0.9);
  }
}

TEST(LabelChart, GradientsAreItsDerivatives) {
  constexpr double kStep = 1e-6;
  for (const auto& [solid, place] : Everywhere()) {
    const LabelChart chart(solid, place);
    Random random(2);
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 p_O = chart.ToObject({place.on_page.x + Between(random, -0.005, 0.005),
                                             place.on_page.y + Between(random, -0.005, 0.005),
                                             Between(random, -0.003, 0.003)});
      const LabelChart::Point at = chart.At(p_O);
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0);
        step[axis] = kStep;
        const glm::dvec2 slope =
            (chart.At(p_O + step).p_P - chart.At(p_O - step).p_P) / (2 * kStep);
        EXPECT_NEAR(slope.x, at.dx_O[axis], 1e-6);
        EXPECT_NEAR(slope.y, at.dy_O[axis], 1e-6);
      }
    }
  }
}

TEST(LabelChart, IsTrueToScaleOnCylinderAndAlongTheMiddleOfASphere) {
  // three quarters around a mug, and up its side; along and across the axis of a handle
  const LabelChart mug(kCylinder, {Face::kRound, {0, 0}, {0.07, 0}, 0});
  EXPECT_NEAR(PathLength(mug, {0, 0}, {0.14, 0.03}) / std::hypot(0.14, 0.03), 1, 1e-7);
  const LabelChart handle(kCapsule, {Face::kRound, {0, 0}, {0.02, 0}, kPi / 2});
  EXPECT_NEAR(PathLength(handle, {0, -0.01}, {0.04, 0.01}) / std::hypot(0.04, 0.02), 1, 1e-7);
  // wherever it lies and however it is turned
  const LabelChart globe(kSphere, {Face::kRound, {0.04, 0.03}, {0.03, 0.006}, 0.5});
  EXPECT_NEAR(PathLength(globe, {0, 0.006}, {0.06, 0.006}), 0.06, 1e-9);
  EXPECT_NEAR(PathLength(globe, {0.03, 0}, {0.03, 0.012}), 0.012, 1e-9);
  // 1 percent at 0.14 of the radius, 1 - cos by the closed form
  EXPECT_NEAR(PathLength(globe, {0, 0.013}, {0.06, 0.013}), 0.06 * std::cos(0.14), 1e-8);
}

TEST(LabelChart, AlongTheEquatorOfAnEllipsoidIsTrueToScale) {
  // by the circumference that Ramanujan's second approximation gives, exact to 1e-9 at this ratio
  const double a = 0.06, b = 0.04, h = (a - b) * (a - b) / ((a + b) * (a + b));
  const double around = kPi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  EXPECT_NEAR(EllipseArc(b, a).around(), around, 1e-9);
  const LabelChart round(kEllipsoid, {Face::kRound, {0, 0}, {0, 0}, 0});
  EXPECT_NEAR(PathLength(round, {-0.05, 0}, {0.05, 0}), 0.1, 1e-8);
}

TEST(LabelChart, ErrorOfLengthsIsWhatASphereHasByItsFormula) {
  const LabelChart globe(kSphere, {Face::kRound, {0, 0}, {0.03, 0.01}, 0});
  const Box text{{0, 0}, {0.06, 0.02}};
  EXPECT_NEAR(LengthError(globe, text), 1 - std::cos(0.01 / 0.05), 1e-9);
  const LabelChart mug(kCylinder, {Face::kRound, {0, 0}, {0.03, 0.01}, 0});
  EXPECT_NEAR(LengthError(mug, text), 0, 1e-12);
}

TEST(LabelChart, KnowsWhatFits) {
  const Box text{{0, 0}, {0.05, 0.01}};
  const LabelPlace on_top{Face::kTop, {0, 0}, {0.025, 0.005}, 0};
  EXPECT_TRUE(Fits(kBox, on_top, text));
  EXPECT_TRUE(Fits(kBox, {Face::kTop, {0.005, 0}, {0.025, 0.005}, 0}, text));
  EXPECT_FALSE(Fits(kBox, {Face::kTop, {0.006, 0}, {0.025, 0.005}, 0}, text));
  EXPECT_FALSE(Fits(kBox, {Face::kTop, {0, 0}, {0.025, 0.005}, kPi / 2}, text));
  EXPECT_FALSE(Fits(kBox, {Face::kRight, {0, 0}, {0.025, 0.005}, 0}, text));
  const Solid plane{SolidKind::kPlane, {0, 0, 0}};
  EXPECT_TRUE(Fits(plane, {Face::kTop, {5, 7}, {0, 0}, 1}, text));
  // around a cylinder it may begin anywhere, but must end before it begins
  EXPECT_TRUE(Fits(kCylinder, {Face::kRound, {0.09, 0}, {0, 0}, 0}, {{0, 0}, {0.17, 0.01}}));
  EXPECT_FALSE(Fits(kCylinder, {Face::kRound, {0, 0}, {0, 0}, 0}, {{0, 0}, {0.18, 0.01}}));
  EXPECT_FALSE(Fits(kCylinder, {Face::kTop, {0, 0}, {0.025, 0.005}, 0}, text));
  EXPECT_TRUE(Fits(kSphere, {Face::kRound, {0, 0.07}, {0.025, 0.005}, 0}, text));
  EXPECT_FALSE(Fits(kSphere, {Face::kRound, {0, 0}, {0, 0}, 0}, {{0, 0}, {0.05, 0.06}}));
}

}  // namespace
}  // namespace moontrace
