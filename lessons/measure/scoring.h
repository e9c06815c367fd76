#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "lessons/measure/shape_distance.h"
#include "lessons/measure/smoothness.h"

namespace moontrace {

/// What the hand is doing: above the page; coming down, until it has settled; following a stroke;
/// leaving the page; on its way from stroke to stroke without lifting.
enum class TracePhase { kAir, kEntry, kStroke, kLift, kWay };

/// One tick as scoring sees it.
struct TraceSample {
  double time = 0;              ///< [s]
  glm::dvec3 tip_P{0, 0, 0};    ///< of the tip, never of the proxy [m]
  glm::dvec3 force_P{0, 0, 0};  ///< on the tip [N]
  bool in_contact = false;
  TracePhase phase = TracePhase::kAir;
  std::size_t stroke = 0;  ///< index of the intended stroke, valid unless kAir; kWay: the next
};

/// How well one letter or all of them were traced. Only samples in contact while a stroke is
/// followed (kStroke) count for coverage, errors and excursions: entries and lifts stand apart.
struct TraceMetrics {
  /// Share of the strokes' length that lies within w/4 of a sample, by the union of intervals. A
  /// dot counts one width w, covered when touched within w/4 of its centre.
  double coverage = 0;
  /// Distance of the tip to its stroke [m], each bit weighed by the length of the tip's way in it,
  /// so that pausing weighs nothing. A dot's error is its closest approach and weighs one width.
  /// Zero where nothing was touched: coverage tells.
  double mean_error = 0;
  double rms_error = 0;
  double max_error = 0;
  std::size_t excursions = 0;  ///< times left beyond w/2, each over once back within w/4; not dots
  double duration = 0;         ///< of a letter without the air between [s]; of all with it
  double mean_force = 0;       ///< over the time in contact, entries and lifts included [N]
  double peak_force = 0;       ///< [N]
  std::size_t entries = 0;     ///< landings
  std::size_t lifts = 0;       ///< contact lost while following a stroke, and regained
  double entry_error = 0;      ///< greatest distance from the stroke's start at a landing [m]

  double bias = 0;           ///< mean offset, > 0 to the left of the way, weighed as the errors [m]
  double time_outside = 0;   ///< of the excursions, until back within w/4 [s]
  double contact_share = 0;  ///< of the duration, 0-1
  double mean_speed = 0;     ///< while following a stroke [m/s]
  std::size_t pauses = 0;    ///< in contact (pause_meter.h)
  double pause_time = 0;     ///< [s]
  double mean_normal_force = 0, peak_normal_force = 0;  ///< across the page, in contact [N]
  /// Way along the strokes less the way against them, as a share of both: 1 as written, -1
  /// backwards, 0 where nothing was followed.
  double direction = 0;
  /// Pairs of a letter's strokes that were visited in the order of writing less those that were
  /// not, as a share of both (Kendall's tau): 1 in order, -1 backwards; 1 without a pair. Visited:
  /// followed for a groove's width.
  double order = 1;
  /// Mean over movements, each a stretch in contact along one stroke (movement_meter.h), weighed
  /// by time; peaks are summed. Zero where none was long enough.
  Smoothness smoothness;
  /// Of the tip's way along each visited stroke from the stroke, both put on as many points a
  /// quarter of the groove's width apart (16 to 128): `warped` the mean weighed by length, the
  /// others the greatest.
  ShapeDistance shape;
};

/// Time x error [s m], less is better: what a trace costs that is neither fast at any price nor
/// exact at any price. Only for traces of the same text. The formula is ours: Williams, Tremblay
/// and Carnahan (2016) combine the two, but how is not known to us.
double SpeedAccuracyCost(const TraceMetrics& metrics);

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
  /// Letters of which half was covered, by the time of all [1/s].
  double letters_per_second = 0;
};

/// Takes samples one by one in time order, so that nothing long need be kept. Metrics after
/// `training-and-ux.md` 1.5. Memory is bounded by the strokes, however long the trace lasts, but
/// for parts that are covered separately. For off the tick: Add allocates now and then, and where a
/// movement ends it takes up to some milliseconds. A sample whose tip is not finite counts as out
/// of contact.
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
