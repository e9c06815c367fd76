#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "lessons/measure/nearest_stroke.h"
#include "lessons/measure/trial_meter.h"
#include "sim/loop/loop_types.h"
#include "sim/trial/record.h"

namespace moontrace {

/// What scoring takes of a sample of the loop; its stroke is not assigned yet.
TraceSample ToScore(const LoopSample& sample);

/// A hand on one page of a lesson, from when it is shown: what it did so far, and whether a trace
/// has ended.
class LearnTrace {
 public:
  /// `tick` [s]; `reach`: a stroke is meant within it [m]; `keep_track`: raw samples are kept.
  LearnTrace(std::vector<IntendedStroke> strokes, std::size_t glyph_count, double tick,
             double reach, bool keep_track);

  /// Off the tick, in time order, samples of this page only.
  void Add(const LoopSample& sample);
  /// The tip has touched the page.
  bool touched() const { return first_touch_.has_value(); }
  double Coverage() const { return meter_.Coverage(); }
  /// More of the strokes than a tip covers that rests in one of them, or crosses it.
  bool followed() const;
  /// All is followed, to `coverage` of the strokes' length, and the tip is lifted since half a
  /// second.
  bool Ended(double coverage) const;
  /// Since the first touch [s]; 0 before it.
  double duration() const { return first_touch_ ? now_ - *first_touch_ : 0; }
  /// Its metrics; the rest of the trial stays empty.
  Trial Measured() const;
  /// Raw samples, five numbers each: time [s], tip x, y, z [m], 1 in contact else 0. At most five
  /// minutes' worth; empty unless kept.
  const std::vector<double>& track() const { return track_; }
  const std::vector<IntendedStroke>& strokes() const { return strokes_; }

 private:
  std::vector<IntendedStroke> strokes_;
  NearestStroke nearest_;
  TrialMeter meter_;
  bool keep_track_;
  std::vector<double> track_;
  std::size_t longest_track_;
  std::optional<double> first_touch_;  ///< [s]
  double now_ = 0, last_touch_ = 0;    ///< [s]
};

}  // namespace moontrace
