#include "sim/setup/guide_options.h"

#include <string>

#include "sim/setup/guide_messages.h"
#include "sim/setup/setup_messages.h"
#include "sim/wording/console.h"

namespace moontrace {

namespace {
constexpr double kUsualHelp = 6;  ///< as FadeSettings::start
}

void AddOptions(CLI::App& app, GuideOptions& options) {
  AddValue(
      app, "--guide", "MODE",
      [&options](const std::string& given) {
        options.mode = GuidanceModeOf(given);
        if (!options.mode) throw UsageError(say::NotAChoice("--guide", given, kGuidanceModes));
      },
      say::help::kGuide);
  AddNumber(app, "--help-level", options.help, 0, kMostHelp, 1, say::help::kHelpLevel);
}

TrialGuidance GuidanceOf(const GuideOptions& options) {
  if (options.help && !options.mode) throw UsageError(say::NeedsOther("--help-level", "--guide"));
  const GuidanceMode mode = options.mode.value_or(GuidanceMode::kOff);
  if (mode == GuidanceMode::kOff) return {};
  return GuidanceAt(mode, options.help.value_or(kUsualHelp));
}

}  // namespace moontrace
