#pragma once

#include <cstddef>

#include "lessons/measure/scoring.h"

namespace moontrace {

/// What has been summed for one stroke, one letter or all: plain sums, so that they add.
struct TraceTally {
  double length = 0, covered = 0;  ///< intended [m]
  double way = 0;                  ///< of the tip, weight of the errors [m]
  double error_way = 0;            ///< integral of the error over the way [m^2]
  double square_way = 0;           ///< of its square [m^3]
  double aside_way = 0;            ///< of the signed offset [m^2]
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
