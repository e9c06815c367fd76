#pragma once

#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "sim/reader/link_shapes.h"
#include "sim/reader/sign_shapes.h"

namespace moontrace {

/// The face of an object that is read, as a hand that has been put on it knows it: a rectangle
/// beyond which there is nothing to touch. In the reader's own frame.
struct ReaderFace {
  glm::dvec2 middle{0, 0}, half{0, 0};  ///< [m]
  double turn = 0;                      ///< of its sides, to the left [rad]

  /// The nearest point that is at least so far within its edges, or its middle line where it is
  /// narrower [m].
  glm::dvec2 Held(glm::dvec2 p, double within) const noexcept {
    const glm::dvec2 most = glm::max(half - within, glm::dvec2(0));
    return FromOwn(glm::clamp(ToOwn(p), -most, most));
  }
  /// Out over the edge that is nearest, unit.
  glm::dvec2 Outward(glm::dvec2 p) const noexcept {
    const glm::dvec2 off = ToOwn(p), left = half - glm::abs(off);
    const glm::dvec2 out =
        left.x < left.y ? glm::dvec2(off.x < 0 ? -1 : 1, 0) : glm::dvec2(0, off.y < 0 ? -1 : 1);
    return FromOwn(out) - middle;
  }
  /// From the middle, along its sides, and back.
  glm::dvec2 ToOwn(glm::dvec2 p) const noexcept {
    const double c = std::cos(turn), s = std::sin(turn);
    const glm::dvec2 off = p - middle;
    return {c * off.x + s * off.y, c * off.y - s * off.x};
  }
  glm::dvec2 FromOwn(glm::dvec2 q) const noexcept {
    const double c = std::cos(turn), s = std::sin(turn);
    return middle + glm::dvec2(c * q.x - s * q.y, s * q.x + c * q.y);
  }
};

/// What a reader is told before it feels anything: the script, its letters' groove or ridge, its
/// own hand and its device; of an object its face. Nothing of the page.
struct ReaderKnowledge {
  std::shared_ptr<const SignShapes> shapes;
  double width = 0;          ///< of a groove, rim to rim [m]
  double depth = 0;          ///< of a groove [m]
  bool raised = false;       ///< ridges in place of grooves, so wide and so high
  bool followed = true;      ///< grooves, in which a tip can go; else ridges, dots, linked grooves
  double least_size = 0;     ///< letters are at least so large [m]
  double greatest_size = 0;  ///< and at most [m]
  double space = 0;          ///< advance of a space in the script [em]
  double link_depth = 0;     ///< of links between letters, share of theirs; 0: there are none
  /// The links of letters of a size [m], if there are any.
  std::function<std::shared_ptr<const LinkShapes>(double size)> links;
  LinesRun lines = LinesRun::kRight;
  double heading_scale = 1;  ///< of headings, so many times as large as other lines; 1: as large

  std::optional<ReaderFace> face;  ///< none: paper, without an edge in reach

  double press = 0;             ///< of its hand [N]
  double hand_mass = 0;         ///< [kg]
  double hand_stiffness = 0;    ///< [N/m]
  double hand_damping = 0;      ///< [N s/m]
  double delay = 0;             ///< by which it feels late [s]
  double lag = 0;               ///< of its muscles [s]
  double unsure = 0;            ///< how wrongly it feels its place, rms [m]
  double device_stiffness = 0;  ///< of what the device renders [N/m]; infinite: a true surface
  bool feels_height = true;     ///< else walls alone tell it of a groove while it presses

  /// Sideways force that a groove's wall takes at this press, by its slope [N]; the rounding is
  /// taken for a fifth of the width.
  double Hold() const { return press * depth / (0.3 * width); }
};

/// What a reader gets in each tick, and no more. All of it is as late as its senses are.
struct ReaderInput {
  double time = 0;            ///< now [s]
  glm::dvec3 tip{0, 0, 0};    ///< as the device reports it; z out of the paper, if measured [m]
  glm::dvec3 force{0, 0, 0};  ///< that was commanded on the tip [N]
};

/// What the reader wants its hand to do.
struct ReaderAction {
  glm::dvec3 aim{0, 0, 0};  ///< of the tip [m]
  double press = 0;         ///< into the paper [N]; 0: the tip is lifted to the aim's height
};

}  // namespace moontrace
