#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace moontrace {

/// Tremor of an aim: on each axis a sum of sinusoids of equal amplitude, one in each part of the
/// band, with frequencies and phases drawn from the seed. Their mean square over a long time is
/// rms^2 exactly. Phases stay exact however long it runs.
class Tremor {
 public:
  static constexpr std::size_t kPerAxis = 8;

  /// `rms` per axis [m]; the band in [Hz]; `tick` in [s].
  Tremor(double rms, double low, double high, double tick, std::uint64_t seed);

  /// Displacement at this tick [m]; then goes on by one tick.
  glm::dvec3 Next() noexcept;

 private:
  static constexpr std::size_t kCount = 3 * kPerAxis;
  /// Sets one oscillator from its own phase at the present tick, undoing what rounding has added.
  void Anchor(std::size_t i) noexcept;

  double amplitude_ = 0;                    ///< of each sinusoid [m]
  std::array<double, kCount> frequency_{};  ///< [turns per tick]
  std::array<double, kCount> phase_{};      ///< at tick 0 [turns]
  std::array<double, kCount> cos_{}, sin_{};
  std::array<double, kCount> step_cos_{}, step_sin_{};
  std::uint64_t tick_ = 0;
};

}  // namespace moontrace
