// The law of the field on every solid: force is the gradient of a potential, zero outside, and a
// closed way costs nothing.
#include "textures/objects/solid_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "textures/base/random.h"

namespace moontrace {
namespace {

/// Evenly between two numbers.
double Between(Random& random, double low, double high) {
  return low + (high - low) * random.Uniform();
}

constexpr double kPi = std::numbers::pi;
constexpr Profile kGroove{0.0014, 0.0007, 0.00028};

/// A cross and a ring about the page's middle at the origin, 16 mm wide.
TextureField Marks(Relief relief) {
  Group group;
  group.elements.push_back({Line{{-0.008, 0.001}, {0.008, 0.001}}, kGroove});
  group.elements.push_back({Line{{0.001, -0.006}, {0.001, 0.006}}, kGroove});
  group.elements.push_back({Arc{{0.003, -0.002}, 0.003, 0, 2 * kPi}, kGroove});
  Texture texture;
  texture.layers.push_back({Finish(std::move(group)), relief});
  return TextureField(texture);
}

struct Case {
  std::string name;
  Solid solid;
  std::vector<LabelPlace> places;
};

std::vector<Case> Cases() {
  const glm::dvec2 none(0, 0);
  std::vector<LabelPlace> faces;
  for (const Face face :
       {Face::kTop, Face::kBottom, Face::kFront, Face::kBack, Face::kLeft, Face::kRight}) {
    faces.push_back({face, {0.002, -0.003}, none, 0.3});
  }
  return {
      {"plane", {SolidKind::kPlane, {0.1, 0.1, 0}}, {{Face::kTop, {0.01, 0.02}, none, 0.5}}},
      {"box", {SolidKind::kBox, {0.03, 0.025, 0.02}}, faces},
      {"cylinder",
       {SolidKind::kCylinder, {0.03, 0.05, 0}},
       {{Face::kRound, {0.08, 0.01}, none, 0.4},
        {Face::kTop, {0, 0}, none, 1},
        {Face::kBottom, {0, 0}, none, 0}}},
      {"sphere", {SolidKind::kSphere, {0.04, 0, 0}}, {{Face::kRound, {0.03, 0.02}, none, 0.7}}},
      {"capsule",
       {SolidKind::kCapsule, {0.02, 0.004, 0}},
       {{Face::kRound, {0.01, 0.002}, none, kPi / 2}}},
      {"spheroid", {SolidKind::kEllipsoid, {0.04, 0.04, 0.03}}, {{Face::kRound, {0.01, 0.01}}}},
      {"ellipsoid",
       {SolidKind::kEllipsoid, {0.05, 0.035, 0.03}},
       {{Face::kRound, {0.02, -0.01}, none, 0.2}}},
  };
}

struct Rig {
  Rig(const Case& given, const TextureField& field, ForceLaw kind) : solid(given.solid) {
    for (const LabelPlace& place : given.places) {
      LabelOnSolid label{LabelChart(solid, place), &field, 1};
      label.stretch = ScalesOf(label.chart, {{-0.009, -0.007}, {0.009, 0.007}}).greatest;
      labels.push_back(label);
    }
    law = LawOn(solid, {1000, 4, kind}, labels);
  }
  SolidContact At(glm::dvec3 p) const { return TouchSolid(law, solid, labels, p); }
  double Energy(glm::dvec3 p) const {
    const SolidContact contact = At(p);
    return Potential(law, contact.displacement, contact.nearest.height);
  }
  /// A random point about a label, at most `deep` below the surface and 1 mm above it.
  glm::dvec3 Somewhere(Random& random, double deep) const {
    const LabelOnSolid& label =
        labels[static_cast<std::size_t>(Between(random, 0, static_cast<double>(labels.size())))];
    return label.chart.ToObject({Between(random, -0.009, 0.009), Between(random, -0.007, 0.007),
                                 Between(random, -deep, 0.001)});
  }

  Solid solid;
  std::vector<LabelOnSolid> labels;
  SurfaceLaw law;
};

/// -dE/dp by differences to both sides, and whether these agree: not across a crease.
glm::dvec3 Slope(const Rig& rig, glm::dvec3 p, bool& smooth) {
  constexpr double kStep = 1e-7;
  glm::dvec3 force(0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = kStep;
    const double before = rig.Energy(p - step), here = rig.Energy(p), after = rig.Energy(p + step);
    force[axis] = (before - after) / (2 * kStep);
    // at the greatest curvature a second difference is k_eff h^2; a crease gives F h
    smooth = smooth && std::abs(before + after - 2 * here) < 3e4 * kStep * kStep;
  }
  return force;
}

TEST(SolidContact, ForceIsTheGradientOfThePotential) {
  for (const Case& given : Cases()) {
    for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
      const TextureField field = Marks(relief);
      const Rig rig(given, field, ForceLaw::kPotential);
      Random random(7);
      int tried = 0, felt = 0;
      for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 p = rig.Somewhere(random, 0.006);
        bool smooth = true;
        const glm::dvec3 slope = Slope(rig, p, smooth);
        if (!smooth) continue;
        ++tried;
        const SolidContact contact = rig.At(p);
        if (glm::length(contact.gradient_O) > 0.1 && contact.depth > 0) ++felt;
        // a central difference of step h errs by h^2 / 6 of the third derivative, and by rounding
        // of energies of 0.02 J over h
        EXPECT_NEAR(glm::distance(contact.force_O, slope), 0, 1e-4) << given.name;
      }
      EXPECT_GT(tried, 3000) << given.name;
      EXPECT_GT(felt, 300) << given.name;
    }
  }
}

TEST(SolidContact, IsZeroOutsideAndWithinTheCapInside) {
  for (const Case& given : Cases()) {
    for (const ForceLaw kind : {ForceLaw::kPotential, ForceLaw::kPaper}) {
      const TextureField field = Marks(Relief::kEngraved);
      const Rig rig(given, field, kind);
      const double deepest = ThroughDepthOn(rig.solid, rig.law.surface, rig.labels);
      Random random(8);
      for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 p = rig.Somewhere(random, deepest);
        const SolidContact contact = rig.At(p);
        if (contact.nearest.height >= 0) {
          EXPECT_EQ(contact.force_O, glm::dvec3(0)) << given.name;
          EXPECT_LE(contact.depth, 0) << given.name;
        }
        EXPECT_LE(glm::length(contact.force_O), 4 * (1 + 1e-12)) << given.name;
      }
    }
  }
}

/// Sum of force times way round a closed path, as the midpoint rule has it, and of magnitudes.
struct Lap {
  double energy = 0, exchanged = 0;
};
Lap LapOf(const Rig& rig, const std::function<glm::dvec3(double)>& path) {
  constexpr int kSteps = 200000;
  Lap lap;
  glm::dvec3 last = path(0);
  for (int i = 1; i <= kSteps; ++i) {
    const glm::dvec3 next = path(static_cast<double>(i) / kSteps);
    const double work = glm::dot(rig.At(0.5 * (last + next)).force_O, next - last);
    lap.energy += work;
    lap.exchanged += std::abs(work);
    last = next;
  }
  return lap;
}

TEST(SolidContact, AClosedPathCostsNothing) {
  for (const Case& given : Cases()) {
    const TextureField field = Marks(Relief::kEngraved);
    const Rig rig(given, field, ForceLaw::kPotential);
    for (const LabelOnSolid& label : rig.labels) {
      const Lap lap = LapOf(rig, [&](double t) {
        const double angle = 2 * kPi * t;
        return label.chart.ToObject({0.006 * std::cos(angle), 0.005 * std::sin(2 * angle + 1),
                                     -0.0025 + 0.003 * std::sin(3 * angle)});
      });
      EXPECT_GT(lap.exchanged, 1e-3) << given.name;
      // 1 uJ a lap is the design's bound at the cap
      EXPECT_LT(std::abs(lap.energy), 1e-6) << given.name;
    }
  }
}

// Over an edge of a box, where the nearest face changes: the potential is continuous there, so a
// lap still costs nothing.
TEST(SolidContact, AClosedPathOverAnEdgeCostsNothing) {
  const TextureField field = Marks(Relief::kEngraved);
  for (const Case& given : {Cases()[1], Cases()[2]}) {
    const Rig rig(given, field, ForceLaw::kPotential);
    const double side = given.solid.half.x;
    const double top =
        given.solid.kind == SolidKind::kBox ? given.solid.half.z : given.solid.half.y;
    const Lap lap = LapOf(rig, [&](double t) {
      const double angle = 2 * kPi * t;
      return glm::dvec3(side - 0.001 + 0.002 * std::cos(angle), 0.001 * std::sin(angle),
                        top - 0.0015 + 0.0012 * std::sin(angle));
    });
    EXPECT_GT(lap.exchanged, 1e-3);
    EXPECT_LT(std::abs(lap.energy), 1e-6) << given.name;
  }
}

TEST(SolidContact, ForceIsContinuousOffTheCreasesAndEdges) {
  constexpr double kStep = 1e-8;
  for (const Case& given : Cases()) {
    const TextureField field = Marks(Relief::kEngraved);
    const Rig rig(given, field, ForceLaw::kPotential);
    const double stiffness = StiffnessOn(rig.solid, rig.law.surface, rig.labels);
    const double deepest = ThroughDepthOn(rig.solid, rig.law.surface, rig.labels);
    Random random(9);
    int jumps = 0;
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec3 p = rig.Somewhere(random, deepest);
      const glm::dvec3 way =
          glm::normalize(glm::dvec3(Between(random, -1, 1), Between(random, -1, 1), 0.5));
      const double change = glm::distance(rig.At(p).force_O, rig.At(p + kStep * way).force_O);
      if (change > 1.01 * stiffness * kStep + 1e-12) ++jumps;
    }
    // a step meets a crease of these marks, or an edge, with a chance of 1e-5
    EXPECT_LE(jumps, 2) << given.name;
  }
}

TEST(SolidContact, AThinPlateIsFeltFromTheSideItWasEntered) {
  const Solid plate{SolidKind::kBox, {0.05, 0.05, 0.001}};
  const SurfaceLaw law = LawOn(plate, {}, {});
  Sides sides;
  Remember(plate, 0.008, {0.01, 0, 0.002}, sides);
  EXPECT_EQ(sides.of, glm::dvec3(0, 0, 1));
  // 1.5 mm below its upper face, nearer to the lower one
  const glm::dvec3 deep(0.01, 0, -0.0005);
  EXPECT_NEAR(TouchSolid(law, plate, {}, deep, sides).force_O.z, 1.5, 1e-12);
  EXPECT_NEAR(TouchSolid(law, plate, {}, deep).force_O.z, -0.5, 1e-12);
  // pressed out at its back: 2.5 mm below the upper face
  Remember(plate, 0.008, {0.01, 0, -0.0015}, sides);
  EXPECT_NEAR(TouchSolid(law, plate, {}, {0.01, 0, -0.0015}, sides).force_O.z, 2.5, 1e-12);
  // round its edge and to the back
  Remember(plate, 0.008, {0.051, 0, -0.002}, sides);
  EXPECT_EQ(TouchSolid(law, plate, {}, {0.01, 0, -0.002}, sides).force_O, glm::dvec3(0));
  EXPECT_LT(TouchSolid(law, plate, {}, {0.01, 0, -0.0005}, sides).force_O.z, 0);
}

TEST(SolidContact, APlaneIsThePageItself) {
  const TextureField field = Marks(Relief::kEngraved);
  const Solid plane{SolidKind::kPlane, {0, 0, 0}};
  const std::vector<LabelOnSolid> labels = {{LabelChart(plane, {}), &field, 1}};
  const Surface surface;
  const SurfaceLaw law = LawOn(plane, surface, labels);
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 p(Between(random, -0.009, 0.009), Between(random, -0.007, 0.007),
                       Between(random, -0.004, 0.001));
    const Contact page = Touch(surface, field, p);
    const SolidContact contact = TouchSolid(law, plane, labels, p);
    EXPECT_NEAR(glm::distance(contact.force_O, page.force_P), 0, 1e-12);
    EXPECT_NEAR(contact.depth, page.depth, 1e-15);
  }
}

}  // namespace
}  // namespace moontrace
