#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "sim/reader/sign_shapes.h"

namespace moontrace {

/// What a reader is told before it feels anything: the script, its letters' groove, its own hand
/// and its device. Nothing of the page.
struct ReaderKnowledge {
  std::shared_ptr<const SignShapes> shapes;
  double width = 0;          ///< of a groove, rim to rim [m]
  double depth = 0;          ///< of a groove [m]
  double least_size = 0;     ///< letters are at least so large [m]
  double greatest_size = 0;  ///< and at most [m]
  double space = 0;          ///< advance of a space in the script [em]
  double heading_scale = 1;  ///< of headings, so many times as large as other lines; 1: as large

  double press = 0;             ///< of its hand [N]
  double hand_mass = 0;         ///< [kg]
  double hand_stiffness = 0;    ///< [N/m]
  double hand_damping = 0;      ///< [N s/m]
  double delay = 0;             ///< by which it feels late [s]
  double lag = 0;               ///< of its muscles [s]
  double unsure = 0;            ///< how wrongly it feels its place, rms [m]
  double device_stiffness = 0;  ///< of what the device renders [N/m]; infinite: a true surface

  /// Sideways force that a groove's wall takes at this press, by its slope [N]; the rounding is
  /// taken for a fifth of the width.
  double Hold() const { return press * depth / (0.3 * width); }
};

/// What a reader gets in each tick, and no more. All of it is as late as its senses are.
struct ReaderInput {
  double time = 0;            ///< now [s]
  glm::dvec3 tip{0, 0, 0};    ///< as the device reports it; z out of the paper [m]
  glm::dvec3 force{0, 0, 0};  ///< that was commanded on the tip [N]
};

/// What the reader wants its hand to do.
struct ReaderAction {
  glm::dvec3 aim{0, 0, 0};  ///< of the tip [m]
  double press = 0;         ///< into the paper [N]; 0: the tip is lifted to the aim's height
};

}  // namespace moontrace
