#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "sim/physics/fitted_solid.h"
#include "sim/physics/label.h"

namespace moontrace {

/// A geom that carries the labels of one part of a mesh or height field: neither seen nor weighed,
/// and it touches nothing by itself.
struct FittedGeom {
  std::string name;
  std::string on;    ///< the geom that it was fitted to
  std::string body;  ///< that has both; "world"
  Solid solid;
  Pose X_BO;  ///< in that body
};

/// Gives each label on a mesh or a height field a carrier: what is met from the middle of its face
/// (`face`, `middle_mm`), of the box around the geom along its body's axes, a height field's own.
/// The label then lies on that solid. Returns the carriers that the model lacks; adds one remark
/// for each label. Throws InputError of one line that begins with `name`: nothing there that a
/// solid fits.
std::vector<FittedGeom> FitLabels(const mjModel& m, std::vector<Label>& labels,
                                  const std::string& name, std::vector<std::string>& remarks);

/// The model's text with these geoms in their bodies. Throws InputError as above: a geom that is
/// not written there by its name, coordinates that are all global.
std::string WithGeoms(const std::string& xml, const std::vector<FittedGeom>& geoms,
                      const std::string& name);

}  // namespace moontrace
