#include "textures/field/paper_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <random>
#include <vector>

#include "tests/textures/sample_page.h"
#include "textures/base/error.h"
#include "textures/field/field.h"

namespace moontrace {
namespace {

/// Patches anyhow over a sheet of 200 x 100 mm, some of them overlapping.
std::vector<PaperPatch> SomePatches(std::size_t count) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<PaperPatch> patches;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 0.18 * share(random), y = 0.09 * share(random);
    const double w = 0.002 + 0.02 * share(random), h = 0.002 + 0.01 * share(random);
    PaperPatch patch{{{x, y}, {x + w, y + h}}, {}, 1e-3};
    patch.texture.kind = static_cast<PaperKind>(random() % 3);
    patch.texture.wavelength = 1e-3 + 1e-3 * share(random);
    patches.push_back(patch);
  }
  return patches;
}

// Every point in the patches' sheet, their corners and borders among them.
TEST(PaperFieldSearch, FindsEveryPatch) {
  const std::vector<PaperPatch> patches = SomePatches(300);
  Texture texture;
  texture.paper = patches;
  const TextureField field(texture);
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> share(-0.05, 1.05);
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 20000; ++i) points.emplace_back(0.2 * share(random), 0.1 * share(random));
  for (const PaperPatch& patch : patches) {
    points.push_back(patch.box_P.min);
    points.push_back(patch.box_P.max);
    points.push_back(0.5 * (patch.box_P.min + patch.box_P.max));
  }
  double displacement = 0, slope = 0;
  for (const glm::dvec2 p : points) {
    const Sample compiled = field.SampleAt(p), tree = SampleTree(texture, p);
    ASSERT_NEAR(compiled.displacement, tree.displacement, 1e-15);
    ASSERT_LE(glm::length(compiled.gradient - tree.gradient), 1e-11);
    displacement = std::max(displacement, std::abs(compiled.displacement));
    slope = std::max(slope, glm::length(compiled.gradient));
  }
  EXPECT_LE(displacement, field.greatest_displacement());
  EXPECT_LE(slope, field.greatest_slope());
  EXPECT_GT(displacement, 30e-6);  // of one patch alone: overlapping ones add
}

TEST(PaperFieldSum, AddsToTheText) {
  const SamplePage page = MakePage(kPangram, 0.012, Relief::kEngraved);
  PaperPatch patch{{{0, 0}, {0.21, 0.297}}, {}, 2e-3};
  Texture paper, both = page.texture;
  paper.paper = both.paper = {patch};
  const TextureField text_field(page.texture), paper_field(paper), sum(both);
  EXPECT_DOUBLE_EQ(sum.greatest_slope(),
                   text_field.greatest_slope() + paper_field.greatest_slope());
  EXPECT_DOUBLE_EQ(sum.greatest_curvature(),
                   text_field.greatest_curvature() + paper_field.greatest_curvature());
  EXPECT_GT(sum.memory_bytes(), text_field.memory_bytes());
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> x(0, 0.21), y(0.15, 0.297);
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec2 p(x(random), y(random));
    const Sample a = text_field.SampleAt(p), b = paper_field.SampleAt(p), c = sum.SampleAt(p);
    ASSERT_EQ(c.displacement, a.displacement + b.displacement);
    ASSERT_EQ(c.gradient, a.gradient + b.gradient);
  }
}

TEST(PaperFieldHash, TellsTexturesApart) {
  const auto hash_of = [](const PaperPatch& patch) {
    Texture texture;
    texture.paper = {patch};
    return TextureField(texture).Hash();
  };
  const PaperPatch patch{{{0, 0}, {0.1, 0.1}}, {}, 2e-3};
  const std::uint64_t plain = hash_of(patch);
  EXPECT_EQ(hash_of(patch), plain);
  PaperPatch other = patch;
  other.texture.seed = 2;
  EXPECT_NE(hash_of(other), plain);
  other = patch;
  other.texture.wavelength *= 1.01;
  EXPECT_NE(hash_of(other), plain);
  other = patch;
  other.box_P.max.x += 1e-3;
  EXPECT_NE(hash_of(other), plain);
  other = patch;
  other.texture.kind = PaperKind::kSampled;
  other.texture.heights =
      std::make_shared<const SampledHeights>(2, 2, std::vector<float>{0, 0, 0, 0.1F});
  const std::uint64_t sampled = hash_of(other);
  other.texture.heights =
      std::make_shared<const SampledHeights>(2, 2, std::vector<float>{0, 0, 0, 0.2F});
  EXPECT_NE(hash_of(other), sampled);
}

TEST(PaperFieldPoint, ThatIsNotFiniteMeetsNothing) {
  const PaperField field({PaperPatch{{{0, 0}, {0.1, 0.1}}, {}, 2e-3}});
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(field.SampleAt({bad, 0.05}).displacement, 0);
    EXPECT_EQ(field.SampleAt({0.05, -bad}).displacement, 0);
  }
}

TEST(PaperFieldLimits, TooManyAndTooFineAreRefused) {
  EXPECT_THROW(PaperField(SomePatches(4097)), InputError);
  PaperPatch fine{{{0, 0}, {0.9, 0.9}}, {}, 2e-3};
  fine.texture.wavelength = 1e-12;
  fine.texture.amplitude = 1e-15;
  EXPECT_THROW(PaperField({fine}), InputError);
}

}  // namespace
}  // namespace moontrace
