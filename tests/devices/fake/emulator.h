#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace moontrace::fake {

using Bytes = std::span<const std::uint8_t>;

/// What a device says of itself when it is plugged in.
struct Identity {
  std::uint16_t vendor = 0, product = 0;
  std::string maker, name, serial;
  std::vector<std::pair<std::uint16_t, std::uint16_t>> usages;  ///< page and usage, top level
  std::vector<std::uint8_t> descriptor;                         ///< its report descriptor
};

/// A HID device in software, hand and all: it serves the fake hidapi (fake_hidapi.cpp) and, in a
/// virtual machine, the kernel's uhid (tests/vm/uhid_device.cpp). Calls come one at a time. Times
/// are seconds since it was plugged in, ascending.
class Emulator {
 public:
  using Send = std::function<void(Bytes)>;  ///< an input report as the host reads it

  virtual ~Emulator() = default;
  virtual Identity Describe() const = 0;
  /// Motion up to `time`; sends the reports that fall due. Called every millisecond or so, but also
  /// after gaps.
  virtual void Advance(double time, const Send& send) = 0;
  /// The host has opened it, and nothing else had it open: who must home it does so again.
  virtual void Open() {}
  /// The host wrote `report`; byte 0 is its number, 0 if the device does not number reports.
  virtual void Output(Bytes report, double time, const Send& send) = 0;
  /// False: the device refuses.
  virtual bool SetFeature(Bytes report) = 0;
  /// Byte 0 of `report` is the number asked for. Returns the bytes of the answer with it, or -1.
  virtual int GetFeature(std::span<std::uint8_t> report) = 0;

  /// What its motors give now in the frame D of its kind [N].
  virtual glm::dvec3 Force() const = 0;
  /// Fault jump20: the measured position is `way` [m] aside from now on, in each axis.
  virtual void Jump(double way) = 0;
  /// Fault disabled: its motors are switched off, by a safety switch say.
  virtual void Disable() = 0;
};

/// A hand that holds a tip of 0.1 kg by 200 N/m and 3 N s/m (devices/hand.toml) and swings its aim
/// along x: 30 mm to either side in 4 s, in y 10 mm in 3 s. Shared by the emulators.
class SwingingHand {
 public:
  /// Up to `time` [s] with the force of the motors [N].
  void Advance(double time, glm::dvec3 force);
  glm::dvec3 p() const { return p_; }  ///< of the tip [m]

 private:
  double time_ = 0;
  glm::dvec3 p_{0, 0, 0}, v_{0, 0, 0};
};

/// A kind by its name in MOONTRACE_FAKE_HID; null if there is none. Kinds are listed in
/// emulator.cpp.
std::unique_ptr<Emulator> MakeEmulator(std::string_view kind);

}  // namespace moontrace::fake
