#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "sim/physics/label.h"

namespace moontrace {

/// Labels without text for the geoms that carry none of `labels` and are felt plain: what collides
/// in the model, and what is only seen of bodies where nothing does; without a chart none. Those of
/// the proxy and of the handle are none of the model's.
std::vector<Label> PlainLabels(const mjModel& m, const std::vector<Label>& labels);

/// Lets the proxy's geoms collide, by MuJoCo's own contacts, with what collides in the model and
/// carries none of `labels`, and with nothing else. Throws InputError that begins with `name`: the
/// model uses all of the 31 bits by which MuJoCo tells what collides.
void LetProxyCollide(mjModel& m, const std::vector<Label>& labels, int proxy_body,
                     const std::string& name);

}  // namespace moontrace
