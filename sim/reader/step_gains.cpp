#include "sim/reader/step_gains.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "textures/base/wide_vectors.h"

namespace moontrace {

StepGains::StepGains(const SignShapes& shapes, int cells) : cells_(cells) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const SignShapes::Table& table = shapes.TableOf(i);
    Sign sign;
    sign.corner = table.corner;
    sign.columns = table.columns;
    sign.rows = table.rows;
    sign.advance = shapes.Advance(i);
    sign.run = (table.columns + cells - 1) / cells;
    const auto of_row = static_cast<std::size_t>(cells) * static_cast<std::size_t>(sign.run);
    sign.table.assign(static_cast<std::size_t>(sign.rows) * of_row,
                      static_cast<float>(SignShapes::kFarthest));
    for (int row = 0; row < sign.rows; ++row) {
      for (int column = 0; column < sign.columns; ++column) {
        const auto to =
            static_cast<std::size_t>(row) * of_row +
            static_cast<std::size_t>(column % cells) * static_cast<std::size_t>(sign.run) +
            static_cast<std::size_t>(column / cells);
        // within a fill all counts as its line
        sign.table[to] = std::max(0.0F, table.At(column, row));
      }
    }
    signs_.push_back(std::move(sign));
  }
}

std::vector<StepGains::Point> StepGains::Points(const std::vector<glm::dvec2>& points,
                                                const SteppedLine& line) const {
  std::vector<Point> found;
  found.reserve(points.size());
  for (const glm::dvec2 p : points) {
    const double x = p.x - line.from;
    found.push_back({x * SignShapes::kPerEm, p.y * SignShapes::kPerEm, (x - line.window) / step()});
  }
  return found;
}

namespace {

/// Rounded down; quicker than std::floor, for what is far from the limits of an int.
int Floor(double x) {
  constexpr int kFar = 1 << 20;
  return static_cast<int>(x + kFar) - kFar;
}

}  // namespace

void StepGains::FindRuns(const Sign& sign, const std::vector<Point>& points, int steps,
                         std::vector<Run>& runs) const {
  const double left = sign.corner.x * SignShapes::kPerEm, low = sign.corner.y * SignShapes::kPerEm;
  const double width = sign.advance / step();
  const std::ptrdiff_t of_row = static_cast<std::ptrdiff_t>(cells_) * sign.run;
  runs.clear();
  for (const Point& point : points) {
    const int row = Floor(point.row - low), column = Floor(point.column - left);
    if (row < 0 || row >= sign.rows || column < 0) continue;
    // of a sign that begins a step further right the point lies a step further left
    const int most = column / cells_;
    const int last = std::min({steps, most, Floor(point.steps)});
    const int first = std::max({0, most - sign.run + 1, Floor(point.steps - width) + 1});
    if (first > last) continue;
    const float* const cells =
        sign.table.data() + row * of_row + static_cast<std::ptrdiff_t>(column % cells_) * sign.run;
    runs.push_back({cells + (most - last), steps - last, last - first + 1});
  }
}

MOONTRACE_WIDE void StepGains::AddInk(const std::vector<Run>& runs, float worth, float fall,
                                      float* gains) {
  for (const Run& run : runs) {
    float* const to = gains + run.to;
    for (std::ptrdiff_t i = 0; i < run.count; ++i) to[i] += InkWorth(run.cells[i], worth, fall);
  }
}

MOONTRACE_WIDE void StepGains::AddFlat(const std::vector<Run>& runs, float cost, float fall,
                                       float* gains) {
  for (const Run& run : runs) {
    float* const to = gains + run.to;
    for (std::ptrdiff_t i = 0; i < run.count; ++i) to[i] -= cost * FlatShare(run.cells[i], fall);
  }
}

std::vector<std::vector<double>> StepGains::Of(const std::vector<glm::dvec2>& ink,
                                               const std::vector<glm::dvec2>& flat,
                                               const SteppedLine& line) const {
  const std::vector<Point> inks = Points(ink, line), flats = Points(flat, line);
  const auto worth = static_cast<float>(line.worth), cost = static_cast<float>(line.cost);
  const auto ink_fall = static_cast<float>(0.5 / (line.spread * line.spread));
  const auto flat_fall = static_cast<float>(2 / line.inner);
  std::vector<std::vector<double>> all;
  std::vector<float> gains;  // from the last step to the first, as the cells lie
  std::vector<Run> runs;
  for (const Sign& sign : signs_) {
    gains.assign(static_cast<std::size_t>(line.steps) + 1, 0.0F);
    FindRuns(sign, inks, line.steps, runs);
    AddInk(runs, worth, ink_fall, gains.data());
    FindRuns(sign, flats, line.steps, runs);
    AddFlat(runs, cost, flat_fall, gains.data());
    all.emplace_back(gains.rbegin(), gains.rend());
    for (double& gain : all.back()) gain *= line.weight;
  }
  return all;
}

}  // namespace moontrace
