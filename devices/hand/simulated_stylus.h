#pragma once

#include <cstdint>
#include <memory>

#include "devices/core/device.h"
#include "devices/hand/hand.h"

namespace moontrace {

/// The stylus in a simulated hand, a device like any other. Same model, path, seed and forces: same
/// bytes. Reports no velocity, as encoders do not.
///
/// Time: the n-th Read (from 0) gives the tip's position at n * tick; at the first the tip rests at
/// the path's first point. The last force written after Read n acts from (n + late_ticks) * tick
/// for one whole tick; before the first arrives none acts. Motion over a tick is exact for that
/// force and an aim that moves evenly within the tick. A force that is not finite counts as zero.
///
/// The hand: across the press direction a spring and a damper tie the tip to the aim (path + tremor
/// + drift). Along it, where the path's press is zero, likewise; while it presses, only the press
/// and the damping act. When press ends the hand holds the height it is at and finds back to the
/// path's within some 1 / (natural frequency), as the drift fades. Read beyond the path's end keeps
/// the last aim, unless the path repeats.
///
/// Throws std::invalid_argument: a path that is empty, not finite, not ascending in time or without
/// a unit press direction, a hand without mass or spring, a tick that is not above zero.
std::unique_ptr<Device> MakeSimulatedStylus(const HandModel& hand, HandPath path, double tick,
                                            std::uint64_t seed);

}  // namespace moontrace
