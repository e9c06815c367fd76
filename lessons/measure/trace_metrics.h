#pragma once

#include <cstddef>

#include "lessons/measure/shape_distance.h"
#include "lessons/measure/smoothness.h"

namespace moontrace {

/// How well one letter or all of them were traced. Only samples in contact while a stroke is
/// followed (kStroke) count for coverage, errors and excursions: entries and lifts stand apart.
struct TraceMetrics {
  /// Share of the strokes' length that lies within w/4 of a sample, by the union of intervals. A
  /// dot counts one width w, covered when touched within w/4 of its centre. Of a fill's centre arc
  /// that lies covered beside which a sample lies w/4 inside the rim.
  double coverage = 0;
  /// Distance of the tip to its stroke [m], each bit weighed by the length of the tip's path in it,
  /// so that pausing weighs nothing. A dot's error is its closest approach and weighs one width; a
  /// fill's what lacks of w/2 from its rim, if that is less than the distance to its centre arc.
  /// Zero where nothing was touched: coverage shows that.
  double mean_error = 0;
  double rms_error = 0;
  double max_error = 0;
  std::size_t excursions = 0;  ///< times left beyond w/2, each over once back within w/4; not dots
  double duration = 0;         ///< of a letter without the air between [s]; of all with it
  double mean_force = 0;       ///< over the time in contact, entries and lifts included [N]
  double peak_force = 0;       ///< over all the time, in the air too [N]
  std::size_t entries = 0;     ///< landings
  std::size_t lifts = 0;       ///< contact lost while following a stroke, and regained
  double entry_error = 0;      ///< greatest distance from the stroke's start at a landing [m]

  double bias = 0;           ///< mean offset, > 0 to the left of the path, weighed as errors [m]
  double time_outside = 0;   ///< of the excursions, until back within w/4 [s]
  double contact_share = 0;  ///< of the duration, 0-1
  double mean_speed = 0;     ///< while following a stroke [m/s]
  std::size_t pauses = 0;    ///< in contact (PauseMeter, movement_meter.h)
  double pause_time = 0;     ///< [s]
  double mean_normal_force = 0, peak_normal_force = 0;  ///< across the page, in contact [N]
  /// Path along the strokes less the path against them, as a share of both: 1 as written, -1
  /// backwards, 0 where nothing was followed.
  double direction = 0;
  /// Pairs of a letter's strokes that were visited in the order of writing less those that were
  /// not, as a share of both (Kendall's tau): 1 in order, -1 backwards; 1 without a pair. Visited:
  /// followed for a groove's width.
  double order = 1;
  /// Mean over movements, each a stretch in contact along one stroke (movement_meter.h), weighed
  /// by time; peaks are summed. Zero where none was long enough.
  Smoothness smoothness;
  /// Of the tip's path along each visited stroke from the stroke, both put on as many points a
  /// quarter of the groove's width apart (16 to 128): `warped` the mean weighed by length, the
  /// others the greatest.
  ShapeDistance shape;
};

/// Without a touch there are no errors either, and zero would read as perfect.
inline bool NeverTouched(const TraceMetrics& metrics) { return !(metrics.contact_share > 0); }

/// Nor are there without a stroke that was followed: of a tip that fell through the paper as it
/// landed, say.
inline bool FollowedNothing(const TraceMetrics& metrics) {
  return NeverTouched(metrics) ||
         (metrics.coverage == 0 && metrics.mean_speed == 0 && metrics.max_error == 0);
}

/// Time x error [s m], less is better: a cost that rewards neither speed nor accuracy alone. Only
/// for traces of the same text. The formula is ours: Williams, Tremblay and Carnahan (2016) combine
/// the two by a formula that we do not know.
double SpeedAccuracyCost(const TraceMetrics& metrics);

/// What has been summed for one stroke, one letter or all: plain sums, so that they add.
struct TraceTally {
  double length = 0, covered = 0;    ///< intended [m]
  double path_length = 0;            ///< of the tip; the weight of the errors [m]
  double error_integral = 0;         ///< integral of the error over the path [m^2]
  double square_error_integral = 0;  ///< of its square [m^3]
  double offset_integral = 0;        ///< of the signed offset [m^2]
  double max_error = 0;
  std::size_t excursions = 0, entries = 0, lifts = 0, pauses = 0;
  double entry_error = 0;
  double duration = 0, contact_time = 0, time_outside = 0, pause_time = 0;  ///< [s]
  double followed = 0, follow_time = 0;                                     ///< [m], [s]
  double forward = 0, backward = 0;                                         ///< [m]
  double shaped = 0, warped_length = 0;  ///< strokes whose shape is known [m], times warped [m^2]
  double frechet = 0, hausdorff = 0;
  std::size_t in_order = 0, out_of_order = 0;  ///< pairs of strokes
  double force_sum = 0, peak_force = 0, normal_sum = 0, peak_normal = 0;
  std::size_t contacts = 0;  ///< samples in contact
  double smooth_time = 0;    ///< of the movements [s]
  Smoothness smooth_sum;     ///< each times its movement's time; peaks as they are
};

void Include(TraceTally& sum, const TraceTally& part);
/// A movement of that many seconds.
void Include(TraceTally& sum, const Smoothness& smoothness, double time);
TraceMetrics MetricsOf(const TraceTally& tally);

}  // namespace moontrace
