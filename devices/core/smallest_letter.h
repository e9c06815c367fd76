#pragma once

#include "devices/core/profile.h"

namespace moontrace {

/// Smallest letter from which on a device renders well [m], engraved in the default style; infinite
/// if it renders none, 0 if it gives no force along the page, so that nothing of it depends on the
/// size.
///
/// Assumptions: the tip is pressed on with `press` [N] and feels the page through a spring of the
/// stiffness K, the coupling's that the device gets (CouplingOf, profile.h). A flank of slope s
/// holds it sideways with at most F = min(press s, the device's peak force). With em = size, w the
/// width of the groove, D its depth, r = 0.2 w its rounding and s = D / (w/2 - r):
///
/// 1. It does not skip. When the flank gives way the hand is F/K beyond it, and there the tip
///    lands: at most 0.25 em on, half way to the nearest stroke. F/K <= 0.25 em.
/// 2. It feels slopes, not stairs. A flank, w/2 - r wide, spans at least five position steps.
/// 3. It holds the hand. One that drifts sideways by 6 % of its path (devices/hand.toml) over a
///    stroke of one em, with 200 N/m, pulls with 12 N/m em. 12 N/m em <= F.
///
/// 1 and 2 bound the size from below, 3 from above: a device whose force is too weak for the size
/// that its stiffness asks for renders none.
double SmallestLetter(const DeviceProfile& profile, double press = 1);

}  // namespace moontrace
