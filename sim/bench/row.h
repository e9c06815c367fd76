#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace moontrace {

/// One measurement of `moontrace bench`. Ratios are of two things measured by turns in one run.
struct BenchRow {
  std::string name;
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
  std::string bar;            ///< what it must reach, in words; empty: shown for comparison only
  std::optional<bool> holds;  ///< whether it does
};

inline BenchRow Shown(std::string name, double value, std::string unit) {
  return {std::move(name), value, std::move(unit), "", std::nullopt};
}
/// A row that must not exceed `most`.
BenchRow AtMost(std::string name, double value, std::string unit, double most);
/// A row that must reach `least`.
BenchRow AtLeast(std::string name, double value, std::string unit, double least);

using BenchRows = std::vector<BenchRow>;

/// Query of displacement and gradient against a sampled grid of the same page, accuracy, growth,
/// building.
BenchRows BenchField();
/// How warm motors become under a hand that rests on a page, level and tilted by 20 degrees.
BenchRows BenchHeat();
/// A tick among ten labelled objects, and MuJoCo's contact with one of them as a mesh.
BenchRows BenchLabels();
/// Sampling by the C interface (sim/library) against the call of C++ on arrays.
BenchRows BenchLibrary();
/// Reaction forces as the paper measured them: each letter, and a page of 64 x 30 letters.
BenchRows BenchPaper();
/// mj_step with and without the field, MuJoCo's own height field of the page, the whole tick.
BenchRows BenchPhysics();
/// Stiffness that a sampled device holds, found by simulation, beside the closed-form limits:
/// stiffness by damping by rate, then every shipped profile that pushes, with the energy it puts
/// out.
BenchRows BenchStability();
/// Energy of closed paths, simulated tracing against the clock, on one core and on all.
BenchRows BenchTracing();

}  // namespace moontrace
