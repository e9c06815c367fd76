#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "lessons/measure/smoothness.h"

namespace moontrace {

/// Measures the smoothness of one movement from samples that come one by one at any rate. They are
/// averaged over 10 ms, put on an even 100 Hz grid, and when smoothness is asked for the way is
/// low-passed at 10 Hz without delay (zero_phase.h; conscious movement stays below that) before
/// speeds are taken. Rate and filter are fixed, so that figures of any two trials compare.
///
/// Holds at most 30 s (48 kB), allocated once; what comes later is another movement.
class MovementMeter {
 public:
  static constexpr double kRate = 100;      ///< [Hz]
  static constexpr double kCutoff = 10;     ///< [Hz]
  static constexpr double kLongest = 30;    ///< [s]
  static constexpr double kShortest = 0.2;  ///< shorter movements have no smoothness [s]
  static constexpr double kGap = 0.1;       ///< samples farther apart are two movements [s]

  MovementMeter();
  /// Whether a sample at `time` belongs to the movement: it follows within the gap and the movement
  /// has room for it. An empty one takes any.
  bool Takes(double time) const;
  /// `time` [s] must be one that it takes and `p` finite [m]; a time not later than the last one
  /// is left out.
  void Add(double time, glm::dvec2 p);
  /// Begins anew.
  void Clear();

  double duration() const;  ///< of what smoothness tells of [s]; 0 where that is too short
  Smoothness Measure() const;

 private:
  void Close();

  std::vector<glm::dvec2> grid_;  ///< the way, 10 ms apart [m]
  double origin_ = 0;             ///< first sample; times below are told from it [s]
  double last_ = 0;               ///< newest sample [s]
  bool any_ = false;
  double bin_end_ = 0;  ///< of the samples that are being averaged [s]
  double time_sum_ = 0;
  glm::dvec2 sum_{0, 0};
  std::size_t count_ = 0;
  double begin_ = 0;      ///< time of the grid's first point [s]
  double mean_time_ = 0;  ///< of the last closed bin [s]
  glm::dvec2 mean_{0, 0};
};

}  // namespace moontrace
