#pragma once

#include <mujoco/mujoco.h>

#include <glm/vec3.hpp>
#include <vector>

#include "sim/model_view/view_model.h"

namespace moontrace {

/// The geom that stands before a point of a label, as everything stands in `d`, MuJoCo's number;
/// -1: none. Stylus and proxy hide little, and do not count. [m]
int HiddenBy(const ViewModel& model, const mjData& d, const ViewModel::Label& label,
             glm::dvec3 eye_W, glm::dvec3 p_W);

/// Points of a label's text, spread evenly over it.
struct LabelPoint {
  glm::dvec3 p_W{0, 0, 0};       ///< [m]
  glm::dvec3 normal_W{0, 0, 1};  ///< outwards, unit
  /// Too far turned away to be read from there.
  bool IsTurnedFrom(glm::dvec3 eye_W) const;
};
std::vector<LabelPoint> PointsOf(const ViewModel::Label& label, const mjData& d);

/// How much of a label can be read from a place, and how much is hidden there behind other geoms,
/// each 0 to 1, whatever the edges of a picture.
struct SeenShares {
  double seen = 0, hidden = 0;
};
SeenShares SharesSeen(const ViewModel& model, const mjData& d, const ViewModel::Label& label,
                      glm::dvec3 eye_W);

}  // namespace moontrace
