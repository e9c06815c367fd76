#pragma once

#include <string>

#include "sim/wording/console.h"

namespace moontrace {

/// The device of a lesson: `named`, else the first that is there, can be opened and has motors.
/// Where there is none, says so first, then what works without; then throws LackError.
std::string DeviceForLearning(const std::string& named, Console& console);

}  // namespace moontrace
