#include "textures/field/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "tests/textures/sample_page.h"

namespace moontrace {
namespace {

TEST(Surface, PushesBackByStiffnessTimesDepth) {
  const TextureField flat;
  for (const ForceLaw law : {ForceLaw::kPotential, ForceLaw::kPaper}) {
    const Surface surface{1000, 3, law};
    const Contact contact = Touch(surface, flat, {0.01, 0.02, -0.7e-3});
    EXPECT_DOUBLE_EQ(contact.depth, 0.7e-3);
    EXPECT_NEAR(contact.force_P.z, 0.7, 1e-15);  // k x depth
    EXPECT_EQ(contact.force_P.x, 0);
  }
}

TEST(Surface, GivesNothingOutsideAndForNonsense) {
  const SamplePage page = MakePage("moon", 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  for (const ForceLaw law : {ForceLaw::kPotential, ForceLaw::kPaper}) {
    const Surface surface{1000, 3, law};
    for (const glm::dvec3 p :
         {glm::dvec3(0.1, 0.1, 1e-9), glm::dvec3(0.1, 0.1, 0), glm::dvec3(NAN, 0, -1),
          glm::dvec3(0, 0, NAN), glm::dvec3(0, 0, -INFINITY), glm::dvec3(INFINITY, 0, -1)}) {
      EXPECT_EQ(Touch(surface, field, p).force_P, glm::dvec3(0.0, 0.0, 0.0));
    }
  }
}

TEST(Surface, NeverExceedsItsCap) {
  const SamplePage page = MakePage(kPangram, 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> x(0, 0.21), y(0.2, 0.297), z(-0.05, 0.001);
  for (const ForceLaw law : {ForceLaw::kPotential, ForceLaw::kPaper}) {
    const Surface surface{1000, 3, law};
    double greatest = 0;
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec3 force = Touch(surface, field, {x(random), y(random), z(random)}).force_P;
      greatest = std::max(greatest, glm::length(force));
    }
    EXPECT_LE(greatest, 3 * (1 + 1e-12));
    // the paper's law reaches it on the steepest flanks; the default law never has both shares
    // whole at one point: there phi = G, with s from 1.11 upwards, and psi = F_n - G
    EXPECT_GT(greatest, law == ForceLaw::kPaper ? 2.99 : 2.7);
  }
}

TEST(PaperLaw, IsDepthTimesStiffnessAlongTheNormal) {
  const SamplePage page = MakePage("i", 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const Surface surface{1000, 3, ForceLaw::kPaper};
  const glm::dvec2 origin = page.typeset.pages.front().glyphs.front().origin_P;
  // on the right flank of the upright line, half way down
  const glm::dvec2 flank = origin + glm::dvec2(page.typeset.style.width / 4, 0.006);
  const Contact contact = Touch(surface, field, {flank, -1e-3});
  const double slope = GreatestSlope(
      {page.typeset.style.width, page.typeset.style.depth, page.typeset.style.rounding});
  EXPECT_NEAR(contact.sample.gradient.x, slope, 1e-9);
  EXPECT_NEAR(glm::length(contact.force_P), 1000 * contact.depth, 1e-12);
  // the tip is pushed back towards the line: along (-slope, 0, 1)
  EXPECT_NEAR(contact.force_P.x / contact.force_P.z, -slope, 1e-9);
}

/// Work of the force along a closed way, by the trapezoid rule on fine steps [J].
double WorkOfALap(const Surface& surface, const TextureField& field,
                  const std::vector<glm::dvec3>& corners) {
  double work = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 from = corners[i], to = corners[(i + 1) % corners.size()];
    const int steps = 1 + static_cast<int>(glm::length(to - from) / 0.2e-6);
    glm::dvec3 force = Touch(surface, field, from).force_P;
    for (int k = 1; k <= steps; ++k) {
      const glm::dvec3 p = from + (to - from) * (static_cast<double>(k) / steps);
      const glm::dvec3 next = Touch(surface, field, p).force_P;
      work += glm::dot(0.5 * (force + next), (to - from) / static_cast<double>(steps));
      force = next;
    }
  }
  return work;
}

/// Rectangles upright over a page, from 0.8 mm to 6 mm deep: the cap is reached below.
std::vector<std::vector<glm::dvec3>> Laps(const SamplePage& page, int count) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<std::vector<glm::dvec3>> laps;
  for (int i = 0; i < count; ++i) {
    const auto& glyphs = page.typeset.pages.front().glyphs;
    const double em = page.typeset.style.size;
    const glm::dvec2 a =
        glyphs[random() % glyphs.size()].origin_P + em * glm::dvec2(share(random), share(random));
    const double angle = 6.28 * share(random);
    const glm::dvec2 b = a + 1e-3 * glm::dvec2(std::cos(angle), std::sin(angle));
    laps.push_back({{a, -0.8e-3}, {b, -0.8e-3}, {b, -6e-3}, {a, -6e-3}});
  }
  return laps;
}

// Design section 10: at most 1 uJ a lap with the cap reached. The trapezoid rule itself errs by up
// to step * |dF| summed: about 0.1 uJ here.
TEST(PotentialLaw, HandsOutNoEnergyAlongClosedWays) {
  const SamplePage page = MakePage(kPangram, 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const Surface surface{1000, 3, ForceLaw::kPotential};
  for (const auto& lap : Laps(page, 60)) {
    EXPECT_LT(std::abs(WorkOfALap(surface, field, lap)), 1e-6);
  }
}

// Guards the guard: the paper's law, whose capped vector is no gradient, does hand out energy.
TEST(PaperLaw, HandsOutEnergyAlongClosedWays) {
  const SamplePage page = MakePage(kPangram, 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const Surface surface{1000, 3, ForceLaw::kPaper};
  double greatest = 0;
  for (const auto& lap : Laps(page, 60)) {
    greatest = std::max(greatest, std::abs(WorkOfALap(surface, field, lap)));
  }
  EXPECT_GT(greatest, 100e-6);
}

TEST(PotentialLaw, ForceIsMinusTheDerivativeOfThePotential) {
  const SamplePage page = MakePage("moon", 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const Surface surface{1000, 3, ForceLaw::kPotential};
  const auto energy = [&](glm::dvec3 p) {
    return Potential(LawOf(surface, field), field.SampleAt({p.x, p.y}).displacement, p.z);
  };
  const glm::dvec2 origin = page.typeset.pages.front().glyphs.front().origin_P;
  const double step = 1e-8;
  // the last three: both potentials act, one, and both are saturated
  for (const double z : {-0.5e-3, -1.2e-3, -2.0e-3, -4e-3}) {
    // off the spine of M's upright line
    const glm::dvec3 p(origin + glm::dvec2(0.012 + 0.2e-3, 0.005), z);
    const glm::dvec3 force = Touch(surface, field, p).force_P;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 offset(0.0);
      offset[axis] = step;
      const double derivative = (energy(p + offset) - energy(p - offset)) / (2 * step);
      // second derivatives reach k s^2 + F s/r, about 2e4 N/m; energies of 5 mJ round at 1e-18 J
      EXPECT_NEAR(force[axis], -derivative, 2e4 * step + 4e-18 / step);
    }
  }
}

TEST(PotentialLaw, KeepsEachDirectionWithinItsShareOfTheCap) {
  const SamplePage page = MakePage(kPangram, 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const Surface surface{1000, 4, ForceLaw::kPotential};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> x(0, 0.21), y(0.2, 0.297), z(-0.01, 0.001);
  double sideways = 0, upwards = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 force = Touch(surface, field, {x(random), y(random), z(random)}).force_P;
    sideways = std::max(sideways, std::hypot(force.x, force.y));
    upwards = std::max(upwards, force.z);
    ASSERT_GE(force.z, 0);
  }
  EXPECT_LE(sideways, 0.55 * 4 * (1 + 1e-12));
  EXPECT_GT(sideways, 0.55 * 4 * 0.99);
  EXPECT_NEAR(upwards, 0.835 * 4, 1e-12);
}

// A steep page somewhere else must not make flat paper give way: this one carries what its device
// can, whatever is engraved on it.
TEST(PotentialLaw, FlatPaperBesideGroovesIsASpringUpToItsLimit) {
  const SamplePage page = MakePage("moon", 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const Surface surface{1000, 4, ForceLaw::kPotential};
  for (const double depth : {0.0005, 0.0012, 0.0014, 0.002, 0.0033}) {
    EXPECT_NEAR(Touch(surface, field, {0.1, 0.01, -depth}).force_P.z, 1000 * depth, 1e-12);
  }
  EXPECT_NEAR(Touch(surface, field, {0.1, 0.01, -0.02}).force_P.z, 0.835 * 4, 1e-12);
}

/// Where a press rests over a point [m], by bisection.
double RestingHeight(const Surface& surface, const TextureField& field, glm::dvec2 p_P,
                     double press) {
  double low = -0.01, high = 0;
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (low + high);
    (Touch(surface, field, {p_P, z}).force_P.z > press ? low : high) = z;
  }
  return low;
}

// The groove is felt whole up to a press of G - k D and then fades: (G + k D - P) / 2k.
TEST(PotentialLaw, GrooveIsFeltAsItsClosedFormSays) {
  const SamplePage page = MakePage("i", 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const Surface surface{1000, 4, ForceLaw::kPotential};
  const glm::dvec2 groove =
      page.typeset.pages.front().glyphs.front().origin_P + glm::dvec2(0, 0.006);
  const double D = -field.SampleAt(groove).displacement;
  const double G = 0.55 * 4 / field.greatest_slope();
  ASSERT_GT(D, 0.0005);
  ASSERT_GT(G, 1000 * D + 0.3);
  for (const double press : {0.1, 0.3, 0.9 * (G - 1000 * D), 1.0, 1.5, 2.5, 3.2}) {
    const double felt = RestingHeight(surface, field, {0.1, 0.01}, press) -
                        RestingHeight(surface, field, groove, press);
    const double expected =
        press <= G - 1000 * D ? D : std::max(0.0, (G + 1000 * D - press) / 2000);
    EXPECT_NEAR(felt, expected, 1e-12) << press;
  }
}

TEST(CarriedPress, IsCarriedEverywhereBeforeThePageIsThrough) {
  for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
    for (const double size : {0.006, 0.012, 0.04}) {
      const SamplePage page = MakePage("moon light", size, relief);
      const TextureField field(page.texture);
      for (const ForceLaw law : {ForceLaw::kPotential, ForceLaw::kPaper}) {
        const Surface surface{1000, 4, law};
        const double carried = CarriedPress(surface, field);
        const double z = -ThroughDepth(surface, field) + 0.0045;
        std::mt19937_64 random(9);
        std::uniform_real_distribution<double> x(0, 0.21), y(0, 0.297);
        for (int i = 0; i < 5000; ++i) {
          ASSERT_GT(Touch(surface, field, {x(random), y(random), z}).force_P.z, carried);
        }
      }
    }
  }
}

TEST(GreatestStiffness, OfThePapersLawIsKTimesOnePlusSlopeSquaredPlusPressTimesCurvature) {
  const SamplePage page = MakePage("i", 0.006, Relief::kEngraved);
  const TextureField field(page.texture);
  // 6 mm letters: w = 1.2 mm, D = 0.4 mm, r = 0.24 mm: s = 0.4 / 0.36, s/r = 4630 1/m
  const double s = 0.4 / 0.36;
  EXPECT_NEAR(GreatestStiffness({1000, 3, ForceLaw::kPaper}, field, 1.0),
              1000 * (1 + s * s) + s / 0.24e-3, 1e-6);
}

// By differences of the force itself, along many directions at many places.
TEST(GreatestStiffness, OfTheDefaultLawIsNeverExceededAndNearlyReached) {
  const SamplePage page = MakePage("i", 0.006, Relief::kEngraved);
  const TextureField field(page.texture);
  const Surface surface{1000, 4, ForceLaw::kPotential};
  const double stiffest = GreatestStiffness(surface, field, 4);
  const glm::dvec2 groove = page.typeset.pages.front().glyphs.front().origin_P;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> x(-0.001, 0.002), z(-0.004, 0), turn(-1, 1);
  double greatest = 0;
  for (int i = 0; i < 200000; ++i) {
    const glm::dvec3 p(groove.x + x(random), groove.y + 0.003, z(random));
    const glm::dvec3 step = 1e-9 * glm::normalize(glm::dvec3(turn(random), 0, turn(random)));
    const glm::dvec3 change =
        Touch(surface, field, p + step).force_P - Touch(surface, field, p).force_P;
    greatest = std::max(greatest, glm::length(change) / 1e-9);
  }
  EXPECT_LT(greatest, stiffest * (1 + 1e-5));
  EXPECT_GT(greatest, 0.8 * stiffest);
}

}  // namespace
}  // namespace moontrace
