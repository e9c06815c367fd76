#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/reader/reader_knowledge.h"
#include "textures/base/random.h"

namespace moontrace {

/// The senses of a hand.
struct Senses {
  double delay = 0.120;  ///< by which force and place are felt late [s]
  double unsure = 0;     ///< rms error of the place, along and across the paper (UnsurePlace) [m]
};

/// What was felt some time ago.
class LateSenses {
 public:
  /// `before`: what was felt until now. Both times [s].
  LateSenses(double delay, double tick, const ReaderInput& before)
      : kept_(static_cast<std::size_t>(std::lround(delay / tick)) + 1, before) {}

  /// One tick's reading for one that is older by the delay, told as of now.
  ReaderInput Pass(const ReaderInput& now) noexcept;

 private:
  std::vector<ReaderInput> kept_;
  std::size_t slot_ = 0;
};

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
