#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/view/panel.h"
#include "sim/view/view_look.h"
#include "sim/view/window_event.h"

struct mjrContext_;

namespace moontrace {

/// The tutor's panel by MuJoCo's own controls. What its controls are given they say as lines; what
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

  /// After every new OpenGL context, and when colours change. Letters have the context's size.
  void Prepare(mjrContext_& context, const ViewColors& colors);
  /// Of the panel [points], once prepared; 0 without controls.
  int width() const;

  /// Whether anything looks otherwise than it was drawn last.
  bool changed() const;
  void Draw(const PixelBox& box, const mjrContext_& context);

  /// Mouse over the panel, or a drag that began there.
  void Handle(const WindowEvent& event, const PixelBox& box, const mjrContext_& context,
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
