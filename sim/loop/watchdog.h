#pragma once

#include <atomic>
#include <cstdint>

namespace moontrace {

/// Sees a loop that falls silent: `Beat` by the loop each tick, `Look` by another thread each
/// millisecond. It holds no device and gives no force; what it notices it leaves for the loop,
/// whose next tick begins again from zero force with a ramp-in, and for whoever tells the learner.
///
/// Why that is enough: only the loop's thread may talk to a device, so a loop that hangs cannot be
/// made to write zero by anyone else. What lets go then is nearer to the motors: the I/O threads
/// of devices/ send zero when no tick has spoken to them, and the device's own dead-man stands
/// behind those.
class Watchdog {
 public:
  /// `silence` [ns]: the longest pause between ticks that is none.
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

}  // namespace moontrace
