// Fields that we did not draw: strokes by the dozen within one groove's width, and every script
// that is on the machine, shipped, sample or Debian's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "textures/base/utf8.h"
#include "textures/field/field.h"
#include "textures/fonts/script_library.h"
#include "textures/relief/glyph_group.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr double kStep = 1e-6;  // [m]
/// Of the steepest flank, how steep the surface is at most where a crease is rounded: both strokes'
/// slopes, weighted, are no steeper than one; the change of the weights adds the rest. Its bound is
/// 1.75: the fillet is rho / 4 high, and both weights change by 1.5 / rho at most.
constexpr double kRounded = 1.75;

/// Along straight walks between points that `next` gives.
template <typename Next>
void ExpectContinuous(const TextureField& field, Relief relief, int walks, Next next) {
  const double limit =
      field.greatest_slope() * (relief == Relief::kEmbossed ? kRounded : 1) * kStep;
  for (int walk = 0; walk < walks; ++walk) {
    const glm::dvec2 from = next(), to = next();
    const glm::dvec2 step = kStep * glm::normalize(to - from);
    const int steps = static_cast<int>(std::min(glm::length(to - from) / kStep, 3000.0));
    double before = field.SampleAt(from).displacement;
    for (int i = 1; i <= steps; ++i) {
      const glm::dvec2 p = from + static_cast<double>(i) * step;
      const double now = field.SampleAt(p).displacement;
      ASSERT_LE(std::abs(now - before), limit * (1 + 1e-9) + 1e-18) << p.x << " " << p.y;
      before = now;
    }
  }
}

/// Equal to rounding: places agree to 8 units in the last place of `extent` [m].
template <typename Next>
void ExpectEqualToTheTree(const TextureField& field, const Texture& texture, double extent,
                          int points, Next next) {
  const double tolerance =
      1e-17 + 2 * field.greatest_slope() * 8 * std::numeric_limits<double>::epsilon() * extent;
  for (int i = 0; i < points; ++i) {
    const glm::dvec2 p = next();
    ASSERT_NEAR(field.SampleAt(p).displacement, SampleTree(texture, p).displacement, tolerance)
        << p.x << " " << p.y;
  }
}

/// A hundred lines and arcs with round ends that cross within a groove's width of one point.
Texture Crowd(double blend_radius) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> turn(0, 6.283), off(-4e-4, 4e-4);
  const Profile profile{1e-3, 0.5e-3, 0.2e-3};
  Group group;
  group.blend_radius = blend_radius;
  for (int i = 0; i < 100; ++i) {
    const double angle = turn(random);
    const glm::dvec2 along(std::cos(angle), std::sin(angle)), middle(off(random), off(random));
    const auto add = [&](const auto& stroke, glm::dvec2 from, glm::dvec2 to) {
      for (const Shape& shape : {Shape(stroke), Shape(Dot{from}), Shape(Dot{to})}) {
        group.elements.push_back({shape, profile});
      }
    };
    if (i % 3 == 0) {
      const double radius = 2e-3;
      const glm::dvec2 center = middle - radius * along;
      const auto on = [&](double a) { return center + radius * glm::dvec2(cos(a), sin(a)); };
      add(Arc{center, radius, angle - 1, 2.0}, on(angle - 1), on(angle + 1));
    } else {
      const glm::dvec2 from = middle - 3e-3 * along, to = middle + 3e-3 * along;
      add(Line{from, to}, from, to);
    }
  }
  return {{{Finish(group), Relief::kEmbossed}}, {}};
}

TEST(CrowdedField, EqualsTheTreeAndIsContinuous) {
  for (const double blend_radius : {0.0, 0.2e-3, 0.6e-3}) {
    const Texture texture = Crowd(blend_radius);
    const TextureField field(texture);
    std::mt19937_64 random(29);
    std::uniform_real_distribution<double> at(-4e-3, 4e-3);
    const auto next = [&] { return glm::dvec2(at(random), at(random)); };
    ExpectEqualToTheTree(field, texture, 8e-3, 300, next);
    ExpectContinuous(field, Relief::kEmbossed, 4, next);
  }
}

// Where a dozen strokes run side by side, rounding their creases lifts none of them by more than
// one fillet: what is flat beside a lone pair stays flat beside a crowd.
TEST(CrowdedField, SwellsByOneFilletAtMost) {
  constexpr double kRho = 0.4e-3, kHalf = 0.5e-3;
  Group group;
  group.blend_radius = kRho;
  for (int i = 0; i < 40; ++i) {
    group.elements.push_back(
        {Line{{-0.01, 1e-6 * i}, {0.01, 1e-6 * i}}, {2 * kHalf, 0.5e-3, 0.2e-3}});
  }
  const TextureField field({{{Finish(group), Relief::kEmbossed}}, {}});
  EXPECT_GT(field.SampleAt({0, kHalf}).displacement, 0);
  EXPECT_EQ(field.SampleAt({0, 39e-6 + kHalf + kRho / 4 + 1e-9}).displacement, 0);
}

/// The first signs of a script, as text: letters and digits before others.
std::string SomeText(const Script& script) {
  std::vector<char32_t> characters;
  for (const auto& sign : script.signs) characters.push_back(sign.first);
  std::stable_partition(characters.begin(), characters.end(), [](char32_t c) {
    return c > 127 || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(characters.size(), 72); ++i) {
    text += ToUtf8(characters[i]);
    if (i % 8 == 7) text += ' ';
  }
  return text;
}

class SlowFieldOfEveryScript : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Sizes, SlowFieldOfEveryScript, ::testing::Values(0.005, 0.012, 0.020),
                         [](const auto& size) {
                           return "Of" + std::to_string(std::lround(1e3 * size.param)) + "mm";
                         });

TEST_P(SlowFieldOfEveryScript, EqualsTheTreeAndIsContinuous) {
  int tried = 0;
  for (const ScriptEntry& entry : ListScripts()) {
    const Script script = FindScript(entry.name);
    for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
      SCOPED_TRACE(entry.name + (relief == Relief::kEmbossed ? ", embossed" : ", engraved"));
      const TypeStyle style = DefaultStyle(GetParam(), relief, script);
      const std::string text = script.braille_tables.empty() ? SomeText(script) : "some braille";
      const Typeset set = SetText(text, script, style, FindPage("a4"));
      const Texture texture = BuildTexture(set.pages.front(), script, style);
      const TextureField field(texture);
      std::mt19937_64 random(31);
      const auto& glyphs = set.pages.front().glyphs;
      std::uniform_real_distribution<double> around(-0.25, 1.25);
      const auto next = [&] {
        const glm::dvec2 origin = glyphs[random() % glyphs.size()].origin_P;
        return origin + style.size * glm::dvec2(around(random), around(random));
      };
      ExpectEqualToTheTree(field, texture, set.page.width, 1000, next);
      ExpectContinuous(field, relief, 40, next);
      ++tried;
    }
  }
  EXPECT_GE(tried, 10);  // the shipped scripts alone
}

}  // namespace
}  // namespace moontrace
