#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "sim/physics/label.h"
#include "sim/physics/mujoco_compat.h"
#include "sim/physics/pose.h"

namespace moontrace {

/// Where MuJoCo keeps the proxy: body on three free slides x, y, z of the world.
struct ProxyPlace {
  int body = -1;
  int qpos = 0;                   ///< of its three in mjData::qpos
  int dof = 0;                    ///< of its three in mjData::qvel
  glm::dvec3 offset_W{0, 0, 0};   ///< proxy position less qpos [m]
  double mass = 0;                ///< that the slides move, of the lightest axis [kg]
  glm::dvec3 axis_mass{0, 0, 0};  ///< that each slide moves [kg]
  double weight_mass = 0;         ///< that gravity pulls on [kg]
  int handle_mocap = -1;          ///< mocap number of moontrace_handle, -1 if there is none
};

/// Where MuJoCo keeps the page: the geom of the first label.
struct PagePlace {
  int geom = -1;
  int body = 0;
  bool moves = false;            ///< its body can be pushed
  glm::dvec3 origin_G{0, 0, 0};  ///< the page's, in the geom's frame; the axes are the geom's [m]
  glm::dvec2 extent{0, 0};  ///< from there to the geom's far edges, infinite if it has none [m]
};

struct LoadedModel {
  ModelPtr m;
  std::string xml;            ///< what MuJoCo was given: includes expanded, proxy inserted
  std::vector<Label> labels;  ///< in the model's order
  ProxyPlace proxy;
  PagePlace page;
  std::vector<std::string> remarks;  ///< one line each
};

/// Compiles a model and finds what carries Moon text in it. `folder` is where the files it names
/// lie (empty: the current folder); `name` begins every message. The page geom is turned by `tilt`
/// [rad] about the page's lower edge, which a body that can move does not allow. Throws InputError
/// as Scene::Load says.
///
/// A label stands on a plane, or on a box: MuJoCo fixes planes to the world, so a sheet that can be
/// pushed is a box, whose upper face is the page's plane. Like the desk around a sheet, the plane
/// goes on beyond the face.
LoadedModel LoadModel(const std::string& xml, const std::string& folder, const std::string& name,
                      double tilt);

/// The page's pose in the world, from the positions that MuJoCo computed last.
inline Pose PoseOfPage(const mjData& d, const PagePlace& page) noexcept {
  const mjtNum* p = d.geom_xpos + std::ptrdiff_t{3} * page.geom;
  // row by row; glm goes column by column
  const mjtNum* R = d.geom_xmat + std::ptrdiff_t{9} * page.geom;
  const Pose X_WG{glm::dmat3(R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]),
                  glm::dvec3(p[0], p[1], p[2])};
  return {X_WG.R, ToWorld(X_WG, page.origin_G)};
}

}  // namespace moontrace
