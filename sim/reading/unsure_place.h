#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "textures/base/random.h"

namespace moontrace {

/// How wrongly a hand knows where it is: an error that wanders smoothly over some 1.5 s, apart from
/// where the hand truly is. Two equal lags in a row make it of white noise, so that it has a speed
/// but no jitter; its correlation over a time t is (1 + t / lag) exp(-t / lag), whose integral, 1.5
/// s, is two lags.
class UnsurePlace {
 public:
  static constexpr double kLag = 0.75;  ///< each [s]

  /// `rms` on each axis [m]; 0: none. `tick` [s].
  UnsurePlace(double rms, double tick, std::uint64_t seed);

  /// The error of the next tick [m].
  glm::dvec2 Next() noexcept;

 private:
  double share_ = 0, kick_ = 0;  ///< of the way in a tick; of the noise [m]
  Random random_;
  glm::dvec2 inner_{0, 0}, error_{0, 0};  ///< [m]
};

}  // namespace moontrace
