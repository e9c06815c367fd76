#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace moontrace {

/// A report as it crosses the wire, with its number in byte 0 where the device numbers them.
struct HidReport {
  static constexpr std::size_t kMostBytes = 128;
  double time = 0;          ///< when it was read, steady clock [s]
  std::uint32_t count = 0;  ///< how many of its kind came before it
  std::uint16_t size = 0;   ///< as it arrived; what is beyond kMostBytes is cut off
  bool pushes = false;      ///< of an output: a force is on once the device has it
  std::array<std::uint8_t, kMostBytes> bytes{};
  std::span<const std::uint8_t> span() const noexcept;
};

/// How a link behaves; set by each kind of device.
struct HidLinkOptions {
  /// Numbers of the input reports that are kept, each in its own mailbox; empty: the device does
  /// not number its reports and every report goes into mailbox 0.
  std::vector<std::uint8_t> inputs;
  std::size_t outputs = 1;  ///< places of newest-value output reports
  /// An output that has not changed is sent again after this time, so that the device's dead-man
  /// does not let go [s]. 0: only changes are sent.
  double repeat_every = 0;
  /// Sent over and over at this period while the tick puts something (PID: effect operation start)
  /// [s].
  std::vector<HidReport> renewed;
  double renew_every = 0.015;
  /// Nothing is repeated or renewed once the tick has put nothing for this long [s], so that the
  /// device's own dead-man lets go of a program that hangs.
  double stale_after = 0.02;
  std::vector<HidReport> farewell;  ///< the last things sent when the link closes
  /// Command zero force and leave the device ready for the next. Not empty: the link has a Guardian
  /// (devices/guardian), which sends these when the program falls silent, and the farewell after
  /// them when it dies.
  std::vector<HidReport> release;
  std::string name;  ///< of the device, for what its guardian says
};

/// A HID device behind two I/O threads, one for each direction, each with a handle of its own. The
/// tick talks to mailboxes only. A device that pushes has a guardian, which lives as long as the
/// writing thread does.
class HidLink {
 public:
  /// Throws DeviceError if the device cannot be opened or its guardian cannot be started.
  HidLink(const std::string& path, HidLinkOptions options);
  /// Sends zeroes and farewells as far as the device takes them within 0.1 s, then closes. A device
  /// whose write never returns is left to a thread that owns all it needs.
  ~HidLink();

  /// The tick: the newest report of mailbox `input`, if one came since the last call.
  bool Take(std::size_t input, HidReport& report) noexcept;
  /// The tick: what output `place` holds from now on. Only the newest is sent. `pushes`: it is a
  /// force other than zero.
  void Put(std::size_t place, std::span<const std::uint8_t> report, bool pushes) noexcept;
  /// The tick: whether the guardian has commanded zero since the last call although the tick was
  /// not silent: forces were held up on their way. The force must then come back from zero.
  bool WasLetGo() noexcept;
  /// False once a read or write failed or the guardian has ended: the device is gone for good.
  bool IsAlive() const noexcept;
  /// A clause on why it is not alive, where more is known than that the device is gone.
  std::string WhyLost() const;
  /// Reports whose number is not among `inputs`: a device that sends them is faulty.
  std::uint32_t Strays() const noexcept;
  /// How long the present write has been blocked [s]; 0 if there is none. Grows when a device takes
  /// no more reports.
  double WaitingWrite() const noexcept;

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
  std::uint64_t releases_ = 0;  // the tick's: of the guardian, as last seen
  double put_at_ = -1;          // the tick's [s]
};

}  // namespace moontrace
