#include "lessons/measure/felt_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace moontrace {
namespace {

constexpr int kRows = 40;  // of the map, over the line's height
constexpr int kMostColumns = 800;
constexpr double kPictureReach = 2.2;  // from its middle, in spreads
constexpr double kDeepShare = 5e-4;    // of the samples are in a groove where there is one
constexpr double kLeastColumn = 0.5;   // rows of groove in a column that is not a gap
constexpr double kReach = 1.2;         // of a touch to either side of the path, in cells
constexpr double kLeastPath = 0.4;     // through a cell, in cells: less shows nothing of it
constexpr double kLongestStep = 0.1;   // of the height: no path between what is farther [share]

/// How much of the path through a cell of the page lay in a groove.
struct Map {
  int columns = 0;
  double cell = 0;  ///< [m]
  glm::dvec2 min{0, 0};
  std::vector<double> groove;
  double At(int column, int row) const {
    return groove[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
};

/// Those that are numbers and lie on the line.
std::vector<FeltSample> OnLine(const FeltLine& line) {
  std::vector<FeltSample> on_line;
  for (const FeltSample& sample : line.samples) {
    if (!std::isfinite(sample.place.x) || !std::isfinite(sample.depth)) continue;
    if (sample.place.y >= line.bottom && sample.place.y <= line.top) on_line.push_back(sample);
  }
  return on_line;
}

Map EmptyMap(const std::vector<FeltSample>& samples, double bottom, double top) {
  Map map;
  map.cell = (top - bottom) / kRows;
  if (samples.empty() || !(map.cell > 0)) return map;
  const auto [left, right] = std::minmax_element(
      samples.begin(), samples.end(),
      [](const FeltSample& a, const FeltSample& b) { return a.place.x < b.place.x; });
  map.min = {left->place.x, bottom};
  const double columns = std::ceil((right->place.x - left->place.x) / map.cell);
  map.columns = std::max(1, static_cast<int>(std::min<double>(columns, kMostColumns)));
  map.groove.assign(static_cast<std::size_t>(map.columns) * kRows, 0.0);
  return map;
}

/// How surely the paper gave way there, 0-1.
double Yielding(const FeltSample& sample, const FeelingRule& rule) {
  return std::clamp(sample.depth / rule.depth - 0.5, 0.0, 0.5) / 0.5;
}

/// Each value also counts for its neighbours, less with their distance: a Gaussian of `cells`.
template <typename Values>
void Spread(Values& values, int columns, int rows, double cells) {
  if (!(cells > 0)) return;
  const int reach = static_cast<int>(std::ceil(2.5 * cells));
  std::vector<double> weights;
  for (int d = -reach; d <= reach; ++d) weights.push_back(std::exp(-d * d / (2 * cells * cells)));
  for (const int along : {1, columns}) {
    const Values before = values;
    for (int i = 0; i < columns * rows; ++i) {
      const int at = along == 1 ? i % columns : i / columns;
      const int last = along == 1 ? columns : rows;
      double sum = 0;
      for (int d = std::max(-reach, -at); d <= std::min(reach, last - 1 - at); ++d) {
        const int weight = d + reach, from = i + d * along;
        sum += weights[static_cast<std::size_t>(weight)] * before[static_cast<std::size_t>(from)];
      }
      values[static_cast<std::size_t>(i)] = sum;
    }
  }
}

/// Weighs each sample by the length of the tip's path there, so that resting weighs nothing.
Map GrooveMap(const std::vector<FeltSample>& samples, Map map, const FeelingRule& rule) {
  if (map.columns == 0) return map;
  std::vector<double> path(map.groove.size(), 0.0);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const glm::dvec2 p = samples[i].place, before = samples[i - 1].place;
    const double step = glm::distance(p, before);
    if (step > kLongestStep * kRows * map.cell) continue;
    const glm::dvec2 at = (p - map.min) / map.cell;
    const int column = std::clamp(static_cast<int>(at.x), 0, map.columns - 1);
    const int row = std::clamp(static_cast<int>(at.y), 0, kRows - 1);
    const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                      static_cast<std::size_t>(column);
    path[cell] += step;
    map.groove[cell] += step * Yielding(samples[i], rule);
  }
  Spread(path, map.columns, kRows, kReach);
  Spread(map.groove, map.columns, kRows, kReach);
  for (std::size_t i = 0; i < path.size(); ++i) map.groove[i] /= path[i] + kLeastPath * map.cell;
  return map;
}

/// Runs of columns with something in them, joined over gaps that are too narrow to part signs.
std::vector<std::pair<int, int>> Parts(const Map& map, double gap) {
  std::vector<std::pair<int, int>> parts;
  for (int column = 0; column < map.columns; ++column) {
    double sum = 0;
    for (int row = 0; row < kRows; ++row) sum += map.At(column, row);
    if (sum < kLeastColumn) continue;
    if (!parts.empty() && column - parts.back().second <= gap * kRows) {
      parts.back().second = column;
    } else {
      parts.emplace_back(column, column);
    }
  }
  return parts;
}

FeltSign SignOf(const Map& map, std::pair<int, int> part, const FeelingRule& rule, double& mass) {
  mass = 0;
  glm::dvec2 sum(0), squares(0);
  const auto each = [&](const auto& use) {
    for (int row = 0; row < kRows; ++row) {
      for (int column = part.first; column <= part.second; ++column) {
        if (map.At(column, row) > 0) use(glm::dvec2(column + 0.5, row + 0.5), map.At(column, row));
      }
    }
  };
  each([&](glm::dvec2 p, double weight) {
    mass += weight;
    sum += weight * p;
    squares += weight * p * p;
  });
  const glm::dvec2 middle = sum / mass;
  const double variance = (squares.x + squares.y) / mass - glm::dot(middle, middle);
  const double spread = std::sqrt(std::max(0.0, variance));
  const double scale = std::max(spread, rule.least_spread * kRows);

  constexpr int n = FeltSign::kCells;
  std::array<double, FeltSign::kCells * FeltSign::kCells> picture{};
  each([&](glm::dvec2 p, double weight) {
    // Shared among the four nearest cells.
    const glm::dvec2 at = (p - middle) / scale / kPictureReach * (n / 2.0) + (n / 2.0 - 0.5);
    const glm::dvec2 low = glm::floor(at);
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
      const glm::dvec2 q = low + corner;
      if (q.x < 0 || q.y < 0 || q.x >= n || q.y >= n) continue;
      const glm::dvec2 near = 1.0 - glm::abs(at - q);
      picture[static_cast<std::size_t>(q.y) * n + static_cast<std::size_t>(q.x)] +=
          weight * near.x * near.y;
    }
  });
  Spread(picture, n, n, rule.blur_cells);
  double length = 0;
  for (const double value : picture) length += value * value;
  length = std::sqrt(std::max(length, 1e-300));
  FeltSign sign;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    sign.picture[i] = static_cast<float>(picture[i] / length);
  }
  sign.height = middle.y / kRows;
  sign.spread = spread / kRows;
  sign.width = (part.second - part.first + 1.0) / kRows;
  return sign;
}

}  // namespace

FeltShape ShapeOf(const FeltLine& line, const FeelingRule& rule) {
  const std::vector<FeltSample> samples = OnLine(line);
  const auto deep = std::count_if(samples.begin(), samples.end(),
                                  [&rule](const FeltSample& s) { return s.depth > rule.depth; });
  if (static_cast<double>(deep) <= kDeepShare * static_cast<double>(samples.size())) return {};
  const Map map = GrooveMap(samples, EmptyMap(samples, line.bottom, line.top), rule);
  FeltShape shape;
  if (map.columns == 0) return shape;
  double greatest = 0;
  std::vector<double> masses;
  for (const auto& part : Parts(map, rule.gap)) {
    double mass = 0;
    shape.push_back(SignOf(map, part, rule, mass));
    masses.push_back(mass);
    greatest = std::max(greatest, mass);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (masses[i] >= rule.least_part * greatest) shape[kept++] = shape[i];
  }
  shape.resize(kept);
  return shape;
}

}  // namespace moontrace
