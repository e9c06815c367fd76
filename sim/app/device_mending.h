#pragma once

#include "devices/catalogue/catalogue.h"
#include "sim/console/console.h"

namespace moontrace {

/// How to give the permission to open a device, where that is what it lacks.
void SayMending(const DeviceEntry& entry, Console& console);

}  // namespace moontrace
