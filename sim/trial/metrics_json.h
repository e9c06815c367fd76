#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lessons/measure/scoring.h"
#include "sim/trial/trial_result.h"

namespace moontrace {

/// Key order is the order of writing, as people read them.
using Json = nlohmann::ordered_json;

/// JSON has no infinity: null stands for "without limit" and for "none".
Json OrNull(double value);

/// Metrics with the unit in the key, as `trace --json` and trial.json give them; errors are null
/// where nothing was followed.
Json MetricsJson(const TraceMetrics& metrics);

/// Metrics of the whole with energy, faults and, if asked for, the real-time factor.
Json TotalJson(const TrialResult& result, bool with_real_time_factor);

/// What a record keeps of a trial: without the real-time factor, so that the same seed gives the
/// same bytes.
std::string ResultText(const TrialResult& result);

}  // namespace moontrace
