#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "lessons/measure/trace_metrics.h"

namespace moontrace {

/// What the hand is doing: above the page; coming down, until it has settled; following a stroke;
/// leaving the page; travelling over the page from one stroke to the next without lifting.
enum class TracePhase { kAir, kEntry, kStroke, kLift, kTravel };

/// One tick as scoring sees it.
struct TraceSample {
  double time = 0;              ///< [s]
  glm::dvec3 tip_P{0, 0, 0};    ///< of the tip, never of the proxy [m]
  glm::dvec3 force_P{0, 0, 0};  ///< on the tip [N]
  bool in_contact = false;
  TracePhase phase = TracePhase::kAir;
  std::size_t stroke = 0;  ///< index of the intended stroke, valid unless kAir; kTravel: the next
};

/// Where a sample left the groove: for pictures and words.
struct Excursion {
  glm::dvec2 p_P{0, 0};
  double time = 0;
  std::size_t stroke = 0;
};
struct TraceScore {
  std::vector<TraceMetrics> letters;  ///< one per glyph of the page
  TraceMetrics total;
  std::vector<Excursion> left_at;  ///< the first 1000
  /// Letters of which half was covered, over the whole duration [1/s].
  double letters_per_second = 0;
};

/// Takes samples one by one in time order, so that no trace has to be kept. Metrics after
/// `training-and-ux.md` 1.5. Memory is bounded by the strokes, however long the trace lasts, but
/// for parts that are covered separately. Not for the tick: Add allocates now and then, and takes
/// up to some milliseconds where a movement ends. A sample whose tip is not finite counts as out of
/// contact.
class TraceScorer {
 public:
  /// Throws std::invalid_argument for a stroke whose glyph is not below `glyph_count`.
  TraceScorer(const std::vector<IntendedStroke>& strokes, std::size_t glyph_count);
  ~TraceScorer();
  TraceScorer(TraceScorer&&) noexcept;
  TraceScorer& operator=(TraceScorer&&) noexcept;

  /// Throws std::out_of_range for a stroke that was not given.
  void Add(TraceSample sample);
  /// Of all strokes so far, 0-1; costs little.
  double Coverage() const;
  TraceScore Finish() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
