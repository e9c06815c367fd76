#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sim/physics/label_place.h"
#include "sim/physics/scene_push.h"
#include "sim/session/view_feed.h"
#include "sim/session/view_panels.h"

namespace moontrace {

/// Shows a trial or a replay, which would run faster than can be seen: in a window it is held to
/// real time while it is looked at; when that is closed the rest runs as fast as it can. Without a
/// window frame k of a page is drawn at its first tick from k / kFramesPerSecond on, however long
/// that takes: the same trial gives the same frames, to the byte.
class TrialView {
 public:
  /// `panel`: TrialPanel or ReadingPanel.
  TrialView(ViewFeed& feed, Console& console, std::vector<PanelControl> panel = TrialPanel());

  /// The trials from now on are on labels of a model, which is shown; `others` as they were given.
  void ShowModel(std::vector<LaidLabel> others);
  /// Completes what the panel shows, whenever that is shown.
  using Complete = std::function<void(TrialTexts& texts)>;
  /// Another page; its time begins at 0.
  void Begin(std::shared_ptr<const ViewPage> page, TrialTexts texts, Complete complete = {});
  /// A tick, see TickWatch.
  void Look(double time, const TickResult& felt, const GuidanceResult& push, const Scene& scene);

 private:
  void DrawFrame(double time);
  void KeepTime(double time);
  void ShowTime(double time);
  void Hear();
  void Obey(const std::string& line);

  ViewFeed& feed_;
  Console& console_;
  std::uint32_t page_ = 0;
  TrialTexts texts_;
  Complete complete_;
  std::optional<std::vector<LaidLabel>> others_;  ///< none: pages are shown
  bool model_shown_ = false;                      ///< as it is in this trial
  std::chrono::steady_clock::time_point begin_;
  double shown_ = 0, looked_ = 0;  ///< when last [s]
  std::size_t frames_ = 0;         ///< of this page, drawn
  bool over_ = false;
};

/// What a trial's tick shows.
ViewMoment MomentOf(double time, const TickResult& felt, const GuidanceResult& push);

}  // namespace moontrace
