#pragma once

#include <mujoco/mujoco.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sim/model_view/sight.h"
#include "sim/model_view/view_model.h"

namespace moontrace {

/// From where MuJoCo's own viewer looks at first.
mjvCamera WholeModel(const mjModel& m);

/// The camera that shows a target, as everything stands in `d`: a label from the side from which it
/// is read, with its geom as far as that is no more than six times as large; a geom or a body
/// whole, from where `now` looks. For the tip `now`, moved to it; `tip_W` [m].
mjvCamera CameraOn(const ViewModel& model, const mjData& d, const ViewTarget& target,
                   const mjvCamera& now, glm::dvec3 tip_W, double aspect);

/// A camera of the model becomes one that can be moved and sees the same.
mjvCamera Freed(const mjvCamera& camera, const Sight& sight, double distance);

/// Round what it looks at; `by` in heights of the picture, as MuJoCo's viewer turns.
void Turn(mjvCamera& camera, glm::dvec2 by);
/// What lies at the depth of the point looked at follows the mouse; likewise.
void Shift(mjvCamera& camera, const Sight& sight, glm::dvec2 by);
/// Nearer below 1; what is under `share` stays there.
void Zoom(mjvCamera& camera, const Sight& sight, glm::dvec2 share, double factor);

inline glm::dvec3 LookedAt(const mjvCamera& camera) {
  return {camera.lookat[0], camera.lookat[1], camera.lookat[2]};
}
void LookAt(mjvCamera& camera, glm::dvec3 p_W);

}  // namespace moontrace
