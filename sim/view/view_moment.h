#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace moontrace {

/// What the viewer shows of one instant. Frame P of the page `page`.
struct ViewMoment {
  double time = 0;                              ///< since the loop or trial began [s]
  std::uint32_t page = 0;                       ///< ViewPage::number
  bool present = false;                         ///< there is a stylus
  bool in_contact = false;                      ///< it touches the page
  bool stopped = false;                         ///< force rests
  glm::dvec3 tip_P{0, 0, 0}, proxy_P{0, 0, 0};  ///< [m]
  glm::dvec3 force_P{0, 0, 0};                  ///< on the hand [N]
  glm::dvec3 guidance_P{0, 0, 0};               ///< the push within it [N]
  std::optional<glm::dvec2> bead_P;             ///< where the push leads [m]
  double lateness_us = 0;                       ///< of the tick, after its deadline [us]
  double heat = 0;                              ///< of the warmest motor, share of what it bears
};

}  // namespace moontrace
