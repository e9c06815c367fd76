#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "textures/field/paper_field.h"
#include "textures/field/texture.h"

namespace moontrace {

/// Points and samples as columns: an array for each of their numbers [m, m/m]. None is null.
struct PointColumns {
  const double *x = nullptr, *y = nullptr;
};
struct SampleColumns {
  double *displacement = nullptr, *gradient_x = nullptr, *gradient_y = nullptr;
};

/// The compiled texture: flat, immutable, made for the tick. A query does not grow with the page.
class TextureField {
 public:
  struct CompiledLayer;  ///< see field_layer.h

  /// An empty field: flat everywhere.
  TextureField();
  /// Compiles a tree. Throws InputError for a broken profile or more than 2^24 placements.
  explicit TextureField(const Texture& texture);

  /// Displacement and gradient at `p_P` [m]; zero outside every element and for a point that is not
  /// finite. On a crease the lowest-numbered member's gradient. Any thread.
  Sample SampleAt(glm::dvec2 p_P) const noexcept;
  /// The same at many points, bit for bit; `samples` is at least as long. Faster where neighbours
  /// follow each other, as along the rows of a picture: what lies near is found once, and the
  /// points of a cell are worked out side by side. Any thread.
  void SamplesAt(std::span<const glm::dvec2> points_P, std::span<Sample> samples) const noexcept;
  /// The same where each number has an array of its own, all of `count` numbers. Any thread.
  void SamplesAt(const PointColumns& points_P, const SampleColumns& samples,
                 std::size_t count) const noexcept;

  /// Greatest slope and curvature over all elements: s_max [m/m], (s/r)_max [1/m]; zero when empty.
  /// Layers and paper add. Where an embossed crease is rounded the surface may be steeper, by the
  /// change of the blend's weights: at most 1.75 times, 1.2 in the fonts tried.
  double greatest_slope() const noexcept { return greatest_slope_; }
  /// 1 over a slope that is exceeded nowhere, rounded embossed creases included [m/m]; infinite
  /// when empty.
  double inverse_slope_bound() const noexcept { return inverse_slope_bound_; }
  double greatest_curvature() const noexcept { return greatest_curvature_; }
  /// Deepest and highest displacement that can occur [m], both >= 0 as magnitudes, summed over
  /// layers.
  double greatest_displacement() const noexcept { return greatest_displacement_; }
  /// Highest displacement above the plane that can occur [m], >= 0; zero where all is engraved.
  double greatest_rise() const noexcept { return greatest_rise_; }
  /// Deepest displacement below the plane [m], >= 0; zero where all is embossed.
  double greatest_fall() const noexcept { return greatest_fall_; }

  std::size_t memory_bytes() const noexcept;
  /// A digest of everything that decides a sample: equal fields, equal digests.
  std::uint64_t Hash() const noexcept;

 private:
  /// SampleAt of any field, layer by layer.
  Sample SampleLayers(glm::dvec2 p_P) const noexcept;

  bool is_page_ = false;  ///< one layer of letters in pairs on smooth paper: SampleAt's short way
  std::vector<CompiledLayer> layers_;
  PaperField paper_;
  double greatest_slope_ = 0;
  double inverse_slope_bound_ = std::numeric_limits<double>::infinity();
  double greatest_curvature_ = 0;
  double greatest_displacement_ = 0;
  double greatest_rise_ = 0;
  double greatest_fall_ = 0;

 public:
  ~TextureField();
  TextureField(TextureField&&) noexcept;
  TextureField& operator=(TextureField&&) noexcept;
  TextureField(const TextureField&) = delete;
  TextureField& operator=(const TextureField&) = delete;
};

}  // namespace moontrace
