// The paper's two measurements (its section 5) in its form: reaction forces of single characters,
// each averaged over 10^4 positions (then 0.14 to 38 us), and forces a second on a page of 64 x 30
// characters (then 1.5e4).
#include <fmt/core.h>

#include <algorithm>
#include <random>

#include "sim/bench/bench_page.h"
#include "sim/bench/row.h"
#include "sim/bench/timing.h"
#include "textures/field/surface.h"
#include "textures/relief/glyph_group.h"

namespace moontrace {

namespace {

double ForcesAt(const Surface& surface, const TextureField& field,
                const std::vector<glm::dvec2>& points) {
  double sum = 0;
  for (const glm::dvec2 p : points) {
    const glm::dvec3 force = Touch(surface, field, {p, -1e-3}).force_P;
    sum += force.x + force.y + force.z;
  }
  return sum;
}

/// Microseconds a force of one letter standing alone.
double OfLetter(const BenchPage& page, const Glyph& glyph) {
  constexpr std::size_t kPositions = 10000;
  Texture texture;
  texture.layers.push_back({Finish(BuildGlyph(glyph, page.style)), page.style.relief});
  const TextureField field(texture);
  const Box box = texture.layers.front().group->bounds;
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<glm::dvec2> points(kPositions);
  for (glm::dvec2& p : points) {
    p = box.min + glm::dvec2(share(random), share(random)) * (box.max - box.min);
  }
  const Surface surface;
  const double time = MedianSecondsOf(9, [&] { Keep(ForcesAt(surface, field, points)); });
  return 1e6 * time / static_cast<double>(kPositions);
}

}  // namespace

BenchRows BenchPaper() {
  BenchRows rows;
  const BenchPage page = MakeBenchPage(1, 4);
  double quickest = 1e9, slowest = 0;
  for (char letter = 'a'; letter <= 'z'; ++letter) {
    const std::size_t glyph = page.script.Find(std::string(1, letter));
    const double us = OfLetter(page, page.script.glyphs.at(glyph));
    quickest = std::min(quickest, us);
    slowest = std::max(slowest, us);
    rows.push_back(Shown(fmt::format("force, letter {}", letter), us, "us"));
  }
  rows.push_back(Shown("force, quickest letter (the paper, 1998: 0.14)", quickest, "us"));
  rows.push_back(Shown("force, slowest letter (the paper, 1998: 38)", slowest, "us"));

  const TextureField field(page.texture);
  const Surface surface;
  const std::vector<glm::dvec2> points = PointsInLetters(page, 100000, 21);
  const double time = MedianSecondsOf(41, [&] { Keep(ForcesAt(surface, field, points)); });
  rows.push_back(AtLeast("forces a second, page of 64 x 30 (the paper, 1998: 15000)",
                         static_cast<double>(points.size()) / time, "1/s", 15e6));
  return rows;
}

}  // namespace moontrace
