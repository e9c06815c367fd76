#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "lessons/measure/smoothness.h"

namespace moontrace {

/// Low-pass without delay: a Butterworth filter of second order run forwards and backwards (fourth
/// order in all, gain 1 at rest and 1/2 at `cutoff`), the ends continued by point reflection.
/// `rate` and `cutoff` in [Hz]; at or above half the rate the values are given back as they are.
std::vector<double> ZeroPhaseLowPass(const std::vector<double>& values, double rate, double cutoff);

/// Measures the smoothness of one movement from samples that come one by one at any rate. They are
/// averaged over 10 ms, put on an even 100 Hz grid, and when smoothness is asked for the path is
/// low-passed at 10 Hz without delay (ZeroPhaseLowPass; conscious movement stays below that) before
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
  /// Begins again.
  void Clear();

  double duration() const;  ///< of what smoothness is measured on [s]; 0 where that is too short
  Smoothness Measure() const;

 private:
  void Close();

  std::vector<glm::dvec2> grid_;  ///< the path, 10 ms apart [m]
  double origin_ = 0;             ///< first sample; times below count from it [s]
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

/// Finds pauses from samples one by one: the tip's mean speed over more than 0.3 s stays below
/// v0 = 2 mm/s (ours). Judged by how far it gets, 0.6 mm, not by speeds from tick to tick: a hand
/// trembles faster than it creeps.
class PauseMeter {
 public:
  static constexpr double kLeast = 0.3;    ///< [s]
  static constexpr double kSpeed = 0.002;  ///< v0 [m/s]

  struct Step {
    bool began = false;  ///< another pause was found
    double time = 0;     ///< that the sample adds to pauses [s]
  };
  /// In time order; `p` finite [m].
  Step Add(double time, glm::dvec2 p);
  /// The hand is elsewhere: what comes next is not the same pause.
  void Break() { any_ = false; }

 private:
  bool any_ = false;
  glm::dvec2 rest_{0, 0};  ///< where it has been near since `since_` [m]
  double since_ = 0;       ///< [s]
  double last_ = 0;        ///< [s]
  bool pausing_ = false;
  bool went_on_ = false;  ///< the rest before this one was a pause too
};

}  // namespace moontrace
