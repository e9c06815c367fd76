#pragma once

#include <memory>
#include <string>

#include "devices/core/device.h"
#include "devices/core/profile.h"
#include "devices/hid/hid_port.h"
#include "devices/hid/raw_protocol.h"

namespace moontrace {

/// Whether a listed device says by its usage that it speaks raw_protocol.md; its ids do not matter.
bool OffersRawProtocol(const HidInfo& info);

/// Asks the device at `path` what it is. Blocks up to seconds. Throws DeviceError: it cannot be
/// opened, does not answer, or tells figures that the protocol forbids.
RawHello ReadRawHello(const std::string& path);

/// What the device tells of itself goes before its profile; the lesser peak force counts.
DeviceProfile WithHello(DeviceProfile profile, const RawHello& hello);

/// Opens a device that speaks raw_protocol.md; limits for ticks of `tick` [s]. Throws as
/// ReadRawHello. A wrong report, or writes that wait longer than a quarter of a second, and it is
/// lost; a report whose sequence did not advance is no new data.
std::unique_ptr<Device> MakeRawDevice(const HidInfo& info, const DeviceProfile& profile,
                                      double tick);

}  // namespace moontrace
