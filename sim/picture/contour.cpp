#include "sim/picture/contour.h"

#include <algorithm>
#include <array>
#include <utility>

namespace moontrace {

namespace {

constexpr std::size_t kNone = ~std::size_t{0};

/// Where a side of a cell crosses zero, and the crossing that follows along the outline.
struct Crossing {
  glm::dvec2 at{0, 0};
  std::size_t next = kNone;
};

/// The grid with a frame of cells without width and below zero, so that all outlines close.
class Tracer {
 public:
  explicit Tracer(const HeightGrid& grid)
      : grid_(grid),
        columns_(grid.columns + 2),
        rows_(grid.rows + 2),
        crossing_of_(2 * (columns_ + 1) * (rows_ + 1), kNone) {
    for (std::size_t j = 0; j < rows_; ++j) {
      for (std::size_t i = 0; i < columns_; ++i) LinkCell(i, j);
    }
  }

  std::vector<std::vector<glm::dvec2>> Take() {
    std::vector<std::vector<glm::dvec2>> outlines;
    for (Crossing& first : crossings_) {
      if (first.next == kNone) continue;
      std::vector<glm::dvec2>& outline = outlines.emplace_back();
      for (Crossing* at = &first; at->next != kNone;) {
        outline.push_back(at->at);
        at = &crossings_[std::exchange(at->next, kNone)];
      }
    }
    return outlines;
  }

 private:
  glm::dvec2 At(std::size_t i, std::size_t j) const {
    const glm::dvec2 cell(std::clamp(i, std::size_t{1}, columns_ - 1) - 1,
                          std::clamp(j, std::size_t{1}, rows_ - 1) - 1);
    return grid_.box.min +
           cell / glm::dvec2(grid_.columns, grid_.rows) * (grid_.box.max - grid_.box.min);
  }

  double Height(std::size_t i, std::size_t j) const {
    if (i == 0 || j == 0 || i == columns_ || j == rows_) return -1;
    return grid_.heights[(j - 1) * (grid_.columns + 1) + i - 1];
  }

  /// Links the crossing where a walk round the cell leaves the high ground with the one where it
  /// comes back.
  void LinkCell(std::size_t i, std::size_t j) {
    const std::array<std::pair<std::size_t, std::size_t>, 4> corners{
        {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
    std::array<double, 4> heights{};
    for (std::size_t k = 0; k < 4; ++k) heights[k] = Height(corners[k].first, corners[k].second);
    // below, right, above, left
    const std::array<std::size_t, 4> sides{SideOf(i, j, 0), SideOf(i + 1, j, 1),
                                           SideOf(i, j + 1, 0), SideOf(i, j, 1)};
    const auto is_high = [&](std::size_t k) { return heights[k % 4] > 0; };
    const auto cross = [&](std::size_t k) {
      const auto [a_i, a_j] = corners[k % 4];
      const auto [b_i, b_j] = corners[(k + 1) % 4];
      const glm::dvec2 a = At(a_i, a_j), b = At(b_i, b_j);
      const double share = heights[k % 4] / (heights[k % 4] - heights[(k + 1) % 4]);
      return CrossingOn(sides[k % 4], a + share * (b - a));
    };
    for (std::size_t k = 0; k < 4; ++k) {
      if (!is_high(k) || is_high(k + 1)) continue;
      std::size_t back = k + 1;
      while (!is_high(back + 1)) ++back;
      const std::size_t from = cross(k), to = cross(back);
      crossings_[from].next = to;
    }
  }

  /// Number of the side that starts at a corner, along x (0) or y (1).
  std::size_t SideOf(std::size_t i, std::size_t j, std::size_t axis) const {
    return 2 * (j * (columns_ + 1) + i) + axis;
  }

  std::size_t CrossingOn(std::size_t side, glm::dvec2 at) {
    std::size_t& crossing = crossing_of_[side];
    if (crossing == kNone) {
      crossing = crossings_.size();
      crossings_.push_back({at, kNone});
    }
    return crossing;
  }

  const HeightGrid& grid_;
  std::size_t columns_, rows_;  ///< with the frame
  std::vector<std::size_t> crossing_of_;
  std::vector<Crossing> crossings_;
};

}  // namespace

std::vector<std::vector<glm::dvec2>> OutlinesAboveZero(const HeightGrid& grid) {
  return Tracer(grid).Take();
}

}  // namespace moontrace
