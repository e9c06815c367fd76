#pragma once

#include <memory>

#include "tests/devices/fake/emulator.h"

namespace moontrace::fake {

/// The reference for those who build a device: it follows devices/raw_protocol.md byte by byte, on
/// its own, as firmware would.
std::unique_ptr<Emulator> MakeRawEmulator();

}  // namespace moontrace::fake
