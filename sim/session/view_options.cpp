#include "sim/session/view_options.h"

#include "sim/console/console.h"
#include "sim/session/view_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"

namespace moontrace {

void AddLookOptions(CLI::App& app, ViewOptions& options) {
  BeginGroup(app, help_group::kView);
  AddPath(app, "--frames", "DIR", options.frames, say::help::kFrames);
  AddFlag(app, "--contrast", options.contrast, say::help::kContrast);
  AddFlag(app, "--large-text", options.large_text, say::help::kLargeText);
}

void AddOptions(CLI::App& app, ViewOptions& options) {
  BeginGroup(app, help_group::kView);
  AddFlag(app, "--view", options.window, say::help::kView);
  AddLookOptions(app, options);
}

void CheckTogether(const ViewOptions& options) {
  if (options.window && !options.frames.empty()) throw UsageError(say::WindowOrFrames());
  if (options.asked()) return;
  if (options.contrast) throw UsageError(say::NeedsOther("--contrast", "--view"));
  if (options.large_text) throw UsageError(say::NeedsOther("--large-text", "--view"));
}

}  // namespace moontrace
