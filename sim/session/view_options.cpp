#include "sim/session/view_options.h"

#include "sim/console/console.h"
#include "sim/session/view_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"

namespace moontrace {

ViewerOptions ViewerOf(const ViewOptions& options) {
  ViewerOptions viewer;
  viewer.frames = options.frames;
  if (options.width) {
    viewer.width = static_cast<int>(*options.width);
    viewer.height = 9 * viewer.width / 16;
  }
  viewer.high_contrast = options.contrast;
  viewer.large_text = options.large_text;
  viewer.camera = options.camera;
  return viewer;
}

void AddLookOptions(CLI::App& app, ViewOptions& options) {
  BeginGroup(app, help_group::kView);
  AddPath(app, "--frames", "DIR", options.frames, say::help::kFrames);
  AddNumber(app, "--width-px", options.width, 320, 3840, 1, say::help::kPictureWidth);
  AddFlag(app, "--contrast", options.contrast, say::help::kContrast);
  AddFlag(app, "--large-text", options.large_text, say::help::kLargeText);
}

void AddOptions(CLI::App& app, ViewOptions& options) {
  BeginGroup(app, help_group::kView);
  AddFlag(app, "--view", options.window, say::help::kView);
  AddLookOptions(app, options);
}

void AddCamera(CLI::App& app, ViewOptions& options) {
  BeginGroup(app, help_group::kView);
  AddPath(app, "--camera", "NAME", options.camera, say::help::kCamera);
}

void CheckCamera(const ViewOptions& options, const std::string& model) {
  if (options.camera.empty() || !model.empty()) return;
  throw UsageError(say::NeedsOther("--camera", "--model"));
}

void CheckTogether(const ViewOptions& options) {
  if (options.window && !options.frames.empty()) throw UsageError(say::WindowOrFrames());
  if (options.width && options.frames.empty()) {
    throw UsageError(say::NeedsOther("--width-px", "--frames"));
  }
  if (options.asked()) return;
  if (!options.camera.empty()) throw UsageError(say::NeedsOther("--camera", "--view"));
  if (options.contrast) throw UsageError(say::NeedsOther("--contrast", "--view"));
  if (options.large_text) throw UsageError(say::NeedsOther("--large-text", "--view"));
}

}  // namespace moontrace
