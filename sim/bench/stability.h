#pragma once

#include "devices/core/profile.h"
#include "devices/hand/hand.h"
#include "sim/bench/sampled_device.h"

namespace moontrace {

/// The closed-form limit of a wall's stiffness [N/m]: 2 b / (T + 2 t), T the period over which a
/// force is held and t the delay before it acts [s], b the damping that is there [N s/m]. A held
/// force is T/2 late on average and the delay adds to that; a spring K that acts tau late takes
/// K tau from the damping. (b > K T/2 of Colgate and Schenkel 1994, with the delay.)
double WallLimit(double damping, double period, double delay);

/// The greatest stiffness of a wall that the model holds quiet [N/m], by simulation and bisection
/// to 0.01 percent: the tip, put off its place in the wall, must come back to it. Readings are
/// taken without steps.
double GreatestStableWall(SampledModel model);

/// CouplingMargin (devices/core/coupling_margin.h) by simulation and bisection, to 0.01 percent: a
/// tip that is put off its place, by so little that the tracker stays within its band, must come
/// back. Readings are taken without steps, but tracked as if they had the model's.
double SimulatedCouplingMargin(const SampledModel& model, const CouplingGains& coupling);

/// How far the tip still moves [m] 2.7 s after it was put down in a groove of 12 mm letters at
/// SceneFor(profile), pressed down by 1 N and leaning on a flank with the hand's spring.
double StirInGroove(const DeviceProfile& profile, const HandModel& hand);

/// What a device and its rendering put out over a random path of the hand.
struct EnergyOut {
  double net = 0;    ///< greatest energy given between two moments, less what damping took [J]
  double bound = 0;  ///< what it stays below [J]
  double taken = 0;  ///< by the damping, over the whole path [J]
};
/// Moves the tip for `seconds` over, into and out of the groove, by sums of sines of 0.3 to 8 Hz
/// drawn by `seed`. `stiffness` of the coupling [N/m]. See the source for the bound.
EnergyOut EnergyOverRandomMotion(const DeviceProfile& profile, const HandModel& hand,
                                 double stiffness, double seconds, unsigned seed);

}  // namespace moontrace
