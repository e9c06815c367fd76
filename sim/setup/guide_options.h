#pragma once

#include <optional>
#include <vector>

#include "lessons/guide/guidance.h"
#include "sim/setup/cli_app.h"

namespace moontrace {

/// `--guide`, `--help-level`, as given.
struct GuideOptions {
  std::optional<GuidanceMode> mode;
  std::optional<double> help;  ///< 0-10
};
void AddOptions(CLI::App& app, GuideOptions& options);

/// A push as a trial is told of it: what people asked for, and what it comes to. With `mode` off or
/// help 0 there is none.
struct TrialGuidance {
  GuidanceMode mode = GuidanceMode::kOff;
  double help = 0;      ///< 0-10, for people and records
  GuidanceGains gains;  ///< that decide
  bool on() const { return mode != GuidanceMode::kOff && help > 0; }
};

/// The push that was asked for, from the shipped table. Throws UsageError for a help level where
/// nothing guides.
TrialGuidance GuidanceOf(const GuideOptions& options);

/// Along the strokes of a page, in writing order.
GuidancePlan PlanOf(const TrialGuidance& guidance, const std::vector<IntendedStroke>& strokes);

}  // namespace moontrace
