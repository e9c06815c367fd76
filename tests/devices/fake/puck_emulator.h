#pragma once

#include <memory>

#include "tests/devices/fake/emulator.h"

namespace moontrace::fake {

/// A six-axis puck: three numbered reports every 10 ms while it is deflected, then a last one of
/// rest, then silence. A hand deflects it fully to the right for a second, holds button 0 at
/// rest for five seconds, pulls the puck halfway towards the person for a second, and rests; so
/// again and again.
std::unique_ptr<Emulator> MakePuckEmulator();

}  // namespace moontrace::fake
