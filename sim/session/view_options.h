#pragma once

#include <optional>
#include <string>

#include "sim/setup/cli_app.h"
#include "sim/view/viewer_options.h"

namespace moontrace {

/// `--view`, `--frames`, `--width-px`, `--contrast`, `--large-text`, `--camera`.
struct ViewOptions {
  bool window = false;
  std::string frames;  ///< folder; empty: none
  bool contrast = false, large_text = false;
  std::optional<double> width;  ///< of pictures and frames [points]; the height is 9/16 of it
  std::string camera;           ///< what of a model is looked at; empty: the page's label
  bool asked() const { return window || !frames.empty(); }
};

/// How a viewer looks then.
ViewerOptions ViewerOf(const ViewOptions& options);
/// Of a command that runs without a view too.
void AddOptions(CLI::App& app, ViewOptions& options);
/// Of the view itself: without `--view`.
void AddLookOptions(CLI::App& app, ViewOptions& options);
/// `--camera`, of a command that takes a model.
void AddCamera(CLI::App& app, ViewOptions& options);
/// Throws UsageError: `--camera` without a model.
void CheckCamera(const ViewOptions& options, const std::string& model);
/// Throws UsageError: window and frames at once, or a look without a view.
void CheckTogether(const ViewOptions& options);

}  // namespace moontrace
