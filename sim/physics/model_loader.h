#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "sim/physics/label.h"
#include "sim/physics/mujoco_compat.h"
#include "sim/physics/scene_options.h"

namespace moontrace {

/// Where MuJoCo keeps the proxy: body on three free slides x, y, z of the world. One that was
/// inserted before joints of the model has a pad, a fourth joint that nothing moves (mjcf.cpp).
struct ProxyPlace {
  int body = -1;
  int qpos = 0;                   ///< of its three in mjData::qpos
  int dof = 0;                    ///< of its three in mjData::qvel
  glm::dvec3 offset_W{0, 0, 0};   ///< proxy position less qpos [m]
  double mass = 0;                ///< that the slides move, of the lightest axis [kg]
  glm::dvec3 axis_mass{0, 0, 0};  ///< that each slide moves [kg]
  double weight_mass = 0;         ///< that gravity pulls on [kg]
  int pad_dof = -1;               ///< of the pad in mjData::qvel, -1 if there is none
  int handle_mocap = -1;          ///< mocap number of moontrace_handle, -1 if there is none
};

struct LoadedModel {
  ModelPtr m;
  std::string xml;            ///< what MuJoCo was given: includes expanded, proxy inserted
  std::vector<Label> labels;  ///< in the model's order
  ProxyPlace proxy;
  std::vector<std::string> remarks;  ///< one line each
};

/// Compiles a model and finds what carries Moon text in it. `folder` is where the files it names
/// lie (empty: the current folder); `name` begins every message. The geom of label `label` is
/// turned by `tilt` [rad] about its page's lower edge, which only a top face of what rests allows.
/// Geoms that are felt plain stand behind the model's own labels.
/// Throws InputError as Scene::Load says.
///
/// A label stands on any geom with a chart (textures/objects): MuJoCo fixes planes to the world, so
/// a sheet that can be pushed is a box.
LoadedModel LoadModel(const std::string& xml, const std::string& folder, const std::string& name,
                      double tilt, std::size_t label = 0,
                      Unlabelled unlabelled = Unlabelled::kNothing);

/// The same of a model that is compiled already and has a proxy; `xml` is what it was made of, for
/// records. Its flags and its solvers' scale are changed as those of a model that is loaded.
LoadedModel AdoptModel(ModelPtr m, std::string xml, const std::string& name, std::size_t label = 0);

}  // namespace moontrace
