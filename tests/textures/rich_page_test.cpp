// A page with everything on at once: links, rules, margin, rough paper, a heading of ridges.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "textures/field.h"
#include "textures/script.h"
#include "textures/typeset.h"

namespace moontrace {
namespace {

constexpr double kWide = 0.15, kHigh = 0.12;  // [m]

Texture RichPage() {
  const Script moon = FindScript("moon");
  TypeStyle style = DefaultStyle(0.008, Relief::kEngraved, moon);
  style.line_pitch = 0.018;
  style.structure.read = style.structure.texture = true;
  style.structure.heading_relief = Relief::kEmbossed;
  style.links.reach = LinkReach::kWords;
  style.rules.lines = style.rules.margin = true;
  style.texture.paper = PaperTexture{};
  const Typeset set = SetText("# Moon\nlines of [text](x)\n> and ohm", moon, style,
                              {"custom", kWide, kHigh, 0.010});
  return BuildTexture(set.pages.at(0), moon, style);
}

TEST(RichPage, HasGroovesRidgesAndPaper) {
  const Texture texture = RichPage();
  EXPECT_GE(texture.layers.size(), 2U);
  EXPECT_GE(texture.paper.size(), 4U);  // the sheet's, heading's, link's, quotation's
}

TEST(RichPage, CompiledFieldIsTheTree) {
  const Texture texture = RichPage();
  const TextureField field(texture);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> x(0, kWide), y(0, kHigh);
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec2 p(x(random), y(random));
    const Sample tree = SampleTree(texture, p), flat = field.SampleAt(p);
    // a few units in the last place of the page's 150 mm, times a slope below 5
    ASSERT_NEAR(flat.displacement, tree.displacement, 1e-15) << p.x << " " << p.y;
  }
}

// Along random ways in steps of 1 um displacement changes by no more than the greatest slope
// allows, and off creases the gradient is the derivative.
TEST(RichPage, DisplacementIsContinuousAndItsDerivativeTheGradient) {
  const TextureField field(RichPage());
  constexpr double kStep = 1e-6, kSmall = 1e-9;
  const double steepest = 2 * field.greatest_slope();  // blending adds two flanks at most
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> x(0, kWide), y(0, kHigh), turn(0, 6.283);
  int wrong = 0, count = 0;
  for (int way_number = 0; way_number < 300; ++way_number) {
    const double angle = turn(random);
    const glm::dvec2 way(std::cos(angle), std::sin(angle));
    glm::dvec2 p(x(random), y(random));
    double before = field.SampleAt(p).displacement;
    for (int i = 0; i < 3000; ++i) {
      p += kStep * way;
      const Sample sample = field.SampleAt(p);
      ASSERT_LE(std::abs(sample.displacement - before), steepest * kStep + 1e-15)
          << p.x << " " << p.y;
      before = sample.displacement;
      const double rise = (field.SampleAt(p + kSmall * way).displacement -
                           field.SampleAt(p - kSmall * way).displacement) /
                          (2 * kSmall);
      ++count;
      // curvature up to 1e5 /m over 1 nm, and cancellation of 1e-19 m over it
      if (std::abs(rise - glm::dot(sample.gradient, way)) > 2e-4) ++wrong;
    }
  }
  EXPECT_EQ(count, 900000);
  EXPECT_LT(wrong, count / 1000);  // points within 1 nm of a crease
}

}  // namespace
}  // namespace moontrace
