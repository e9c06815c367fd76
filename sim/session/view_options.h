#pragma once

#include <string>

#include "sim/setup/cli_app.h"

namespace moontrace {

/// `--view`, `--frames`, `--contrast`, `--large-text`.
struct ViewOptions {
  bool window = false;
  std::string frames;  ///< folder; empty: none
  bool contrast = false, large_text = false;
  bool asked() const { return window || !frames.empty(); }
};

/// Of a command that runs without a view too.
void AddOptions(CLI::App& app, ViewOptions& options);
/// Of the view itself: without `--view`.
void AddLookOptions(CLI::App& app, ViewOptions& options);
/// Throws UsageError: window and frames at once, or a look without a view.
void CheckTogether(const ViewOptions& options);

}  // namespace moontrace
