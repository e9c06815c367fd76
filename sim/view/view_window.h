#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/view/window_event.h"

namespace moontrace {

/// A window with an OpenGL context that is current for the thread that made it; all calls on that
/// thread, one window at a time in a program. The only file that sees GLFW.
class ViewWindow {
 public:
  /// `lost` is called on this thread if the display goes away, from within any call here or of
  /// OpenGL; the thread then stands still for ever, since Xlib would end the program next. It must
  /// not throw, and keep alive what others need. Throws LackError, one line: no display, no OpenGL,
  /// or built without.
  ViewWindow(const std::string& title, int width, int height, std::function<void()> lost);
  ~ViewWindow();
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /// What happened; waits for it at most so long [s].
  std::vector<WindowEvent> Events(double wait);
  bool closed() const;
  /// Not minimised and larger than nothing.
  bool shown() const;
  int width() const;   ///< of the picture [points]
  int height() const;  ///< [points]
  void SetTitle(const std::string& title);
  /// Shows what was drawn.
  void Swap();

  /// Throws LackError, as the constructor would: no display is named in the environment, or built
  /// without. That one is named does not mean that it answers. Any thread.
  static void RequireDisplayNamed();

  /// The display of a window went away in this program. The thread that stands still holds a lock
  /// of Xlib's, for which libraries wait when they are unloaded: such a program must end by
  /// std::_Exit, behind what is to be flushed. Any thread.
  static bool DisplayWasLost() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
