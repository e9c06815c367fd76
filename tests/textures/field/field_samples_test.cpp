// Many points at once give the very bits that each point alone gives.
#include "textures/field/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

#include "tests/textures/sample_page.h"

namespace moontrace {
namespace {

bool Same(const Sample& a, const Sample& b) {
  return a.displacement == b.displacement && a.gradient.x == b.gradient.x &&
         a.gradient.y == b.gradient.y;
}

void ExpectSame(const TextureField& field, const std::vector<glm::dvec2>& points) {
  std::vector<Sample> samples(points.size());
  field.SamplesAt(points, samples);
  // and the same in columns
  std::vector<double> x, y, height(points.size()), slope_x(points.size()), slope_y(points.size());
  for (const glm::dvec2 point : points) {
    x.push_back(point.x);
    y.push_back(point.y);
  }
  field.SamplesAt({x.data(), y.data()}, {height.data(), slope_x.data(), slope_y.data()},
                  points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Sample expected = field.SampleAt(points[i]);
    ASSERT_TRUE(Same(samples[i], expected)) << i << ": " << points[i].x << ", " << points[i].y;
    ASSERT_TRUE(Same({height[i], {slope_x[i], slope_y[i]}}, expected))
        << i << ": " << points[i].x << ", " << points[i].y;
  }
}

/// Rows of a picture over the lines of text, as pictures take them.
std::vector<glm::dvec2> Raster(double step) {
  std::vector<glm::dvec2> points;
  for (double y = 0.15; y < 0.297; y += 11.3 * step) {
    for (double x = 0; x < 0.21; x += step) points.emplace_back(x, y);
  }
  return points;
}

TEST(FieldSamples, AreThoseOfSinglePointsAlongRowsAndAnywhere) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> x(-0.01, 0.22), y(0.1, 0.31);
  for (const Relief relief : {Relief::kEngraved, Relief::kEmbossed}) {
    for (const double size : {0.006, 0.02}) {
      const SamplePage page = MakePage(kPangram, size, relief);
      const TextureField field(page.texture);
      ExpectSame(field, Raster(60e-6));
      ExpectSame(field, Raster(0.9e-3));
      std::vector<glm::dvec2> points;
      for (int i = 0; i < 20000; ++i) points.emplace_back(x(random), y(random));
      ExpectSame(field, points);
    }
  }
}

/// There and back along each line, from beyond its one end to beyond its other.
std::vector<glm::dvec2> ThereAndBack(const SamplePage& page, double step) {
  std::vector<glm::dvec2> points;
  for (const PlacedGlyph& glyph : page.typeset.pages.front().glyphs) {
    if (!points.empty() && points.back().y == glyph.origin_P.y + 0.002) continue;
    const double y = glyph.origin_P.y + 0.002;
    for (double x = -0.05; x < 0.3; x += step) points.emplace_back(x, y);
    for (double x = 0.3; x > -0.05; x -= step) points.emplace_back(x, y);
  }
  return points;
}

TEST(FieldSamples, AreThoseOfSinglePointsThereAndBackAlongLines) {
  for (const double size : {0.006, 0.02}) {
    const SamplePage page = MakePage(kPangram, size, Relief::kEngraved);
    ExpectSame(TextureField(page.texture), ThereAndBack(page, 70e-6));
  }
}

TEST(FieldSamples, AreThoseOfSinglePointsOnRoughPaper) {
  SamplePage page = MakePage("rough", 0.012, Relief::kEngraved);
  page.typeset.style.texture.paper = PaperTexture{};
  page.texture = BuildTexture(page.typeset.pages.front(), page.script, page.typeset.style);
  const TextureField field(page.texture);
  ExpectSame(field, Raster(0.1e-3));
}

TEST(FieldSamples, BrokenPointsGiveNothingAndSpoilNoNeighbour) {
  const SamplePage page = MakePage("moon", 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  const glm::dvec2 good = page.typeset.pages.front().glyphs.front().origin_P;
  ExpectSame(field, {good,
                     {NAN, good.y},
                     good,
                     {good.x, NAN},
                     {INFINITY, good.y},
                     {-1e300, good.y},
                     good,
                     {good.x, -INFINITY},
                     good});
  ExpectSame(field, {});
  ExpectSame(TextureField(), {good, good});
}

}  // namespace
}  // namespace moontrace
