#pragma once

#include <chrono>
#include <memory>

#include "sim/physics/scene_push.h"
#include "sim/session/view_feed.h"
#include "sim/session/view_panels.h"

namespace moontrace {

/// Shows a trial or a replay, which would run faster than can be seen: holds it to real time while
/// it is looked at. When its window is closed the rest runs as fast as it can.
class TrialView {
 public:
  TrialView(ViewFeed& feed, Console& console);

  /// Another page; its time begins at 0.
  void Begin(std::shared_ptr<const ViewPage> page, TrialTexts texts);
  /// A tick, see TickWatch.
  void Look(double time, const TickResult& felt, const GuidanceResult& push);

 private:
  void LookAtWindow();
  void Obey(const std::string& line);

  ViewFeed& feed_;
  Console& console_;
  std::uint32_t page_ = 0;
  TrialTexts texts_;
  std::chrono::steady_clock::time_point begin_;
  double shown_ = 0, looked_ = 0;  ///< when last [s]
  bool over_ = false;
};

/// What a trial's tick shows.
ViewMoment MomentOf(double time, const TickResult& felt, const GuidanceResult& push);

}  // namespace moontrace
