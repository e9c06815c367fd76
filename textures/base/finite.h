#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace moontrace {

/// Whether no part of a vector is infinite or NaN.
inline bool IsFinite(glm::dvec3 v) noexcept {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace moontrace
