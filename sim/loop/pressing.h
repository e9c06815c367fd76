#pragma once

#include "devices/core/device.h"
#include "sim/physics/pose.h"
#include "sim/physics/scene_options.h"
#include "textures/field/field.h"

namespace moontrace {

/// How a device with two axes gets a height: the tip is put below the proxy by press / stiffness,
/// so that the coupling presses the proxy onto the page with `press` and nothing else. The flanks
/// of a groove then push the proxy sideways with press times slope: the page's height has become a
/// force on the two motors. Along z the coupling damps the proxy against the paper (the tip's own
/// speed is zero there), so that it lands and does not ring.
struct Pressing {
  double press = 1;  ///< where the device gives no z of its own [N]

  /// What presses now [N]: a device that gives z < 0 presses with stiffness times that (a button,
  /// an axis), one that gives z > 0 is lifted, and z = 0 leaves it to the setting.
  double PressOf(double z_D, double stiffness) const noexcept {
    if (z_D > 0) return 0;
    return z_D < 0 ? -z_D * stiffness : press;
  }
};

/// A tip whose height is not measured, at the height where it presses with `press` [N], at most
/// what the page carries; 0 lifts it, at 50 mm/s. `world` is the reading in the world's frame;
/// `last` is the tick before, nullptr if there was none or the tip has been elsewhere since. The
/// velocity of the result is known.
DeviceState Pressed(const DeviceState& world, const Pose& X_WP, const TickResult* last,
                    double press, const SceneOptions& options, const TextureField& field) noexcept;

}  // namespace moontrace
