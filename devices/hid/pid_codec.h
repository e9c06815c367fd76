#pragma once

#include <cstdint>
#include <span>

#include "devices/hid/hid_link.h"
#include "devices/hid/pid_layout.h"

namespace moontrace {

/// Bytes of PID reports, pure. Every report fits into HidReport or FindPidLayout's caller refuses
/// the device (PidReportsFit).

bool PidReportsFit(const PidLayout& layout) noexcept;

/// A constant force along one axis (0: HID's X, 1: Y) that ends by itself after `duration` [s], as
/// strong as the device allows. By its fixed direction a positive magnitude raises the axis's
/// value.
HidReport EncodeSetEffect(const PidLayout& layout, int block, int axis, double duration) noexcept;
/// `share` of the greatest magnitude, -1 to 1; NaN counts as 0.
HidReport EncodeConstantForce(const PidLayout& layout, int block, double share) noexcept;
/// pid::kStart or pid::kStop.
HidReport EncodeOperation(const PidLayout& layout, int block, HidUsage operation) noexcept;
HidReport EncodeBlockFree(const PidLayout& layout, int block) noexcept;
/// pid::kEnable, kDisable, kStopAll or kReset.
HidReport EncodeControl(const PidLayout& layout, HidUsage command) noexcept;
/// Sets full gain, which the profiles assume.
HidReport EncodeDeviceGain(const PidLayout& layout) noexcept;
/// Feature: asks for a block for a constant force.
HidReport EncodeCreateEffect(const PidLayout& layout) noexcept;

/// Answer to EncodeCreateEffect.
struct PidBlockLoad {
  enum class Status { kPending, kSuccess, kFull, kError } status = Status::kPending;
  int block = 0;
};
PidBlockLoad DecodeBlockLoad(const PidLayout& layout,
                             std::span<const std::uint8_t> report) noexcept;

/// A state report. What a device does not report is taken to be in order.
struct PidState {
  bool is_paused = false, is_enabled = true, has_power = true;
  bool safety = false;  ///< the standard does not say which value is the safe one
  bool is_playing = false;
  int block = 0;  ///< that `is_playing` is about; 0: not reported
};
PidState DecodeState(const PidLayout& layout, std::span<const std::uint8_t> report) noexcept;

/// Where a number stands in its range, -1 at its least and 1 at its most.
double ShareOf(std::span<const std::uint8_t> report, const HidBits& bits) noexcept;

}  // namespace moontrace
