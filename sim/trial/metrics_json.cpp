#include "sim/trial/metrics_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "lessons/measure/movement_meter.h"

namespace moontrace {

namespace {

/// How the hand moved, besides how close to the strokes it kept.
void AddConduct(Json& json, const TraceMetrics& metrics) {
  json["bias_mm"] = 1e3 * metrics.bias;
  json["dtw_mm"] = 1e3 * metrics.shape.warped;
  json["frechet_mm"] = 1e3 * metrics.shape.frechet;
  json["hausdorff_mm"] = 1e3 * metrics.shape.hausdorff;
  json["direction"] = metrics.direction;
  json["order"] = metrics.order;
  json["time_outside_s"] = metrics.time_outside;
  json["contact_share"] = metrics.contact_share;
  json["mean_speed_mm_s"] = 1e3 * metrics.mean_speed;
  json["pauses"] = metrics.pauses;
  json["pause_time_s"] = metrics.pause_time;
  json["speed_accuracy_cost_mm_s"] = 1e3 * SpeedAccuracyCost(metrics);
  json["mean_normal_force_n"] = metrics.mean_normal_force;
  json["peak_normal_force_n"] = metrics.peak_normal_force;
}

/// Null where no movement was long enough.
void AddSmoothness(Json& json, const Smoothness& smoothness) {
  const bool known = smoothness.normalised_jerk > 0;
  json["normalised_jerk"] = known ? Json(smoothness.normalised_jerk) : Json(nullptr);
  json["log_jerk"] = known ? Json(smoothness.log_jerk) : Json(nullptr);
  json["spectral_arc"] = known ? Json(smoothness.spectral_arc) : Json(nullptr);
  json["speed_peaks"] = smoothness.peaks;
}

/// A tip that followed nothing made no errors either: that must not read as a perfect trace.
void ForgetErrors(Json& json) {
  for (const char* key :
       {"mean_error_mm", "rms_error_mm", "max_error_mm", "excursions", "entry_error_mm", "bias_mm",
        "dtw_mm", "frechet_mm", "hausdorff_mm", "direction", "order", "speed_accuracy_cost_mm_s"}) {
    json[key] = nullptr;
  }
}

}  // namespace

Json OrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json MetricsJson(const TraceMetrics& metrics) {
  Json json;
  json["coverage"] = metrics.coverage;
  json["mean_error_mm"] = 1e3 * metrics.mean_error;
  json["rms_error_mm"] = 1e3 * metrics.rms_error;
  json["max_error_mm"] = 1e3 * metrics.max_error;
  json["excursions"] = metrics.excursions;
  json["duration_s"] = metrics.duration;
  json["mean_force_n"] = metrics.mean_force;
  json["peak_force_n"] = metrics.peak_force;
  json["entries"] = metrics.entries;
  json["lifts"] = metrics.lifts;
  json["entry_error_mm"] = 1e3 * metrics.entry_error;
  AddConduct(json, metrics);
  AddSmoothness(json, metrics.smoothness);
  if (FollowedNothing(metrics)) ForgetErrors(json);
  return json;
}

Json TotalJson(const TrialResult& result, bool with_real_time_factor) {
  Json json = MetricsJson(result.score.total);
  json["letters_per_second"] = result.score.letters_per_second;
  json["smoothness_rate_hz"] = MovementMeter::kRate;
  json["smoothness_low_pass_hz"] = MovementMeter::kCutoff;
  json["force_bound_n"] = OrNull(result.force_bound);
  json["force_bound_per_m_per_s2_n"] = result.force_per_acceleration;
  json["carried_press_n"] = result.carried_press;
  json["through"] = result.through;
  json["energy_out_uj"] = 1e6 * result.true_energy_out.value_or(result.energy_out);
  if (result.true_energy_out) json["energy_out_by_readings_uj"] = 1e6 * result.energy_out;
  json["faults"] = result.faults;
  json["page_gone_s"] = result.page_gone ? Json(*result.page_gone) : Json(nullptr);
  json["mean_guidance_n"] = result.mean_guidance;
  json["guidance_work_mj"] = 1e3 * result.guidance_work;
  json["lifts_within_lines"] = result.lifts_within_lines;
  json["links_left"] = result.links_left ? Json(result.links_left->size()) : Json(nullptr);
  if (with_real_time_factor) json["real_time_factor"] = result.real_time_factor;
  return json;
}

std::string ResultText(const TrialResult& result) { return TotalJson(result, false).dump(); }

}  // namespace moontrace
