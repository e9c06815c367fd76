#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "sim/reader/sign_belief.h"

namespace moontrace {

/// A line that leads a finger from one line of text to the next, like a flat parenthesis, as it was
/// felt. In the frame in which the hand feels [m].
struct GuideLine {
  glm::dvec2 upper{0, 0}, lower{0, 0};  ///< its ends
  bool bulges_right = false;
};

/// The guide line that grooves make; none if they make none: an upright arc higher than any sign.
/// How flat it is, is not told. `line`: how large signs are, and how lines are turned.
std::optional<GuideLine> FitGuide(const std::vector<FeltPoint>& grooves, const SignPlace& line);

}  // namespace moontrace
