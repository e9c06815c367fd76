#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace moontrace {

/// Height and its derivatives by the coordinates, which count samples.
struct HeightSample {
  double height = 0;
  glm::dvec2 gradient{0.0, 0.0};
};

/// An array of heights, C1 between its samples: bicubic, with the slopes of Catmull and Rom (1974)
/// at the samples. For rough textures from outside, never for text, which is analytic.
class SampledHeights {
 public:
  /// `heights` row by row from the lowest, each left to right, without unit, -1..1. Throws
  /// InputError unless there are 2 x 2 to 4096 x 4096 finite samples within -1..1.
  SampledHeights(std::size_t columns, std::size_t rows, std::vector<float> heights);

  std::size_t columns() const noexcept { return columns_; }
  std::size_t rows() const noexcept { return rows_; }
  std::size_t memory_bytes() const noexcept { return heights_.capacity() * sizeof(float); }
  /// Row by row from the lowest.
  const std::vector<float>& heights() const noexcept { return heights_; }

  /// Height at (u, v), 0 <= u <= columns - 1 likewise v, held to that; beyond the edge the array
  /// goes on as its last row or column.
  HeightSample Stretched(double u, double v) const noexcept;
  /// Height at (u, v) >= 0 of the array repeated without end: column `columns()` is column 0.
  HeightSample Tiled(double u, double v) const noexcept;

  /// What height, its derivatives by u and by v, and its second derivatives do not exceed.
  struct Bounds {
    double height = 0;
    glm::dvec2 slope{0.0, 0.0};     ///< by u, by v
    double uu = 0, vv = 0, uv = 0;  ///< second derivatives
  };
  Bounds GreatestOf(bool tiled) const;

 private:
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<float> heights_;
};

}  // namespace moontrace
