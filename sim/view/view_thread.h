#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/page_view/view_page.h"
#include "sim/view/panel.h"
#include "sim/view/view_painter.h"
#include "sim/view/view_words.h"
#include "sim/view/viewer_options.h"

namespace moontrace {

/// What the viewer's thread was given since it last looked.
struct ViewNews {
  std::shared_ptr<const ViewModel> model;
  std::shared_ptr<const ViewPage> page;
  std::deque<ViewMoment> moments;
  std::optional<std::vector<PanelControl>> controls;
  std::optional<std::vector<PanelValue>> values;
  std::vector<std::string> lines;  ///< lines of the text face
  std::vector<ViewWord> words;
  std::optional<ViewTarget> look_at;
  bool tell = false;  ///< what is seen
};

/// The newest 4096 times, for their median.
class TimeLog {
 public:
  void Add(double ms);
  double Median() const;  ///< [ms], 0 without any
  double slowest() const { return slowest_; }
  std::size_t count() const { return count_; }

 private:
  std::array<double, 4096> kept_{};
  std::size_t count_ = 0;
  double slowest_ = 0;
};

/// What passes between a viewer and its thread. `mutex` guards all of it and is never held while
/// OpenGL or the display is called.
struct ViewMailbox {
  std::mutex mutex;
  std::condition_variable changed;
  ViewNews news;
  bool stop = false;                 ///< the thread shall end
  std::size_t asked = 0, drawn = 0;  ///< frames, offline

  bool opened = false, closed = false, finished = false;
  std::exception_ptr refused;  ///< why it could not open
  std::string failure;
  std::deque<ViewLine> lines;       ///< said in the window
  std::deque<std::string> notices;  ///< what the view has to say of itself
  TimeLog frames, changes;
  std::vector<std::string> seen;  ///< of a model, when it was finished

  /// For the thread.
  ViewNews TakeNews();
  bool Stopped();
  void Fail(const std::string& why);
  void FrameDrawn();
  void Say(ViewLine line);
  void Notice(std::string sentence);
  /// For the viewer: the oldest of `lines` or `notices`.
  template <typename T>
  std::optional<T> TakeFrom(std::deque<T> ViewMailbox::*queue) {
    const std::lock_guard<std::mutex> lock(mutex);
    if ((this->*queue).empty()) return std::nullopt;
    T first = std::move((this->*queue).front());
    (this->*queue).pop_front();
    return first;
  }
};

/// What a viewer's thread does: opens a window, or OpenGL without a display, and draws until it is
/// stopped, the window is closed, or all frames are written. Tells the mailbox how it went; throws
/// nothing. If the display is lost it never returns.
void RunViewer(const ViewerOptions& options, const std::shared_ptr<ViewMailbox>& mailbox);

/// Gives the painter what has come.
void Deliver(ViewNews news, ViewPainter& painter);

/// How the view looks at first.
ViewLook LookOf(const ViewerOptions& options);

/// The path of a frame, from 1.
std::string FramePath(const std::string& folder, std::size_t number);

}  // namespace moontrace
