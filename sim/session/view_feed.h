#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "devices/core/mailbox.h"
#include "devices/hand/aimed_stylus.h"
#include "sim/console/console.h"
#include "sim/session/felt_page.h"
#include "sim/session/loop_poll.h"
#include "sim/session/view_options.h"
#include "sim/trial/metrics_json.h"
#include "sim/view/viewer.h"

namespace moontrace {

/// The view of what a command runs: is given pages, instants, the panel and what is said, and gives
/// lines that were said in its window. Once it has failed or was closed it takes everything and
/// does nothing. All calls from one thread.
class ViewFeed {
 public:
  /// None: no view was asked for, or there is no display, which is said. `aims`: the mouse moves
  /// the tip; then, and for frames, what is missing is thrown. Throws LackError, InputError,
  /// UsageError.
  static std::unique_ptr<ViewFeed> Open(const ViewOptions& options,
                                        const std::shared_ptr<Mailbox<StylusAim>>& aims,
                                        Console& console);
  /// Of a trial or a replay, whose time is its own: frames are drawn by DrawFrame.
  static std::unique_ptr<ViewFeed> OpenOfTrial(const ViewOptions& options, Console& console);
  explicit ViewFeed(const ViewerOptions& options) : viewer_(options), frames_(options.frames) {}

  /// The page that is felt, if it is another than it was, and its newest instant.
  /// `print`: with the letters in print beneath, which would tell what is asked.
  void Look(const FeltPage& page, const LoopPoll& poll, bool print = true);
  /// An instant between; in order of time, before the newest.
  void Add(const LoopSample& sample);

  /// From now on this model is shown; none: pages. Throws InputError as Viewer.
  void ShowModel(std::shared_ptr<const ViewModel> model) {
    model_ = model != nullptr;
    if (model_) viewer_.ShowModel(std::move(model));
  }
  void Show(std::shared_ptr<const ViewPage> page) { viewer_.Show(std::move(page)); }
  void Add(const ViewMoment& moment) { viewer_.Add(moment); }
  /// Of a trial, without a window: see Viewer.
  void DrawFrame() { viewer_.DrawFrame(); }
  void SetPanel(std::vector<PanelControl> controls);
  void SetValues(std::vector<PanelValue> values);
  /// A line of the text face.
  void ShowLine(std::string_view line) { viewer_.ShowLine(line); }

  using Heard = std::function<void(const ViewLine& line)>;
  using Remarked = std::function<void(const std::string& sentence)>;
  /// Gives `obey` each line that was said in the window, then `remark` what the view has to say of
  /// itself, one sentence, once: why nothing is drawn any more, or not all of it.
  void Hear(const Heard& obey, const Remarked& remark);
  /// A word that concerns the view alone: done; what is answered.
  std::optional<std::string> Obey(std::string_view line) { return viewer_.Obey(line); }
  /// It draws into a window, not into frames.
  bool window() const { return frames_.empty(); }
  /// The window was closed by its user.
  bool closed() const { return viewer_.closed(); }
  /// Nothing is shown any more.
  bool ended() const { return closed() || failed(); }
  /// Nothing is drawn any more, and its user did not wish so.
  bool failed() const { return !viewer_.failure().empty(); }
  /// Ends it: how it kept up; all zero where no frame could be written.
  ViewerReport Finish();

 private:
  std::string TakeNotice();

  Viewer viewer_;
  std::string frames_;                  ///< their folder; empty: into a window
  bool model_ = false;                  ///< is shown
  std::optional<std::uint64_t> shown_;  ///< FeltPage::shown
  bool print_ = true;                   ///< of the page that is shown
  std::vector<PanelValue> values_;
  bool failed_ = false;
};

/// What the mouse moves, if it is the device. Throws UsageError: there will be no window.
std::shared_ptr<Mailbox<StylusAim>> AimsFor(const std::string& device, const ViewOptions& options);

/// Behind it all: throws LackError if it stopped drawing what it was asked for, frames, or took the
/// mouse that moved the tip with it.
void RequireView(const ViewFeed& feed, const std::string& device);

/// Ends a view: how it kept up.
Json ViewJson(ViewFeed& feed);
/// Ends a view. The outcome of a view in words: where its frames are, how it kept up.
void SayView(ViewFeed& feed, const ViewOptions& options, Console& console);
/// Likewise for learners: not how it kept up.
void EndView(ViewFeed& feed, const ViewOptions& options, Console& console);

std::shared_ptr<const ViewPage> ViewPageOf(const FeltPage& page);
ViewMoment MomentOf(const LoopSnapshot& snapshot);
ViewMoment MomentOf(const LoopSample& sample);

}  // namespace moontrace
