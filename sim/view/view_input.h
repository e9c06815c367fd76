#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "sim/view/view_painter.h"
#include "sim/view/viewer_options.h"
#include "sim/view/window_event.h"

namespace moontrace {

/// What mouse and keyboard in the window mean: lines for the text face, an aim for the stylus,
/// another view. Keys: letters and Enter say a line, Escape says "stop", Space "pause" and "go" in
/// turn, Tab and the arrows lead through the panel, Page up and down zoom, Home shows the whole
/// page. Mouse: aims (without `pointer` it drags the page, turns round a model), wheel presses,
/// with Control it zooms, right drags the page, middle leans it or turns round the model.
class ViewInput {
 public:
  ViewInput(ViewPainter& painter, std::function<void(const PointerAim&)> pointer);

  /// `now` of a steady clock [s].
  void Handle(const WindowEvent& event, double now);
  std::optional<ViewLine> NextLine(double now);

 private:
  void Key(const WindowEvent& event, double now);
  void Text(char32_t character);
  void Mouse(const WindowEvent& event, double now);
  void Drag(const WindowEvent& event);
  void Wheel(const WindowEvent& event);
  void Aim(bool over_page);
  void PauseOrGo();
  glm::dvec2 ShareAt(glm::dvec2 at) const;

  ViewPainter& painter_;
  std::function<void(const PointerAim&)> pointer_;
  std::deque<ViewLine> lines_;
  std::string typed_;
  bool paused_ = false;
  glm::dvec2 at_{0, 0};                                    // of the mouse [points]
  glm::dvec2 aimed_P_{0, 0};                               // last, on the page [m]
  WindowEvent::Button held_ = WindowEvent::Button::kNone;  // that began on the page
  bool in_panel_ = false;                                  // a drag that began there
  bool over_page_ = false;
  double press_ = 0.8;  // of the left button [N]
};

}  // namespace moontrace
