#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "lessons/course/trial.h"
#include "lessons/measure/intended_strokes.h"
#include "lessons/measure/scoring.h"

namespace moontrace {

/// Measures one trial while it lasts, sample by sample: coverage and errors (scoring.h),
/// smoothness, force, and how much the push did. Off the tick; memory is bounded, however long the
/// trial lasts.
class TrialMeter {
 public:
  /// `tick` [s] between samples.
  TrialMeter(const std::vector<IntendedStroke>& strokes, std::size_t glyph_count, double tick);
  ~TrialMeter();
  TrialMeter(TrialMeter&&) noexcept;
  TrialMeter& operator=(TrialMeter&&) noexcept;

  /// In time order. `guidance_P` [N] is the push within the sample's force.
  void Add(const TraceSample& sample, glm::dvec3 guidance_P);
  /// Coverage, errors, wander-offs, duration (first to last touch), smoothness (movement_meter.h's
  /// rate and filter), mean force in contact, mean push while there was one, and its work on the
  /// hand into `trial`.
  void Fill(Trial& trial) const;
  /// Coverage so far, 0-1: for "is it done?".
  double Coverage() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
