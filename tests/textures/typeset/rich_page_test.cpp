// A page with everything on at once: links, rules, margin, rough paper, a heading of ridges.
#include <gtest/gtest.h>

#include <glm/vec2.hpp>
#include <random>

#include "tests/textures/gradient_walk.h"
#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

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

// Paper is rough everywhere: every point is judged but those of ways that leave the sheet, a
// fiftieth.
TEST(RichPage, DisplacementIsContinuousAndItsDerivativeTheGradient) {
  ExpectGradientIsTheDerivative(TextureField(RichPage()), {kWide, kHigh}, 870000);
}

}  // namespace
}  // namespace moontrace
