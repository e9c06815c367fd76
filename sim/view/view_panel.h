#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/page_view/canvas.h"
#include "sim/page_view/view_look.h"
#include "sim/view/panel.h"
#include "sim/view/window_event.h"

namespace moontrace {

/// The tutor's panel by Dear ImGui's controls. What its controls are given they say as lines; what
/// they show comes back by SetValues. All calls on the thread of OpenGL; times in seconds of one
/// steady clock.
class ViewPanel {
 public:
  ViewPanel();
  ~ViewPanel();

  void SetControls(std::vector<PanelControl> controls);
  /// One value a control. A control that was just changed here keeps what it was given for 0.7 s.
  void SetValues(std::vector<PanelValue> values);
  bool empty() const;

  /// When letters get another height [points], or colours change.
  void Prepare(int text_height, const ViewColors& colors);
  /// Of the panel [points], once prepared; 0 without controls.
  int width() const;

  /// Whether anything looks otherwise than it was drawn last.
  bool changed() const;
  /// Within a frame of the canvas that has the panel's mouse.
  void Draw(const PixelBox& box, const Canvas& canvas);
  const CanvasMouse& mouse() const;

  /// Mouse over the panel, or a drag that began there: by a frame that is not seen. `picture`: size
  /// of the whole [points].
  void Handle(const WindowEvent& event, const PixelBox& box, Canvas& canvas, glm::ivec2 picture,
              double now);
  /// The focus of the keyboard goes `by` controls on, over both ends.
  void MoveFocus(int by);
  void DropFocus();
  bool has_focus() const;
  /// The focused slider or choice goes `by` steps on.
  void ChangeFocused(int by, double now);
  /// The focused button is pressed; a choice takes its next.
  void PressFocused(double now);
  /// Whether there is a button that says this.
  bool Has(std::string_view word) const;

  /// What was said since; a slider that is dragged says a line at most every 100 ms, and one when
  /// it is let go.
  std::optional<std::string> NextLine(double now);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
