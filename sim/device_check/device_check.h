#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "devices/core/device.h"
#include "sim/console/console.h"
#include "sim/loop/clock.h"

namespace moontrace {

/// How long the parts of a check take, and how strongly it pushes.
struct CheckPlan {
  double look = 5;      ///< moving and pressing buttons [s]
  double count = 1;     ///< between two numbers of a countdown [s]
  double push = 1;      ///< each push [s]
  double force = 0.5;   ///< the greatest on an axis [N]
  double home = 120;    ///< the longest that homing may take [s]
  double settle = 0.5;  ///< beyond the dead-man's time, before somebody is asked [s]
};

enum class StepResult { kGood, kFailed, kLeftOut };

struct CheckStep {
  std::string name;
  StepResult result = StepResult::kLeftOut;
};

/// What is checked.
struct CheckedDevice {
  std::string name, title;
  bool rests_silent = false;  ///< a puck: it reports motion only
  /// Opens it; called anew for the dead-man, in a second process. Throws DeviceError.
  std::function<std::unique_ptr<Device>()> open;
};

/// Tries a device step by step: homing where it is needed, position and buttons,
/// small forces along each axis, what the safety stage lets through, and that it lets go when this
/// program is killed. Lines and questions go to `tell`, answers come from the console. A missing
/// answer leaves the step's forces out. Throws DeviceError if it cannot be opened and Interrupted;
/// the device has zero force then.
std::vector<CheckStep> CheckDevice(const CheckedDevice& checked, const CheckPlan& plan,
                                   Clock& clock,
                                   const std::function<void(const std::string&)>& tell,
                                   Console& console);

}  // namespace moontrace
