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
/// opened, does not answer, or reports figures that the protocol forbids.
RawHello ReadRawHello(const std::string& path);

/// The profile with the figures that the device reports itself; of the two peak forces the lower.
DeviceProfile WithHello(DeviceProfile profile, const RawHello& hello);

/// Opens a device that speaks raw_protocol.md; limits for ticks of `tick` [s]. Throws as
/// ReadRawHello. It is lost after a wrong report or a write that is blocked for 0.25 s; a report
/// whose sequence did not advance is no new data.
std::unique_ptr<Device> MakeRawDevice(const HidInfo& info, const DeviceProfile& profile,
                                      double tick);

}  // namespace moontrace
