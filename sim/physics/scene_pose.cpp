#include "sim/physics/scene_pose.h"

#include <mujoco/mujoco.h>

namespace moontrace {

void TakePose(const Scene& scene, ScenePose& pose) {
  const mjModel& m = *scene.model();
  const mjData& d = *scene.data();
  pose.qpos.assign(d.qpos, d.qpos + m.nq);
  pose.mocap_pos.assign(d.mocap_pos, d.mocap_pos + std::ptrdiff_t{3} * m.nmocap);
  pose.mocap_quat.assign(d.mocap_quat, d.mocap_quat + std::ptrdiff_t{4} * m.nmocap);
  pose.X_WP = scene.X_WP();
}

}  // namespace moontrace
