#include "lessons/measure/trace_metrics.h"

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

double Ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

/// (a - b) / (a + b).
double Balance(double a, double b, double without) {
  return a + b > 0 ? (a - b) / (a + b) : without;
}

}  // namespace

void Include(TraceTally& sum, const TraceTally& part) {
  for (double TraceTally::*field :
       {&TraceTally::length, &TraceTally::covered, &TraceTally::path_length,
        &TraceTally::error_integral, &TraceTally::square_error_integral,
        &TraceTally::offset_integral, &TraceTally::duration, &TraceTally::contact_time,
        &TraceTally::time_outside, &TraceTally::pause_time, &TraceTally::followed,
        &TraceTally::follow_time, &TraceTally::forward, &TraceTally::backward,
        &TraceTally::force_sum, &TraceTally::normal_sum, &TraceTally::smooth_time,
        &TraceTally::shaped, &TraceTally::warped_length}) {
    sum.*field += part.*field;
  }
  for (std::size_t TraceTally::*field :
       {&TraceTally::excursions, &TraceTally::entries, &TraceTally::lifts, &TraceTally::pauses,
        &TraceTally::in_order, &TraceTally::out_of_order, &TraceTally::contacts}) {
    sum.*field += part.*field;
  }
  for (double TraceTally::*field :
       {&TraceTally::max_error, &TraceTally::entry_error, &TraceTally::peak_force,
        &TraceTally::peak_normal, &TraceTally::frechet, &TraceTally::hausdorff}) {
    sum.*field = std::max(sum.*field, part.*field);
  }
  sum.smooth_sum.normalised_jerk += part.smooth_sum.normalised_jerk;
  sum.smooth_sum.log_jerk += part.smooth_sum.log_jerk;
  sum.smooth_sum.spectral_arc += part.smooth_sum.spectral_arc;
  sum.smooth_sum.peaks += part.smooth_sum.peaks;
}

void Include(TraceTally& sum, const Smoothness& smoothness, double time) {
  sum.smooth_time += time;
  sum.smooth_sum.normalised_jerk += time * smoothness.normalised_jerk;
  sum.smooth_sum.log_jerk += time * smoothness.log_jerk;
  sum.smooth_sum.spectral_arc += time * smoothness.spectral_arc;
  sum.smooth_sum.peaks += smoothness.peaks;
}

TraceMetrics MetricsOf(const TraceTally& tally) {
  TraceMetrics metrics;
  metrics.coverage = std::min(1.0, Ratio(tally.covered, tally.length));
  // Touched without a path: a tip that rested in one place.
  const bool moved = tally.path_length > 0;
  metrics.mean_error = moved ? tally.error_integral / tally.path_length : tally.max_error;
  metrics.rms_error =
      moved ? std::sqrt(tally.square_error_integral / tally.path_length) : tally.max_error;
  metrics.max_error = tally.max_error;
  metrics.bias = Ratio(tally.offset_integral, tally.path_length);
  metrics.excursions = tally.excursions;
  metrics.time_outside = tally.time_outside;
  metrics.duration = tally.duration;
  metrics.contact_share = Ratio(tally.contact_time, tally.duration);
  metrics.mean_speed = Ratio(tally.followed, tally.follow_time);
  metrics.pauses = tally.pauses;
  metrics.pause_time = tally.pause_time;
  const auto contacts = static_cast<double>(tally.contacts);
  metrics.mean_force = Ratio(tally.force_sum, contacts);
  metrics.peak_force = tally.peak_force;
  metrics.mean_normal_force = Ratio(tally.normal_sum, contacts);
  metrics.peak_normal_force = tally.peak_normal;
  metrics.entries = tally.entries;
  metrics.lifts = tally.lifts;
  metrics.entry_error = tally.entry_error;
  metrics.direction = Balance(tally.forward, tally.backward, 0);
  metrics.order =
      Balance(static_cast<double>(tally.in_order), static_cast<double>(tally.out_of_order), 1);
  metrics.shape.warped = Ratio(tally.warped_length, tally.shaped);
  metrics.shape.frechet = tally.frechet;
  metrics.shape.hausdorff = tally.hausdorff;
  const double time = tally.smooth_time;
  metrics.smoothness.normalised_jerk = Ratio(tally.smooth_sum.normalised_jerk, time);
  metrics.smoothness.log_jerk = Ratio(tally.smooth_sum.log_jerk, time);
  metrics.smoothness.spectral_arc = Ratio(tally.smooth_sum.spectral_arc, time);
  metrics.smoothness.peaks = tally.smooth_sum.peaks;
  return metrics;
}

double SpeedAccuracyCost(const TraceMetrics& metrics) {
  return metrics.duration * metrics.mean_error;
}

}  // namespace moontrace
