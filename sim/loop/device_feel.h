#pragma once

#include "devices/core/device.h"
#include "lessons/guide/guidance_table.h"
#include "sim/scene/scene_options.h"

namespace moontrace {

/// What a device holds of a scene: the coupling no stiffer than it renders stably (the damping
/// follows so that the damping ratio stays) and the page's force cap low enough that the bound of
/// the force (coupling.h, a proxy of `proxy_mass` [kg]) stays within its peak. So the safety stage,
/// which caps at the peak, acts seldom.
SceneOptions HeldBy(const DeviceLimits& limits, SceneOptions options, double proxy_mass);

/// What a device holds of a push: a stiffness that it renders stably where the tip moves `scale`
/// times as far as the device, and a force within its peak.
GuidanceGains HeldBy(const DeviceLimits& limits, GuidanceGains gains, double scale);

}  // namespace moontrace
