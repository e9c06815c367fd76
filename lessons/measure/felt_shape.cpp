#include "lessons/measure/felt_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace moontrace {
namespace {

constexpr int kRows = 40;  // of the map, over the height felt over
constexpr int kMostColumns = 800;
constexpr double kPictureReach = 2.2;  // from its middle, in spreads
constexpr double kFlatShare = 0.6;     // of the samples in contact lie deeper than the flat paper
constexpr double kDeepShare = 0.002;   // of them lie deeper than what counts as the deepest
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

double Quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// The samples in contact, each lifted by how far its force presses plain paper in.
std::vector<FeltSample> InContact(const std::vector<FeltSample>& samples, double softness) {
  std::vector<FeltSample> touching;
  for (const FeltSample& sample : samples) {
    const bool finite = std::isfinite(glm::dot(sample.tip, sample.tip)) &&
                        std::isfinite(glm::dot(sample.force, sample.force));
    if (!finite || !(sample.force.z > 0)) continue;
    touching.push_back({sample.tip + softness * sample.force, sample.force});
  }
  return touching;
}

Map EmptyMap(const std::vector<FeltSample>& touching) {
  glm::dvec2 min(1e300), max(-1e300);
  for (const FeltSample& sample : touching) {
    min = glm::min(min, glm::dvec2(sample.tip));
    max = glm::max(max, glm::dvec2(sample.tip));
  }
  Map map;
  map.min = min;
  map.cell = (max.y - min.y) / kRows;
  if (!(map.cell > 0)) return map;
  const double columns = std::min<double>(std::ceil((max.x - min.x) / map.cell), kMostColumns);
  map.columns = std::max(1, static_cast<int>(columns));
  map.groove.assign(static_cast<std::size_t>(map.columns) * kRows, 0.0);
  return map;
}

/// How surely the paper gave way there, 0-1: by the depth, or by a push to the side.
double Yielding(const FeltSample& sample, double flat, double threshold, const FeelingRule& rule) {
  const double sideways = glm::length(glm::dvec2(sample.force));
  const double slope = sideways / std::max(sample.force.z, rule.least_force);
  const double depth = flat - sample.tip.z;
  return std::clamp(std::max(depth / threshold, slope / rule.slope) - 0.5, 0.0, 0.5) / 0.5;
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
Map GrooveMap(const std::vector<FeltSample>& touching, double flat, double threshold,
              const FeelingRule& rule) {
  Map map = EmptyMap(touching);
  if (map.columns == 0) return map;
  std::vector<double> path(map.groove.size(), 0.0);
  for (std::size_t i = 1; i < touching.size(); ++i) {
    const glm::dvec2 p(touching[i].tip), before(touching[i - 1].tip);
    const double step = glm::distance(p, before);
    if (step > kLongestStep * kRows * map.cell) continue;
    const glm::dvec2 at = (p - map.min) / map.cell;
    const int column = std::clamp(static_cast<int>(at.x), 0, map.columns - 1);
    const int row = std::clamp(static_cast<int>(at.y), 0, kRows - 1);
    const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                      static_cast<std::size_t>(column);
    path[cell] += step;
    map.groove[cell] += step * Yielding(touching[i], flat, threshold, rule);
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

FeltShape ShapeOf(const std::vector<FeltSample>& samples, const FeelingRule& rule) {
  const std::vector<FeltSample> touching = InContact(samples, rule.softness);
  if (touching.size() < 2) return {};
  std::vector<double> heights;
  heights.reserve(touching.size());
  for (const FeltSample& sample : touching) heights.push_back(sample.tip.z);
  const double flat = Quantile(heights, kFlatShare);
  const double deepest = flat - Quantile(heights, kDeepShare);
  if (!(deepest > rule.least_depth)) return {};
  const Map map = GrooveMap(touching, flat, rule.depth_share * deepest, rule);
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
