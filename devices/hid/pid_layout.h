#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "devices/core/profile.h"
#include "devices/hid/hid_bits.h"
#include "devices/hid/hid_descriptor.h"

namespace moontrace {

/// Usages of the physical-interface page (USB Device Class Definition for PID 1.0) that we use.
namespace pid {
inline constexpr HidUsage kPage = 0x0f0000;
inline constexpr HidUsage kConstantForce = kPage | 0x26;
inline constexpr HidUsage kStart = kPage | 0x79, kStop = kPage | 0x7b;
inline constexpr HidUsage kLoadSuccess = kPage | 0x8c, kLoadFull = kPage | 0x8d,
                          kLoadError = kPage | 0x8e;
inline constexpr HidUsage kEnable = kPage | 0x97, kDisable = kPage | 0x98, kStopAll = kPage | 0x99,
                          kReset = kPage | 0x9a;
}  // namespace pid

/// A choice among usages in the device's encoding: by a number (array) or by one bit for each.
struct HidChoice {
  struct Option {
    HidUsage usage = 0;
    HidBits bits;            ///< array: of the number; else the option's own bit
    std::int64_t value = 1;  ///< that `bits` has when the usage is chosen
  };
  std::vector<Option> options;

  bool Offers(HidUsage usage) const noexcept;
  /// Writes the choice; nothing if it is not offered.
  void Choose(std::span<std::uint8_t> report, HidUsage usage) const noexcept;
  bool IsChosen(std::span<const std::uint8_t> report, HidUsage usage) const noexcept;
};

/// Number and length of a report; length 0: the device has none of its kind.
struct HidReportId {
  std::uint8_t id = 0;
  std::size_t bytes = 0;  ///< with byte 0

  bool IsThere() const noexcept { return bytes > 0; }
};

/// Where a PID device keeps what a constant force on each motor axis needs. Numbers and layouts are
/// each device's own; they are found by usage. Reports beyond the required ones may be missing.
struct PidLayout {
  struct {
    HidReportId report;
    HidBits block, duration, gain, direction_enable;
    HidChoice type;
    std::array<HidBits, 2> axis_enable, direction;
  } effect;
  struct {
    HidReportId report;
    HidBits block, magnitude;
  } constant;
  struct {
    HidReportId report;
    HidBits block, loops;
    HidChoice operation;
  } operation;
  struct {
    HidReportId report;
    HidBits block;
  } free;
  struct {
    HidReportId report;
    HidChoice command;
  } control;
  struct {
    HidReportId report;
    HidBits gain;
  } gain;
  struct {
    HidReportId report;
    HidChoice type;
  } create;  ///< feature
  struct {
    HidReportId report;
    HidBits block;
    HidChoice status;
  } load;  ///< feature
  struct {
    HidReportId report;
    HidBits paused, enabled, safety, power, playing, block;
  } state;                       ///< input
  std::array<bool, 2> motors{};  ///< on HID's X, Y
};

/// True if the device offers force feedback as PID at all.
bool SpeaksPid(const HidDescriptor& descriptor);

/// Throws DeviceError, one line that names every report or number that is missing, or says that the
/// device only rumbles.
PidLayout FindPidLayout(const HidDescriptor& descriptor);

/// A number of an input report.
struct HidNumber {
  HidReportId report;
  HidBits bits;

  bool IsThere() const noexcept { return report.IsThere(); }
};

/// Where a stick keeps its position and buttons.
struct StickLayout {
  HidNumber right, away, press;    ///< `press` only if the profile presses by an axis
  std::vector<HidNumber> buttons;  ///< in order, at most 32
};

/// Throws DeviceError: an axis that the profile names is not there.
StickLayout FindStick(const HidDescriptor& descriptor, const StickMap& map);

}  // namespace moontrace
