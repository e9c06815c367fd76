#pragma once

#include <glm/vec2.hpp>

#include "textures/base/branchless.h"
#include "textures/field/element.h"

namespace moontrace {

/// Whether a point lies in a box, its sides included. One branch instead of four, which at random
/// points would be mispredicted; false for a point that is none.
inline bool IsIn(const Box& box, glm::dvec2 p) noexcept {
  return BothBetween(&box.min.x, p.x, p.y, &box.max.x);
}

}  // namespace moontrace
