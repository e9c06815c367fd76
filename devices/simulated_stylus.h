#pragma once

#include <memory>

#include "devices/device.h"
#include "devices/hand.h"

namespace moontrace {

/// The stylus in a simulated hand, a device like any other: a force written at tick n acts, held
/// over one whole tick, `late_ticks` ticks later. Same model, path, seed and forces: same bytes.
/// Reports no velocity, as encoders do not. Read beyond the path's end keeps the last aim. While
/// pressing, the hand controls force along the press direction (damping, no stiffness) and position
/// across it; sideways drift grows with the length the aim has travelled since pressing began,
/// starts anew at each approach, and points across the direction of travel within the page.
std::unique_ptr<Device> MakeSimulatedStylus(const HandModel& hand, HandPath path, double tick,
                                            std::uint64_t seed);

}  // namespace moontrace
