#pragma once

#include <memory>

#include "tests/devices/fake/emulator.h"

namespace moontrace::fake {

/// A six-axis puck: three numbered reports every 10 ms while it is deflected, then a last one of
/// rest, then silence. A hand deflects it fully to the right for a second, rests for a second,
/// pulls it halfway towards the person for a second, and rests; so again and again. Button 0 is
/// held in the second second.
std::unique_ptr<Emulator> MakePuckEmulator();

}  // namespace moontrace::fake
