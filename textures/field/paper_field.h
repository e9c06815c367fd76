#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "textures/field/paper.h"

namespace moontrace {

/// A patch with everything that a query needs worked out.
struct FlatPatch {
  Box box;                ///< [m]
  Box core;               ///< within the fade [m]
  double fade_per_m = 0;  ///< 1 / the fade's length [1/m]
  double amplitude = 0;   ///< of one wave, of the noise's polynomial, of an array [m]
  glm::dvec2 wave{0, 0};  ///< cycles a metre along the normal; lattice cells, samples a
                          ///< metre of the others [1/m]
  PaperKind kind = PaperKind::kNoise;
  bool tiled = false;
  std::uint32_t seed = 1;
  std::shared_ptr<const SampledHeights> heights;
};

/// The compiled paper textures of a page: flat, immutable, found by a grid of cells.
class PaperField {
 public:
  PaperField() = default;
  /// Throws InputError as Check, and for more than 4096 patches.
  explicit PaperField(const std::vector<PaperPatch>& patches);

  bool empty() const noexcept { return patches_.empty(); }
  /// The sum of the patches at a point; zero outside all and for a point that is not finite.
  Sample SampleAt(glm::dvec2 p_P) const noexcept;
  /// What no point exceeds. Patches add where their rectangles overlap.
  const PaperBounds& bounds() const noexcept { return bounds_; }

  const std::vector<FlatPatch>& patches() const noexcept { return patches_; }
  std::size_t memory_bytes() const noexcept;

 private:
  void AddCells();
  /// Of several patches, for a point in the box of all.
  Sample SampleCell(glm::dvec2 p_P) const noexcept;

  Box box_;  // of all [m]
  glm::dvec2 cells_per_m_{0, 0};
  std::size_t columns_ = 0;
  std::vector<std::uint32_t> first_;  // of each cell in items_, and the end
  std::vector<std::uint16_t> items_;
  std::vector<FlatPatch> patches_;
  PaperBounds bounds_;
};

}  // namespace moontrace
