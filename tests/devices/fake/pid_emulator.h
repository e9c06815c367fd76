#pragma once

#include <memory>

#include "tests/devices/fake/emulator.h"

namespace moontrace::fake {

/// How the two emulated joysticks differ: kBits has the reports of OpenFFBoard (device control as
/// bits, two directions in 0.01 degree); kArray those of VPforce Rhino as far as they are known
/// (other numbers, control as a number, a direction of one byte).
enum class PidVariant { kBits, kArray };

/// A force-feedback joystick with two motors. Full magnitude is kPidFullForce; the stick's ends are
/// kPidReach from its middle.
std::unique_ptr<Emulator> MakePidEmulator(PidVariant variant);

inline constexpr double kPidFullForce = 10;  ///< [N]
inline constexpr double kPidReach = 0.07;    ///< [m]

}  // namespace moontrace::fake
