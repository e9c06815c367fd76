#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/console/console.h"
#include "sim/setup/text_setup.h"
#include "sim/trial/metrics_json.h"
#include "sim/trial/trial.h"

namespace moontrace {

/// A text that was traced, page by page, before it is reported.
struct Trace {
  TextSetup text;
  std::vector<TrialResult> pages;
  std::vector<std::string> pictures, records;
  bool blank = false;
  TrialGuidance guidance;
  std::optional<DeviceProfile> device;  ///< that the simulated hand is on
};

/// What `trace --json` gives, but for what only one kind of trace has.
Json TraceJson(const Trace& trace, const SceneOptions& scene, const TrialResult& all);

/// The same in words. `time` is the sentence about the time that it took.
void SayTrace(const Trace& trace, const TrialResult& all, const std::string& time,
              Console& console);

}  // namespace moontrace
