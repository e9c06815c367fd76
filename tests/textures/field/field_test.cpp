#include "textures/field/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <random>
#include <vector>

#include "tests/textures/sample_page.h"
#include "textures/base/error.h"
#include "textures/relief/glyph_group.h"

namespace moontrace {
namespace {

/// Points where there is something to feel: in and around the letters of a page.
class Points {
 public:
  Points(const SamplePage& sample, std::uint64_t seed) : sample_(sample), random_(seed) {}
  glm::dvec2 Next() {
    const auto& glyphs = sample_.typeset.pages.front().glyphs;
    const PlacedGlyph& glyph = glyphs[random_() % glyphs.size()];
    std::uniform_real_distribution<double> around(-0.25, 1.25);
    const double em = sample_.typeset.style.size;
    return glyph.origin_P + em * glm::dvec2(around(random_), around(random_));
  }

 private:
  const SamplePage& sample_;
  std::mt19937_64 random_;
};

struct Setting {
  const char* name;
  double size;
  Relief relief;
  LinkReach links = LinkReach::kNone;
};
SamplePage PageOf(const Setting& setting) {
  SamplePage page = MakePage(kPangram, setting.size, setting.relief);
  if (setting.links == LinkReach::kNone) return page;
  page.typeset.style.links.reach = setting.links;
  page.texture = BuildTexture(page.typeset.pages.front(), page.script, page.typeset.style);
  return page;
}
class FieldOfAPage : public ::testing::TestWithParam<Setting> {};
INSTANTIATE_TEST_SUITE_P(Sizes, FieldOfAPage,
                         ::testing::Values(Setting{"Large", 0.020, Relief::kEngraved},
                                           Setting{"Small", 0.006, Relief::kEngraved},
                                           Setting{"Embossed", 0.010, Relief::kEmbossed},
                                           Setting{"Linked", 0.012, Relief::kEngraved,
                                                   LinkReach::kWords}),
                         [](const auto& setting) { return setting.param.name; });

// Places agree to 8 units in the last place of the page's width, and displacement changes by the
// slope times that; blending may add the other member's slope.
TEST_P(FieldOfAPage, EqualsTheTreeToRounding) {
  const SamplePage page = PageOf(GetParam());
  const TextureField field(page.texture);
  const double tolerance = 1e-17 + 2 * field.greatest_slope() * 8 *
                                       std::numeric_limits<double>::epsilon() *
                                       page.typeset.page.width;
  Points points(page, 11);
  int felt = 0, turned = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec2 p = points.Next();
    const Sample compiled = field.SampleAt(p), tree = SampleTree(page.texture, p);
    ASSERT_NEAR(compiled.displacement, tree.displacement, tolerance) << p.x << " " << p.y;
    felt += tree.displacement != 0 ? 1 : 0;
    // on a crease rounding may choose the other member: rare, but then by design
    turned += glm::length(compiled.gradient - tree.gradient) > 1e-9 ? 1 : 0;
  }
  EXPECT_GT(felt, 10000);
  EXPECT_LE(turned, 2);
}

// The gradient is compared with central differences. Second derivatives are at most s/r across a
// groove and, along bends, the slope over the distance to the bend's centre; blending adds s/rho.
// The step is short enough that their change within it stays below the tolerance; points where two
// members are within the step of each other lie on the crease set and are left out, as are points
// whose differences straddle one.
TEST_P(FieldOfAPage, GradientIsTheDerivativeOffTheCreases) {
  const SamplePage page = PageOf(GetParam());
  const TextureField field(page.texture);
  const TypeStyle& style = page.typeset.style;
  const double s = field.greatest_slope();
  const double bend = std::max(field.greatest_curvature(), 4 * s / style.width) +
                      (style.blend_radius > 0 ? 6 * s / style.blend_radius : 0);
  const double step = 1e-9;
  const double tolerance = 4 * step * bend + 4e-19 / step;
  Points points(page, 12);
  int compared = 0, creased = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec2 p = points.Next();
    const Sample sample = field.SampleAt(p);
    if (sample.displacement == 0) continue;
    const auto height = [&](double dx, double dy) {
      return field.SampleAt(p + glm::dvec2(dx, dy)).displacement;
    };
    const glm::dvec2 difference((height(step, 0) - height(-step, 0)) / (2 * step),
                                (height(0, step) - height(0, -step)) / (2 * step));
    // one-sided derivatives that disagree by more than bending explains: a crease within the step
    const double kink = std::abs(height(step, 0) + height(-step, 0) - 2 * height(0, 0)) +
                        std::abs(height(0, step) + height(0, -step) - 2 * height(0, 0));
    if (kink > 4 * step * step * bend + 1e-18) {
      ++creased;
      continue;
    }
    ++compared;
    ASSERT_NEAR(sample.gradient.x, difference.x, tolerance) << p.x << " " << p.y;
    ASSERT_NEAR(sample.gradient.y, difference.y, tolerance) << p.x << " " << p.y;
  }
  EXPECT_GT(compared, 8000);
  // a crease is a line: its share of points is about its length times the step over the area
  EXPECT_LE(creased, compared / 1000);
}

// Continuity across rims, spines, caps, joints, neighbours: along any straight walk the
// displacement changes by no more than the greatest slope times the step.
TEST_P(FieldOfAPage, IsContinuousEverywhere) {
  const SamplePage page = PageOf(GetParam());
  const TextureField field(page.texture);
  Points points(page, 13);
  const double s = field.greatest_slope();
  // blending may add the other member's slope, weighted, and the change of its weight
  const double limit = GetParam().relief == Relief::kEmbossed ? 2 * s : s;
  for (int walk = 0; walk < 300; ++walk) {
    const glm::dvec2 from = points.Next(), to = points.Next();
    const glm::dvec2 step = 1e-6 * glm::normalize(to - from);
    const int steps = static_cast<int>(std::min(glm::length(to - from) / 1e-6, 5000.0));
    double before = field.SampleAt(from).displacement;
    for (int i = 1; i <= steps; ++i) {
      const double now = field.SampleAt(from + static_cast<double>(i) * step).displacement;
      ASSERT_LE(std::abs(now - before), 1e-6 * limit * (1 + 1e-9) + 1e-18);
      before = now;
    }
  }
}

TEST(Field, IsZeroOutsideEveryElementAndForNonsense) {
  const SamplePage page = MakePage("moon", 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = INFINITY;
  for (const glm::dvec2 p : {glm::dvec2(0.1, 0.001), glm::dvec2(-5, 3), glm::dvec2(nan, 0.01),
                             glm::dvec2(0.01, nan), glm::dvec2(inf, -inf), glm::dvec2(1e300, 0)}) {
    EXPECT_EQ(field.SampleAt(p).displacement, 0);
    EXPECT_EQ(field.SampleAt(p).gradient, glm::dvec2(0.0, 0.0));
  }
}

TEST(Field, OfNothingIsFlat) {
  EXPECT_EQ(TextureField().SampleAt({0, 0}).displacement, 0);
  EXPECT_EQ(TextureField(Texture{}).SampleAt({0, 0}).displacement, 0);
  EXPECT_EQ(TextureField().greatest_slope(), 0);
}

/// Groups scattered without lines, overlapping, of mixed profiles, in two layers of opposite
/// relief.
Texture Scattered(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> at(0, 0.2), small(0, 0.01), turn(-6.0, 6.0);
  std::vector<std::shared_ptr<const Group>> shapes;
  for (int i = 0; i < 7; ++i) {
    Group group;
    const double w = 0.5e-3 + 0.1 * small(random);
    const Profile profile{w, 0.4 * w, 0.2 * w};
    const Profile other{1.5 * w, 0.5 * w, 0.3 * w};
    const glm::dvec2 a(small(random), small(random)), b(small(random), small(random));
    group.elements = {{Line{a, b}, profile},
                      {Arc{b, 1e-3 + small(random), turn(random), turn(random)}, profile},
                      {Dot{a}, other},
                      {Dot{b}, profile}};
    if (i % 2 == 0) group.blend_radius = 0.3 * w;
    if (i % 3 == 0) group.elements.push_back({Fill{{Arc{a, 2e-3, 0, 7.0}}}, other});
    shapes.push_back(Finish(group));
  }
  Group engraved, embossed;
  for (std::size_t i = 0; i < count; ++i) {
    Group& group = i % 4 == 0 ? embossed : engraved;
    group.placements.push_back({shapes[random() % shapes.size()], {at(random), at(random)}});
  }
  return {{{Finish(engraved), Relief::kEngraved}, {Finish(embossed), Relief::kEmbossed}}, {}};
}

TEST(Field, EqualsTheTreeForScatteredOverlappingLayers) {
  for (const std::size_t count : {1u, 2u, 5u, 60u, 400u}) {
    const Texture texture = Scattered(count, 100 + count);
    const TextureField field(texture);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> at(-0.02, 0.23);
    for (int i = 0; i < 4000; ++i) {
      const glm::dvec2 p(at(random), at(random));
      ASSERT_NEAR(field.SampleAt(p).displacement, SampleTree(texture, p).displacement, 1e-17);
    }
  }
}

TEST(Field, StoresAGlyphOfOneSizeOnce) {
  const SamplePage few = MakePage("moon moon", 0.006, Relief::kEngraved);
  std::string text;
  for (int i = 0; i < 100; ++i) text += "moon moon ";
  const SamplePage many = MakePage(text, 0.006, Relief::kEngraved);
  const std::size_t small = TextureField(few.texture).memory_bytes();
  const std::size_t large = TextureField(many.texture).memory_bytes();
  // 100 times the letters: two or three slots each and what the ends of lines leave unused, no more
  // glyphs
  const std::size_t letters = many.typeset.pages.front().glyphs.size();
  EXPECT_LT(large, small + letters * 24);
}

TEST(Field, HashTellsFieldsApart) {
  const auto hash = [](const std::string& text, double size, Relief relief) {
    return TextureField(MakePage(text, size, relief).texture).Hash();
  };
  const std::uint64_t moon = hash("moon", 0.012, Relief::kEngraved);
  EXPECT_EQ(moon, hash("moon", 0.012, Relief::kEngraved));
  EXPECT_NE(moon, hash("noon", 0.012, Relief::kEngraved));
  EXPECT_NE(moon, hash("moon", 0.013, Relief::kEngraved));
  EXPECT_NE(moon, hash("moon", 0.012, Relief::kEmbossed));
}

TEST(Field, RefusesBrokenTrees) {
  Group broken;
  broken.elements = {{Dot{{0, 0}}, {1e-3, 0.5e-3, 0.4e-3}}};
  EXPECT_THROW(TextureField({{{Finish(broken), Relief::kEngraved}}, {}}), InputError);
  Group nowhere;
  Group dot;
  dot.elements = {{Dot{{0, 0}}, {1e-3, 0.5e-3, 0.2e-3}}};
  nowhere.placements = {{Finish(dot), {std::nan(""), 0}}};
  nowhere.placements.push_back({Finish(dot), {0, 0}});
  EXPECT_THROW(TextureField({{{Finish(nowhere), Relief::kEngraved}}, {}}), InputError);
}

// Stroke of a pen that was put down and lifted: it has no direction.
TEST(Field, ALineWithoutLengthIsNowhere) {
  Group letter;
  letter.elements.push_back({Line{{0.0025, 0.002}, {0.0025, 0.002}}, Profile{1.2e-3, 4e-4, 2e-4}});
  letter.elements.push_back({Line{{0, 0}, {0, 0.004}}, Profile{1.2e-3, 4e-4, 2e-4}});
  const auto shared = Finish(std::move(letter));
  Group page;
  for (int i = 0; i < 10; ++i) page.placements.push_back({shared, {0.008 * i, 0}});
  Texture texture;
  texture.layers.push_back({Finish(std::move(page)), Relief::kEngraved});
  const TextureField field(texture);
  for (double x = 0; x < 0.08; x += 1e-4) {
    for (double y = 0; y < 0.004; y += 1e-4) {
      ASSERT_NEAR(field.SampleAt({x, y}).displacement, SampleTree(texture, {x, y}).displacement,
                  1e-15);
    }
  }
}

TEST(Field, GroupsBeyondCountingAreRefused) {
  Group dot;
  dot.elements.push_back({Dot{{0, 0}}, Profile{1.2e-3, 4e-4, 2e-4}});
  Group page;
  page.placements.push_back({Finish(std::move(dot)), {1e20, 0}});
  Texture texture;
  texture.layers.push_back({Finish(std::move(page)), Relief::kEngraved});
  EXPECT_THROW(TextureField{texture}, InputError);
}

}  // namespace
}  // namespace moontrace
