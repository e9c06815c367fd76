#pragma once

#include <memory>

#include "tests/devices/fake/emulator.h"

namespace moontrace::fake {

/// kWooden: firmware of 2019, 8 bytes; kPolhem: mbed, 14 bytes; kTeensy: the same in 64 bytes.
enum class ArmVariant { kWooden, kPolhem, kTeensy };

/// An arm of the WoodenHaptics family with somebody who homes it: within 0.4 s of the first report
/// that it hears it is moved a little and put in its rest, held there for 1.2 s, moved up, right
/// and towards the person, and taken to the middle of the workspace by kArmIsHomed, where it
/// swings.
std::unique_ptr<Emulator> MakeArmEmulator(ArmVariant variant);

inline constexpr double kArmIsHomed = 2.3;  ///< [s] after the first report that it hears

}  // namespace moontrace::fake
