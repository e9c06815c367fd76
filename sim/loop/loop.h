#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "lessons/guide/guidance.h"
#include "sim/loop/clock.h"
#include "sim/loop/histogram.h"
#include "sim/loop/loop_mail.h"
#include "sim/loop/loop_tick.h"
#include "sim/loop/loop_types.h"
#include "sim/loop/realtime.h"
#include "sim/physics/scene.h"

namespace moontrace {

/// Opens the device again after it was lost. Throws DeviceError while it is not there. Called by a
/// thread of the loop that is not the tick's; may block, but not long once `ending` is true.
using DeviceSource = std::function<std::unique_ptr<Device>(const std::atomic<bool>& ending)>;

/// Starts a thread of the loop. Throws std::system_error where the system gives none.
using ThreadStart = std::thread (*)(std::function<void()> run);
inline std::thread StartThread(std::function<void()> run) { return std::thread(std::move(run)); }

/// How a loop has run. Durations in microseconds.
struct LoopReport {
  std::uint64_t ticks = 0;
  std::uint64_t lost_ticks = 0;  ///< periods without a tick: a late tick skips what it missed
  Histogram lateness;            ///< of each tick, after its deadline
  Histogram cost;                ///< from a tick's begin to its end
  std::uint64_t late_loops = 0;  ///< silences that the watchdog saw
  std::uint64_t samples_dropped = 0, events_dropped = 0;
  std::array<std::uint64_t, kSafetyEvents> safety_counts{};
};

/// Detects a loop that falls silent: `Beat` by the loop each tick, `Look` by another thread each
/// millisecond. It holds no device and gives no force. The loop learns at its next beat that it was
/// silent, and begins again from zero force with a ramp-in; any thread may report the silence.
///
/// Why that is enough: only the loop's thread may talk to a device, so a loop that hangs cannot be
/// made to write zero by anyone else. What lets go then lies nearer to the motors: the I/O threads
/// of devices/ send zero when no tick has spoken to them, and the device's own dead-man stands
/// behind those.
class Watchdog {
 public:
  /// `silence` [ns]: a longer pause between ticks counts as silence.
  explicit Watchdog(std::int64_t silence) noexcept : silence_(silence) {}

  /// The loop's thread, at the start of a tick. True if the loop was silent since the last beat, by
  /// its own clock or as the watching thread saw it.
  bool Beat(std::int64_t now) noexcept {
    const std::int64_t last = last_.exchange(now, std::memory_order_relaxed);
    const bool seen = silent_.exchange(false, std::memory_order_relaxed);
    return seen || (last != 0 && now - last > silence_);
  }
  /// The watching thread: true once for each silence, when it has lasted too long.
  bool Look(std::int64_t now) noexcept {
    const std::int64_t last = last_.load(std::memory_order_relaxed);
    if (last == 0 || now - last <= silence_) return false;
    return !silent_.exchange(true, std::memory_order_relaxed);
  }
  /// Any thread: whether the loop is silent now, as the watching thread saw it.
  bool silent() const noexcept { return silent_.load(std::memory_order_relaxed); }

 private:
  std::int64_t silence_ = 0;
  std::atomic<std::int64_t> last_{0};  ///< beat [ns]; 0 before the first
  std::atomic<bool> silent_{false};
};

/// The haptic loop: owns scene, device and the thread that ticks at an even rate, with two more
/// beside it: one watches for silence, one opens a lost device again every 0.5 s. Ends with zero
/// force.
class Loop {
 public:
  /// Starts ticking. `scene`'s tick is 1 / options.rate. `field` may be looked at elsewhere too.
  /// Throws as Scene::SetField, and LackError where a thread cannot be started: then the device has
  /// been given zero force.
  Loop(Scene scene, std::shared_ptr<const TextureField> field, std::unique_ptr<Device> device,
       DeviceSource source, const DevicePlace& place, const LoopOptions& options,
       ThreadStart start = StartThread);
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// Zero force at once, until GoOn. Any thread.
  void Stop() noexcept { mail_.stop.store(true, std::memory_order_relaxed); }
  void GoOn() noexcept { mail_.go_on.store(true, std::memory_order_relaxed); }

  /// Lets another page be felt: the force fades to zero, the pages are swapped, the force ramps in,
  /// all within 0.3 s. Returns once the old page is out of use (it is let go of here, never by the
  /// tick) or the loop has ended. One thread at a time. Throws as Scene::SetField; then all stays
  /// as it is.
  void ChangePage(PageChange change);

  /// The guiding push from now on, on the page that is felt now: computed each tick from the tip,
  /// added before the safety stage, beginning anew with a ramp-in; nullptr: none. Stiffness and cap
  /// are held to what the device renders (device_feel.h). Nothing is pushed while the loop is
  /// stopped, and none after a page change until the next call. Returns once the tick has let go of
  /// the plan before (which is freed here) or the loop has ended. The thread of ChangePage.
  void Guide(std::shared_ptr<const GuidancePlan> plan);

  /// The newest tick, if there was one since the last call. One thread at a time: a viewer's. The
  /// loop never waits for it.
  bool TakeSnapshot(LoopSnapshot& snapshot) noexcept { return mail_.snapshot.Take(snapshot); }
  /// Where everything in the scene stands, if it has come since the last call, which asked for it:
  /// of a tick between the two. One thread at a time: a viewer's. The loop never waits for it.
  bool TakePose(ScenePose& pose) { return mail_.pose.Take(pose); }
  /// The next event, the next sample. One thread at a time each.
  bool TakeEvent(LoopEvent& event) noexcept { return mail_.events.Pop(event); }
  bool TakeSample(LoopSample& sample) noexcept { return mail_.samples.Pop(sample); }

  /// Empty if the loop has real-time priority and locked memory, else why not, one sentence.
  const std::string& not_realtime() const { return not_realtime_; }
  /// The worst lateness of a tick since the last call [us]. One thread at a time: a viewer's.
  double TakeLateness() noexcept { return lateness_.exchange(0, std::memory_order_relaxed); }
  /// No tick for longer than the watchdog allows, now. Any thread.
  bool silent() const noexcept { return watchdog_.silent(); }
  /// The device is gone and not yet opened again. Any thread.
  bool lost() const noexcept { return lost_.load(std::memory_order_relaxed); }
  /// Why a lost device could not be opened again at the last try; empty if it was, or if none has
  /// ended yet. Any thread.
  std::string WhyLost() const;
  /// Device::WhyLost of the one that was lost last. Any thread but the tick's: waits up to 1.5 s
  /// for the device's answer.
  std::string WhyGone();

  /// Gives zero force and ends the threads; then the report is final. A second call does nothing.
  void End();
  const LoopReport& report() const { return report_; }

 private:
  void Start(ThreadStart start);
  void TickOn();
  void Watch();
  void Supervise();
  void Reopen();
  std::unique_ptr<Device> TakeDetached();
  bool SleepUnlessEnding(int milliseconds);

  LoopOptions options_;
  LoopMail mail_;
  double scale_ = 1;  ///< DevicePlace::scale
  Watchdog watchdog_;
  MemoryLock memory_lock_;
  /// In use: the tick has the bare pointer, so that it never counts who shares it.
  std::shared_ptr<const TextureField> field_;
  std::shared_ptr<const GuidancePlan> plan_;  ///< in use
  LoopTick tick_;
  DeviceSource source_;
  SteadyClock clock_;
  std::string not_realtime_;
  LoopReport report_;
  std::atomic<bool> ticking_{false};  ///< the ticking thread is running
  std::atomic<bool> ending_{false};
  std::atomic<bool> lost_{false};  ///< see lost
  std::atomic<std::uint64_t> late_loops_{0};
  std::atomic<double> lateness_{0};  ///< see TakeLateness [us]
  mutable std::mutex mutex_;         ///< never taken by the tick: for the two threads beside it
  std::condition_variable wake_;
  std::condition_variable answered_;
  std::string why_lost_, why_gone_;
  bool asking_ = false;  ///< a lost device is being asked WhyLost
  std::thread ticker_, watcher_, supervisor_;
};

}  // namespace moontrace
