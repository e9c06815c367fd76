#include "sim/app/metrics_json.h"

namespace moontrace {

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
  return json;
}

Json TotalJson(const TrialResult& result, bool with_real_time_factor) {
  Json json = MetricsJson(result.score.total);
  json["force_bound_n"] = result.force_bound;
  json["energy_out_uj"] = 1e6 * result.energy_out;
  json["faults"] = result.faults;
  json["lifts_within_lines"] = result.lifts_within_lines;
  if (with_real_time_factor) json["real_time_factor"] = result.real_time_factor;
  return json;
}

}  // namespace moontrace
