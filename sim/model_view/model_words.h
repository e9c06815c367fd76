#pragma once

#include <mujoco/mujoco.h>

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/model_view/sight.h"
#include "sim/model_view/view_model.h"

namespace moontrace {

/// Where the stylus is.
struct SeenTip {
  glm::dvec3 p_W{0, 0, 0};
  double height = 0;     ///< over the page [m]
  bool touches = false;  ///< what carries the page
};

/// A picture of a model in words, a sentence each: from where it is seen, each label with how much
/// of it is seen and where, what else there is, the tip. `target`: what is looked at, where a word
/// chose it.
std::vector<std::string> WordsOfView(const ViewModel& model, const mjData& d, const Sight& sight,
                                     const ViewTarget& target, const std::optional<SeenTip>& tip);

}  // namespace moontrace
