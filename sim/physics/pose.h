#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace moontrace {

/// Where a frame stands in the world: p_W = R_WF * p_F + p_WF.
struct Pose {
  glm::dmat3 R{1.0};
  glm::dvec3 p{0, 0, 0};  ///< [m]
};
inline glm::dvec3 ToWorld(const Pose& X, glm::dvec3 p_F) noexcept { return X.R * p_F + X.p; }
inline glm::dvec3 FromWorld(const Pose& X, glm::dvec3 p_W) noexcept { return (p_W - X.p) * X.R; }
inline glm::dvec3 TurnToWorld(const Pose& X, glm::dvec3 v_F) noexcept { return X.R * v_F; }
inline glm::dvec3 TurnFromWorld(const Pose& X, glm::dvec3 v_W) noexcept { return v_W * X.R; }

}  // namespace moontrace
