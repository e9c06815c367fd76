#include "sim/reader/step_gains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "textures/base/random.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

std::vector<glm::dvec2> Scattered(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<glm::dvec2> points;
  while (points.size() < count) {
    const double x = 5 * random.Uniform() - 1, y = 2 * random.Uniform() - 0.7;
    points.emplace_back(x, y);
  }
  return points;
}

/// Point by point and step by step, as it is defined.
double Slowly(const SignShapes& shapes, std::size_t sign, const std::vector<glm::dvec2>& ink,
              const std::vector<glm::dvec2>& flat, const SteppedLine& line, double x) {
  const auto in_share = [&](glm::dvec2 p) {
    const double from = x + line.window;
    return p.x >= from && p.x < from + shapes.Advance(sign);
  };
  double gain = 0;
  for (const glm::dvec2 p : ink) {
    if (!in_share(p)) continue;
    const double d = std::max(0.0, shapes.Distance(sign, p - glm::dvec2(x, 0))) / line.spread;
    gain += std::max(0.0, line.worth - 0.5 * d * d);
  }
  for (const glm::dvec2 p : flat) {
    if (!in_share(p)) continue;
    const double d = std::max(0.0, shapes.Distance(sign, p - glm::dvec2(x, 0)));
    if (d < line.inner) gain -= line.cost * std::min(1.0, 2 * (1 - d / line.inner));
  }
  return line.weight * gain;
}

// Sums of some hundred numbers up to 5 in floats: 24 bits. A point within rounding of a cell's edge
// may fall into the next one; with these seeds none does.
TEST(StepGains, AreWhatEachPointSaysAtEachStep) {
  for (const char* name : {"moon", "braille"}) {
    const Script script = FindScript(name);
    const SignShapes shapes(script, WrittenGlyphs(script), SignShapes::Dots::kMiddles);
    SteppedLine line;
    line.from = -1.05;
    line.window = -0.1;
    line.weight = 0.6;
    line.worth = 5;
    line.spread = 0.08;
    line.cost = 4;
    line.inner = 0.05;
    const auto ink = Scattered(3, 150), flat = Scattered(4, 400);
    for (const int cells : {2, 4}) {
      const StepGains gains(shapes, cells);
      EXPECT_NEAR(gains.step(), cells * 0.02, 1e-12);
      line.steps = static_cast<int>(5 / gains.step());
      const auto all = gains.Of(ink, flat, line);
      ASSERT_EQ(all.size(), shapes.size());
      for (std::size_t sign = 0; sign < all.size(); ++sign) {
        ASSERT_EQ(all[sign].size(), static_cast<std::size_t>(line.steps) + 1);
        for (int k = 0; k <= line.steps; ++k) {
          const double slowly = Slowly(shapes, sign, ink, flat, line, line.from + k * gains.step());
          ASSERT_NEAR(all[sign][static_cast<std::size_t>(k)], slowly, 1e-3)
              << name << " sign " << sign << " step " << k;
        }
      }
    }
  }
}

TEST(StepGains, AreNoneWithoutPoints) {
  const Script script = FindScript("moon");
  const SignShapes shapes(script, WrittenGlyphs(script), SignShapes::Dots::kMiddles);
  SteppedLine line;
  line.steps = 7;
  for (const auto& of_sign : StepGains(shapes, 2).Of({}, {}, line)) {
    EXPECT_EQ(of_sign, std::vector<double>(8, 0.0));
  }
}

}  // namespace
}  // namespace moontrace
