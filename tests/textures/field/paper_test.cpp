#include "textures/field/paper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "textures/base/error.h"
#include "textures/field/field.h"

namespace moontrace {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::shared_ptr<const SampledHeights> SomeHeights() {
  std::mt19937_64 random(5);
  std::vector<float> heights;
  for (int i = 0; i < 24 * 16; ++i)
    heights.push_back(static_cast<float>(random() % 200) / 200 - 0.5F);
  return std::make_shared<const SampledHeights>(24, 16, heights);
}

PaperPatch PatchOf(PaperKind kind, bool tiled = false) {
  PaperPatch patch{{{0.01, 0.02}, {0.06, 0.05}}, {}, 2e-3};
  patch.texture.kind = kind;
  patch.texture.angle = 0.4;
  if (kind == PaperKind::kSampled) {
    patch.texture.heights = SomeHeights();
    patch.texture.wavelength = 0.02;
    patch.texture.tiled = tiled;
  }
  return patch;
}

struct Setting {
  const char* name;
  PaperKind kind;
  bool tiled = false;
};
class EachPaper : public ::testing::TestWithParam<Setting> {
 protected:
  PaperPatch Patch() const { return PatchOf(GetParam().kind, GetParam().tiled); }
};
INSTANTIATE_TEST_SUITE_P(Kinds, EachPaper,
                         ::testing::Values(Setting{"Sine", PaperKind::kSine},
                                           Setting{"Grid", PaperKind::kGrid},
                                           Setting{"Noise", PaperKind::kNoise},
                                           Setting{"Stretched", PaperKind::kSampled},
                                           Setting{"Tiled", PaperKind::kSampled, true}),
                         [](const auto& setting) { return setting.param.name; });

/// Points in and around a box.
class Points {
 public:
  Points(const Box& box, std::uint64_t seed) : box_(Grown(box, 2e-3)), random_(seed) {}
  glm::dvec2 Next() {
    std::uniform_real_distribution<double> share(0, 1);
    const double x = share(random_), y = share(random_);
    return box_.min + glm::dvec2(x, y) * (box_.max - box_.min);
  }

 private:
  Box box_;
  std::mt19937_64 random_;
};

// The compiled sine is exact to 1e-13 of the amplitude; the rest is rounding of the same formula.
TEST_P(EachPaper, CompiledIsTheTree) {
  const PaperPatch patch = Patch();
  Texture texture;
  texture.paper = {patch};
  const TextureField field(texture);
  const double steep = patch.texture.amplitude * kTurn / patch.texture.wavelength;
  Points points(patch.box_P, 1);
  int felt = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec2 p = points.Next();
    const Sample compiled = field.SampleAt(p), tree = SampleTree(texture, p);
    ASSERT_NEAR(compiled.displacement, tree.displacement, 1e-11 * patch.texture.amplitude);
    ASSERT_LE(glm::length(compiled.gradient - tree.gradient), 1e-11 * steep);
    felt += tree.displacement != 0 ? 1 : 0;
  }
  EXPECT_GT(felt, 50000);
}

// Central differences over a step h err by at most h/2 times the greatest second derivative, where
// the slope is C1 but no more (an array's samples, the fade's ends), and by rounding.
TEST_P(EachPaper, GradientIsTheDerivativeEverywhere) {
  const PaperPatch patch = Patch();
  const PaperBounds bounds = BoundsOf(patch);
  const double step = 1e-8;
  const double tolerance = step * bounds.curvature + 1e-19 / step;
  Points points(patch.box_P, 2);
  const auto height = [&patch](glm::dvec2 p) { return Evaluate(patch, p).displacement; };
  for (int i = 0; i < 50000; ++i) {
    const glm::dvec2 p = points.Next();
    const glm::dvec2 gradient = Evaluate(patch, p).gradient;
    ASSERT_NEAR(gradient.x,
                (height(p + glm::dvec2(step, 0)) - height(p - glm::dvec2(step, 0))) / (2 * step),
                tolerance);
    ASSERT_NEAR(gradient.y,
                (height(p + glm::dvec2(0, step)) - height(p - glm::dvec2(0, step))) / (2 * step),
                tolerance);
  }
}

// Walks across the borders too: neither displacement nor slope changes by more than the bounds
// allow, so both are continuous, and both are zero on the border and outside.
TEST_P(EachPaper, IsC1AcrossItsBorder) {
  const PaperPatch patch = Patch();
  const PaperBounds bounds = BoundsOf(patch);
  Points points(patch.box_P, 3);
  const double step = 1e-6;
  for (int walk = 0; walk < 200; ++walk) {
    const glm::dvec2 from = points.Next(), along = glm::normalize(points.Next() - from);
    Sample before = Evaluate(patch, from);
    for (int i = 1; i < 2000; ++i) {
      const Sample sample = Evaluate(patch, from + along * (step * i));
      ASSERT_LE(std::abs(sample.displacement - before.displacement),
                step * bounds.slope * (1 + 1e-6));
      ASSERT_LE(glm::length(sample.gradient - before.gradient),
                std::numbers::sqrt2 * step * bounds.curvature * (1 + 1e-6));
      before = sample;
    }
  }
  const Box& box = patch.box_P;
  for (double share = 0; share <= 1; share += 0.01) {
    const glm::dvec2 low = {box.min.x, box.min.y + share * (box.max.y - box.min.y)};
    EXPECT_EQ(Evaluate(patch, low).displacement, 0);
    EXPECT_LE(glm::length(Evaluate(patch, low).gradient), 1e-15);
    EXPECT_EQ(Evaluate(patch, low - glm::dvec2(1e-9, 0)).displacement, 0);
  }
}

// Bounds are reached to within a factor that says they are no mere formality: the fade's share and
// the worst meeting of lattice vectors are rare.
TEST_P(EachPaper, BoundsHoldAndAreClose) {
  const PaperPatch patch = Patch();
  const PaperBounds bounds = BoundsOf(patch);
  double displacement = 0, slope = 0;
  Points points(patch.box_P, 4);
  for (int i = 0; i < 200000; ++i) {
    const Sample sample = Evaluate(patch, points.Next());
    displacement = std::max(displacement, std::abs(sample.displacement));
    slope = std::max(slope, glm::length(sample.gradient));
  }
  EXPECT_LE(displacement, bounds.displacement * (1 + 1e-12));
  EXPECT_LE(slope, bounds.slope * (1 + 1e-12));
  EXPECT_GT(displacement, 0.5 * bounds.displacement);
  EXPECT_GT(slope, 0.3 * bounds.slope);
}

TEST(Paper, SineIsAWaveOfItsWavelength) {
  PaperPatch patch = PatchOf(PaperKind::kSine);
  patch.texture.angle = 0;
  const glm::dvec2 middle(0.03, 0.035);
  for (double x = 0; x < 0.004; x += 1e-4) {
    const glm::dvec2 p = middle + glm::dvec2(x, 0.3 * x);
    EXPECT_NEAR(Evaluate(patch, p).displacement,
                30e-6 * std::sin(kTurn * (p.x - patch.box_P.min.x) / 2e-3), 1e-16);
  }
}

// Gradient noise is zero on its lattice, and along lines it crosses zero as often as a wave of its
// wavelength: twice a wavelength, to the 5 percent that cells of half a wavelength give.
TEST(Paper, NoiseRisesAndFallsAsOftenAsItsWavelengthSays) {
  PaperPatch patch{{{0, 0}, {0.5, 0.5}}, {}, 1e-3};
  patch.texture.wavelength = 2e-3;
  EXPECT_NEAR(Evaluate(patch, {0.123, 0.321}).displacement, 0, 1e-15);
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> place(0.05, 0.25), angle(0, kTurn / 4);
  int crossings = 0;
  double length = 0;
  for (int line = 0; line < 100; ++line) {
    const double x = place(random), y = place(random), turn = angle(random);
    const glm::dvec2 along(std::cos(turn), std::sin(turn));
    double before = 0;
    for (int i = 0; i < 20000; ++i) {
      const double height = Evaluate(patch, glm::dvec2(x, y) + along * (1e-5 * i)).displacement;
      crossings += height * before < 0 ? 1 : 0;
      before = height;
    }
    length += 0.2;
  }
  EXPECT_NEAR(crossings * 0.5 * patch.texture.wavelength / length, 1, 0.05);
}

TEST(Paper, NoiseIsDrawnByItsSeed) {
  PaperPatch one = PatchOf(PaperKind::kNoise), other = one;
  other.texture.seed = 2;
  Points points(one.box_P, 7);
  int differ = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 p = points.Next();
    differ += Evaluate(one, p).displacement != Evaluate(other, p).displacement ? 1 : 0;
  }
  EXPECT_GT(differ, 700);
}

TEST(Paper, TooSteepOrBrokenIsRefusedInOneLine) {
  const auto error_of = [](const PaperPatch& patch) -> std::string {
    try {
      Check(patch);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  PaperPatch patch = PatchOf(PaperKind::kSine);
  EXPECT_EQ(error_of(patch), "");
  patch.texture.amplitude = 0.001;  // slope 2 pi / 2
  EXPECT_EQ(error_of(patch),
            "texture amplitude 1 mm is too steep for the wavelength 2 mm: at most 0.318 mm");
  patch = PatchOf(PaperKind::kNoise);
  patch.texture.wavelength = std::nan("");
  EXPECT_NE(error_of(patch), "");
  patch = PatchOf(PaperKind::kNoise);
  patch.box_P = Box{};
  EXPECT_NE(error_of(patch), "");
  patch = PatchOf(PaperKind::kSampled);
  patch.texture.heights = nullptr;
  EXPECT_NE(error_of(patch), "");
}

}  // namespace
}  // namespace moontrace
