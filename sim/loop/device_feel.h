#pragma once

#include "devices/core/device.h"
#include "lessons/guide/guidance_table.h"
#include "sim/physics/scene_options.h"

namespace moontrace {

/// A scene's options, limited to what a device can render: the coupling is the one it gets
/// (CouplingOf), no stiffer than it renders stably (then the damping follows so that the damping
/// ratio stays), and the page's force cap such that the bound of the force (coupling.h, a proxy of
/// `proxy_mass` [kg]) of an evenly moving hand is its peak. So the safety stage, which caps at the
/// peak, rarely acts, and the page carries as firm a press as the device can.
SceneOptions HeldBy(const DeviceLimits& limits, SceneOptions options, double proxy_mass);

/// A push's gains, limited to what a device can render: a stiffness that it renders stably where
/// the tip moves `scale` times as far as the device, and a force within its peak.
GuidanceGains HeldBy(const DeviceLimits& limits, GuidanceGains gains, double scale);

}  // namespace moontrace
