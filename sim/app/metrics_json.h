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

/// Metrics with the unit in the key, as `trace --json` and trial.json give them.
Json MetricsJson(const TraceMetrics& metrics);

/// Metrics of the whole with energy, faults and, if asked for, the real-time factor.
Json TotalJson(const TrialResult& result, bool with_real_time_factor);

}  // namespace moontrace
