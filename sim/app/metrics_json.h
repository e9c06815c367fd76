#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "lessons/scoring.h"
#include "sim/app/trial.h"

namespace moontrace {

/// Key order is the order of writing, as people read them.
using Json = nlohmann::ordered_json;

/// JSON has no infinity: null stands for "without limit" and for "none".
inline Json OrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Then there are no errors either, and zero would read as perfect.
inline bool NeverTouched(const TraceMetrics& metrics) { return !(metrics.contact_share > 0); }

/// Metrics with the unit in the key, as `trace --json` and trial.json give them; errors are null
/// where nothing was touched.
Json MetricsJson(const TraceMetrics& metrics);

/// Metrics of the whole with energy, faults and, if asked for, the real-time factor.
Json TotalJson(const TrialResult& result, bool with_real_time_factor);

}  // namespace moontrace
