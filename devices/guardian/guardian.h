#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "devices/guardian/guardian_wire.h"
#include "devices/helper/helper_process.h"

namespace moontrace {

/// A device as its guardian knows it. Each report with its number in byte 0.
struct GuardedDevice {
  std::string path;                                 ///< that HidHandle opens
  std::string name;                                 ///< for people
  std::vector<std::vector<std::uint8_t>> release;   ///< commands zero force
  std::vector<std::vector<std::uint8_t>> farewell;  ///< after it, once the program has died
};

/// A process of its own that holds a device open too. When the thread that writes to the device has
/// ended without End, in whatever way its process died, or its process takes a fault, the guardian
/// commands zero at once; when it has given no sign of life for kLongestSilence while a force may
/// be on, the guardian commands zero, and again every 10 ms until there is one. Then it gives way:
/// the program's next force counts. It ends with the thread. Needs nothing of the device's own
/// dead-man.
class Guardian {
 public:
  /// Of the program before the guardian lets go [s].
  static constexpr double kLongestSilence = 0.02;

  /// Why none can be started here, a clause; empty if one can.
  static std::string WhyNone();
  /// Starts it and waits, at most 10 s, until it has opened the device. Throws DeviceError.
  explicit Guardian(const GuardedDevice& device);
  /// Waits until it has ended, at most 0.2 s, then kills it.
  ~Guardian();
  Guardian(const Guardian&) = delete;
  Guardian& operator=(const Guardian&) = delete;

  /// For the LifeNote of the thread that writes to the device.
  LifeWord& ProgramLife() noexcept { return shared_->program.life; }
  /// That thread: whether the program has taken a fault. Then it must write nothing more.
  bool IsDying() const noexcept { return LifeOf(shared_->program.life) == Life::kDying; }
  /// That thread: a fresh force came at `now`, steady clock [s].
  void Beat(double now) noexcept { shared_->program.beat.store(now, std::memory_order_relaxed); }
  /// That thread: whether what it has written may push. Before a push is written, after a zero.
  void SetPushes(bool pushes) noexcept {
    shared_->program.pushes.store(pushes ? 1 : 0, std::memory_order_release);
  }
  /// How often it has commanded zero. Any thread.
  std::uint64_t Releases() const noexcept {
    return shared_->guardian.releases.load(std::memory_order_acquire);
  }
  /// False once it has ended, which it must not do before the program. Any thread.
  bool IsAlive() const noexcept { return LifeOf(shared_->guardian.life) == Life::kLives; }

 private:
  void AwaitWatching(const std::string& name);

  SharedMemory memory_;
  guardian_wire::Shared* shared_;
  ::pid_t process_ = -1;
};

}  // namespace moontrace
