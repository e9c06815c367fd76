#pragma once

#include "sim/scene/mujoco_compat.h"

namespace moontrace {

/// Turns off those stages of MuJoCo's step that have nothing to work on in this model, as a page
/// and a proxy alone give none: constraints where contacts are off and there are no limits,
/// equalities, tendons and dry friction; passive forces where there are no springs, dampers and
/// fluid; sensors where there are none. A step gives the same state, bit for bit, in less time.
/// What the model asks for stays as it is.
void SkipIdleStages(mjModel& m) noexcept;

}  // namespace moontrace
