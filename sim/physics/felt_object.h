#pragma once

#include <mujoco/mujoco.h>

#include <cstddef>
#include <string>
#include <vector>

#include "sim/physics/floating_body.h"
#include "sim/physics/label_place.h"
#include "sim/physics/pose.h"
#include "sim/physics/scene_options.h"
#include "textures/objects/solid_contact.h"

namespace moontrace {

/// A geom's pose in the world, from the positions that MuJoCo computed last.
inline Pose PoseOfGeom(const mjData& d, int geom) noexcept {
  const mjtNum* p = d.geom_xpos + std::ptrdiff_t{3} * geom;
  // row by row; glm goes column by column
  const mjtNum* R = d.geom_xmat + std::ptrdiff_t{9} * geom;
  return {glm::dmat3(R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]),
          glm::dvec3(p[0], p[1], p[2])};
}

/// A geom with its labels, as a tick asks it.
struct FeltObject {
  int geom = -1;
  int body = 0;
  bool pushed = false;  ///< a force can move it
  bool moves = false;   ///< it can move: pushed or led
  bool free = false;    ///< nothing holds it: it can fall
  Solid solid;
  std::vector<std::size_t> numbers;  ///< of its labels, in the model's order
  std::vector<LabelOnSolid> labels;  ///< likewise
  Surface surface;                   ///< the scene's, or its labels' own
  double compliance = 0;             ///< greatest velocity per impulse [1/kg]
  FloatingBody floating;
  int steps = 1;  ///< integration steps of a tick that touches it
  // what follows from surface and labels
  SurfaceLaw law;
  double through_depth = 0;  ///< [m]
  double thin = 0;           ///< a half length below this is a plate's [m]
  double reach = 0;          ///< farther from its middle nothing is felt [m]
  double near = 0;           ///< higher above its surface nothing is met within a tick [m]

  /// A plane with one label that is not turned: the page on a desk, asked as such.
  bool IsPage() const noexcept;
  /// Sets what follows. No allocation.
  void Settle() noexcept;
};

/// The objects that carry labels, each once, in the order of their first label; blank. Throws
/// InputError: labels of one geom that ask for different stiffness or cap.
std::vector<FeltObject> FeltObjects(const mjModel& m, mjData& d, const std::vector<Label>& labels,
                                    const SceneOptions& options, const std::string& name);

}  // namespace moontrace
