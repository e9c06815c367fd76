#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <thread>

#include "sim/bench/bench_page.h"
#include "sim/bench/row.h"
#include "sim/bench/timing.h"
#include "sim/physics/mujoco_compat.h"
#include "sim/physics/scene.h"
#include "sim/trial/trial.h"
#include "textures/field/surface.h"

namespace moontrace {

namespace {

/// Work along a closed path through `corners` by the trapezoid rule on steps of 0.1 um [J].
double WorkOfALap(const Surface& surface, const TextureField& field,
                  const std::vector<glm::dvec3>& corners) {
  double work = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 from = corners[i], side = corners[(i + 1) % corners.size()] - from;
    const int steps = 1 + static_cast<int>(glm::length(side) / 0.1e-6);
    glm::dvec3 force = Touch(surface, field, from).force_P;
    for (int k = 1; k <= steps; ++k) {
      const glm::dvec3 next =
          Touch(surface, field, from + (static_cast<double>(k) / steps) * side).force_P;
      work += glm::dot(0.5 * (force + next), side) / steps;
      force = next;
    }
  }
  return work;
}

/// The greatest energy a lap hands out, over upright rectangles that reach the cap [J].
double GreatestLap(const BenchPage& page, ForceLaw law) {
  const TextureField field(page.texture);
  const Surface surface{1000, 3, law};
  const std::vector<glm::dvec2> points = PointsInLetters(page, 100, 51);
  std::mt19937_64 random(52);
  std::uniform_real_distribution<double> turn(0, 6.283);
  double greatest = 0;
  for (const glm::dvec2 a : points) {
    const double angle = turn(random);
    const glm::dvec2 b = a + 1e-3 * glm::dvec2(std::cos(angle), std::sin(angle));
    const double work =
        WorkOfALap(surface, field, {{a, -0.8e-3}, {b, -0.8e-3}, {b, -5e-3}, {a, -5e-3}});
    greatest = std::max(greatest, std::abs(work));
  }
  return greatest;
}

/// Simulated seconds of one trial.
double TraceOnce(const BenchPage& page, const TextPage& sheet, std::uint64_t seed) {
  TrialSetup setup;
  setup.script = &page.script;
  setup.page = &sheet;
  setup.style = page.style;
  setup.hand = ShippedHand();
  setup.seed = seed;
  return RunTrial(setup).duration;
}

/// MuJoCo alone for about as long as a trial: the speed-up of cores that share caches or a host.
double StepBare() {
  Scene scene = Scene::Load("", SceneOptions{});
  for (int i = 0; i < 60000; ++i) mj_step(scene.model(), scene.data());
  return scene.data()->time;
}

/// Seconds of `work(core)` on all cores at once.
template <class Work>
double SecondsOnAll(unsigned cores, const Work& work) {
  return SecondsOf([&] {
    std::vector<std::thread> threads;
    for (unsigned k = 0; k < cores; ++k) threads.emplace_back([&work, k] { work(k); });
    for (std::thread& thread : threads) thread.join();
  });
}

void AddTracing(const BenchPage& page, BenchRows& rows) {
  TextPage sheet;  // the page's first two lines
  for (const PlacedGlyph& glyph : page.sheet.glyphs) {
    if (glyph.line < 2) sheet.glyphs.push_back(glyph);
  }
  sheet.lines = 2;
  std::vector<double> alone, together, gains;
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  for (int i = 0; i < 5; ++i) {
    double simulated = 0;
    const double one = SecondsOf([&] { simulated = TraceOnce(page, sheet, 1); });
    const double all = SecondsOnAll(cores, [&](unsigned k) { TraceOnce(page, sheet, k + 1); });
    const double bare_one = SecondsOf([] { Keep(StepBare()); });
    const double bare_all = SecondsOnAll(cores, [](unsigned) { Keep(StepBare()); });
    alone.push_back(simulated / one);
    together.push_back(simulated * cores / all);
    gains.push_back(one / all / (bare_one / bare_all));
  }
  rows.push_back(AtLeast("simulated tracing, one core", Median(alone), "times real time", 250));
  rows.push_back(Shown(fmt::format("simulated tracing, {} cores", cores), Median(together),
                       "times real time"));
  rows.push_back(AtLeast("gain from all cores, against what bare mj_step gains from them",
                         Median(gains), "times", 0.8));
}

}  // namespace

BenchRows BenchTracing() {
  BenchRows rows;
  const BenchPage page = MakeBenchPage(1, 4);
  rows.push_back(AtMost("energy of a closed way, law potential",
                        1e6 * GreatestLap(page, ForceLaw::kPotential), "uJ", 1));
  rows.push_back(
      Shown("energy of a closed way, law paper", 1e6 * GreatestLap(page, ForceLaw::kPaper), "uJ"));
  AddTracing(page, rows);
  return rows;
}

}  // namespace moontrace
