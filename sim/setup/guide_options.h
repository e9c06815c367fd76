#pragma once

#include <optional>
#include <vector>

#include "lessons/guide/guidance.h"
#include "sim/setup/cli_app.h"
#include "sim/trial/trial.h"

namespace moontrace {

/// `--guide`, `--help-level`, as given.
struct GuideOptions {
  std::optional<GuidanceMode> mode;
  std::optional<double> help;  ///< 0-10
};
void AddOptions(CLI::App& app, GuideOptions& options);

/// The push that was asked for, from the shipped table. Throws UsageError for a help level where
/// nothing guides.
TrialGuidance GuidanceOf(const GuideOptions& options);

}  // namespace moontrace
