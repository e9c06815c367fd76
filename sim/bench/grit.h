#pragma once

#include "devices/core/profile.h"
#include "devices/hand/hand.h"
#include "sim/bench/device_rig.h"

namespace moontrace {

/// How a hand goes about, for measuring grit. Its tip follows the aim by the hand's spring and
/// damper, no force stops it.
struct GritPath {
  double speed = 0;        ///< of the aim [m/s]
  double angle = 0;        ///< of its way against x [rad]: the axes go at different speeds
  double stroke_time = 0;  ///< after which it turns back at once [s]; 0: it never does
  bool on_paper = false;   ///< pressed onto flat paper with 1 N, else in free air
};

/// What steps of the readings are felt as: the sideways force less that of exact positions on the
/// same way, on the same device.
struct Grit {
  double rms = 0;   ///< [N]
  double peak = 0;  ///< [N]
};

/// What a hand may be given by the steps at most. Ours: the rms is a tenth of a light flank's half
/// newton, about what is noticed of forces of texture (6 to 10 percent, doi 10.5772/50533).
inline constexpr Grit kGreatestGrit{0.05, 0.12};

/// Grit of a profile's steps with `options`, over 2 s from rest.
Grit GritOn(const DeviceProfile& profile, const HandModel& hand, const SceneOptions& options,
            const GritPath& path);

/// The greatest of both, over 1, 2, 5, 19.3 and 50 mm/s, along an axis and at 7, 30 and 45 degrees
/// to it, even and turning back every 0.35 s, in free air and on flat paper.
Grit WorstGrit(const DeviceProfile& profile, const HandModel& hand, const SceneOptions& options);

}  // namespace moontrace
