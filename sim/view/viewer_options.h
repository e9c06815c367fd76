#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace moontrace {

/// What the mouse or pen in the window means for a stylus.
struct PointerAim {
  glm::dvec2 p_P{0, 0};  ///< [m]
  double press = 0;      ///< [N], 0: lifted
  bool over_page = false;
};

/// Of pictures that become a film.
inline constexpr double kFramesPerSecond = 30;

/// Where the viewer draws.
struct ViewerOptions {
  /// Empty: into a window. Else into this folder, without a display: frame-00001.png and so on,
  /// `frames_per_second` of them, until `most_frames`.
  std::string frames;
  double frames_per_second = kFramesPerSecond;
  std::size_t most_frames = 18000;
  /// A frame is drawn whenever Viewer::DrawFrame asks for it, not as time goes by.
  bool offline = false;
  std::string title = "Moontrace";
  int width = 1280, height = 720;  ///< of the picture, or of the window when it opens [pixels]
  bool high_contrast = false, large_text = false;
  std::string camera = {};  ///< what of a model is looked at first, as FindTarget has it
  /// Is given every move of mouse or pen over the page, by the viewer's thread; none: the mouse
  /// only looks.
  std::function<void(const PointerAim&)> pointer = {};
};

/// How the viewer kept up.
struct ViewerReport {
  std::size_t frames = 0;
  double median_frame_ms = 0, slowest_frame_ms = 0;  ///< drawing one frame
  double median_change_ms = 0;         ///< from a change of view or page until it is shown whole
  std::vector<std::string> seen = {};  ///< of a model at the end, in sentences
};

}  // namespace moontrace
