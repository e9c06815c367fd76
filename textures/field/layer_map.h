#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace moontrace {

struct CompiledPart;

/// Which of a field's layers beyond the first can matter where, so that a query of a page with
/// rules, margins and links mostly asks for its letters alone: the page in squares, with a bit for
/// each layer. Those from the fourth on share the last bit.
class LayerMap {
 public:
  static constexpr std::size_t kBits = 4;

  /// Of no layers.
  LayerMap() = default;
  /// Of all parts but the first.
  explicit LayerMap(const std::vector<CompiledPart>& parts);

  /// Zero also for a point that is not finite. Bit i is that of the layer i + 1.
  unsigned At(glm::dvec2 p_P) const noexcept {
    const double u = (p_P.x - origin_P_.x) * per_m_, v = (p_P.y - origin_P_.y) * per_m_;
    // comparisons are written so that a NaN ends here
    if (!((u >= 0) & (u < columns_) & (v >= 0) & (v < rows_))) return 0;
    const std::uint32_t square =
        static_cast<std::uint32_t>(v) * static_cast<std::uint32_t>(columns_) +
        static_cast<std::uint32_t>(u);
    return static_cast<unsigned>(pairs_[square / 2]) >> (4 * (square % 2)) & 0xfu;
  }
  std::size_t memory_bytes() const noexcept { return pairs_.capacity(); }

 private:
  glm::dvec2 origin_P_{0, 0};
  double per_m_ = 0;                 ///< [1/m]
  double columns_ = 0, rows_ = 0;    ///< whole numbers, compared as doubles
  std::vector<std::uint8_t> pairs_;  ///< of squares, the first in the lower four bits
};

}  // namespace moontrace
