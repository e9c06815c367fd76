#pragma once

#include <memory>

#include "devices/core/device.h"
#include "devices/core/profile.h"
#include "devices/hid/hid_port.h"

namespace moontrace {

/// Whether the reports that a listed device describes have the size of the profile's generation:
/// arms of two generations share one id. False if its descriptor cannot be read.
bool FitsArm(const HidInfo& info, const DeviceProfile& profile);

/// Opens a WoodenHaptics or Polhem arm; limits for ticks of `tick` [s]. Throws DeviceError if it
/// cannot be opened. It must be homed (homing.h) and gives no force before. It is lost after a
/// report of another size or after angles that jump; after angles that no arm can have it must be
/// homed again.
std::unique_ptr<Device> MakeWoodenHaptics(const HidInfo& info, const DeviceProfile& profile,
                                          double tick);

}  // namespace moontrace
