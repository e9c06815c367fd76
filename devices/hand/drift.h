#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "devices/core/tick_motion.h"
#include "textures/base/random.h"

namespace moontrace {

/// Sideways drift that a hand does not notice: each bit of path travelled on the page moves it
/// sideways by share * sin(2 pi s / wavelength + phase) of that length, with s the length travelled
/// since the hand began to press and a phase drawn anew at each approach. The sum is perpendicular
/// to the present direction of travel; where that turns, the offset follows as quickly as the hand
/// can.
class Drift {
 public:
  /// `share` [m/m], `wavelength` > 0 [m]; `relax` is the motion by which the offset follows a turn,
  /// and dies away while the hand does not press.
  Drift(double share, double wavelength, const TickMotion& relax, std::uint64_t seed);

  /// The hand begins to press: no offset, no path travelled, a new phase.
  void Begin() noexcept;
  /// A tick of pressing in which the aim has moved by `step` [m] in the page's plane.
  void Travel(glm::dvec2 step) noexcept;
  /// A tick without press.
  void Relax() noexcept;

  glm::dvec2 offset() const noexcept { return aside_ * left_ + rest_; }  ///< [m]

 private:
  void Settle() noexcept;

  double reach_ = 0;        ///< share / wave number [m]
  double wave_number_ = 0;  ///< [rad/m]
  TickMotion relax_;
  Random random_;
  double travelled_ = 0;        ///< [m]
  double phase_ = 0;            ///< [rad]
  double cosine_ = 0;           ///< of the phase reached
  double aside_ = 0;            ///< drifted to the left of the travel [m]
  glm::dvec2 left_{0, 0};       ///< of the travel, unit
  glm::dvec2 rest_{0, 0};       ///< what is left of turns and of earlier drift, dying away [m]
  glm::dvec2 rest_rate_{0, 0};  ///< [m/s]
};

}  // namespace moontrace
