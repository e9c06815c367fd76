#pragma once

#include "devices/hand/hand.h"
#include "sim/physics/pose.h"
#include "sim/study/learner_model.h"
#include "textures/field/element.h"

namespace moontrace {

/// Feels a box of the page all over, whatever lies in it: comes down at its lower left corner,
/// sweeps up and down from left to right, then from side to side back over it, slanting from each
/// sweep to the next, pressing lightly all the while, and lifts. Depends on the box alone. `size`:
/// of the letters, by which the sweeps are spaced and the speed is chosen [m].
HandPath ExplorationPath(const Box& box_P, double size, const Exploration& how, const Pose& X_WP);

}  // namespace moontrace
