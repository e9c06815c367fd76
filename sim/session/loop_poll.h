#pragma once

#include <array>
#include <string>

#include "sim/loop/loop.h"
#include "sim/session/live_device.h"

namespace moontrace {

/// Receives what a loop has left. At each look, in this order: what happened, what there is to
/// say, how it stands, what was felt.
class LoopListener {
 public:
  virtual ~LoopListener() = default;
  /// `sentence`: the event in words; empty: it has none.
  virtual void Happened(const LoopEvent& event, const std::string& sentence) = 0;
  /// Of the loop and the opening of a lost device; `urgent`: it takes the force away.
  virtual void Reported(const std::string& sentence, bool urgent) = 0;
  /// The newest tick.
  virtual void Stands(const LoopSnapshot& newest) = 0;
  /// Every tick, in order of time.
  virtual void Felt(const LoopSample& sample) = 0;
};

/// Motors that go off and on, as under load, are told of once until force is there again. Times of
/// the loop [s].
class MotorsTold {
 public:
  /// They went off: whether to say so.
  bool WentOff(double time);
  /// The newest commanded force [N]: whether to say that it is back.
  bool IsBack(double time, double force);
  /// What is said of a lost device stands for it.
  void Lost() { off_ = false; }

 private:
  bool off_ = false;
  double since_ = 0;  ///< they went off last
};

/// Looks at a loop at the rate of polling, off the tick: the one reader of what it leaves. One
/// thread.
class LoopPoll {
 public:
  /// Both must outlive this.
  LoopPoll(Loop& loop, LiveDevice& device) : loop_(loop), device_(device) {}

  /// Tells what has happened since the last look. May wait for a lost device's answer
  /// (Loop::WhyGone).
  void Look(LoopListener& listener);
  /// See Loop.
  bool TakePose(ScenePose& pose) const { return loop_.TakePose(pose); }
  /// As of the last look.
  const LoopSnapshot& newest() const { return newest_; }
  /// What was said once and happened again since, with its counts, as of the last look; empty:
  /// nothing.
  std::string Repeated() const;
  /// The worst between the last two looks [us].
  double lateness_us() const { return lateness_us_; }

 private:
  std::string Sentence(const LoopEvent& event);

  Loop& loop_;
  LiveDevice& device_;
  LoopSnapshot newest_;
  double lateness_us_ = 0;
  bool silent_ = false;                     ///< has stood still, and will not be told again
  std::array<bool, kSafetyEvents> said_{};  ///< will not be said again
  MotorsTold motors_;
  std::string why_lost_;
};

}  // namespace moontrace
