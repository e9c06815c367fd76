#pragma once

#include "devices/core/profile.h"

namespace moontrace {

/// Margin that CouplingOf leaves; ours.
inline constexpr double kLeastCouplingMargin = 1.5;

/// By how much a coupling's spring and damper may both be multiplied before hand and device that
/// lean on a proxy held fast begin to swing; infinite if they never do. It counts the damping of
/// hand and device, the period over which a force is held, the delay, the coupling's own damping,
/// and the lag of the tracker of readings in steps (tip_estimate.h), which is what it takes for
/// swings of a few steps; greater ones leave the tracker's band and are followed more closely.
/// `moving_mass` [kg] is that of hand and device at the tip.
///
/// In closed form: all of these are linear, so the factors at which a swing neither grows nor fades
/// follow from one period's response; see the source. `bench --stability` finds the same by
/// simulation.
double CouplingMargin(const DeviceProfile& profile, const CouplingGains& coupling,
                      double moving_mass);

}  // namespace moontrace
