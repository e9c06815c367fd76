#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "devices/core/device.h"

namespace moontrace {

/// Where a device's frame D stands in the world: p_W = R (scale p_D) + origin. Positions and
/// velocities are scaled, forces are not.
struct DevicePlace {
  glm::dmat3 R_WD{1.0};
  double scale = 1;              ///< way in the world per way of the device
  glm::dvec3 origin_W{0, 0, 0};  ///< of D [m]
};

/// A reading as the world has it; time and buttons stay.
inline DeviceState ToWorld(const DevicePlace& place, const DeviceState& state) noexcept {
  DeviceState moved = state;
  moved.p_D = place.R_WD * (place.scale * state.p_D) + place.origin_W;
  moved.v_D = place.R_WD * (place.scale * state.v_D);
  return moved;
}

/// A force of the world in the device's frame.
inline glm::dvec3 ForceToDevice(const DevicePlace& place, glm::dvec3 f_W) noexcept {
  return f_W * place.R_WD;
}

}  // namespace moontrace
