#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "devices/random.h"
#include "devices/tick_motion.h"

namespace moontrace {

/// Sideways drift that a hand does not notice: each bit of way travelled on the page carries it
/// across its direction by share * sin(2 pi s / wavelength + phase) of that bit, s the length
/// travelled since the hand began to press, the phase by the seed and new at each approach.
class Drift {
 public:
  /// `share` [m/m], `wavelength` > 0 [m]; `relax` is the motion by which the hand finds back to
  /// where it means to be while it does not press.
  Drift(double share, double wavelength, const TickMotion& relax, std::uint64_t seed);

  /// The hand begins to press: no offset, no way travelled, a new phase.
  void Begin() noexcept;
  /// The aim has moved by `step` [m] in the page's plane while pressing.
  void Travel(glm::dvec2 step) noexcept;
  /// A tick without press.
  void Relax() noexcept;

  glm::dvec2 offset() const noexcept { return offset_; }  ///< [m]

 private:
  double reach_ = 0;        ///< share / wave number [m]
  double wave_number_ = 0;  ///< [rad/m]
  TickMotion relax_;
  Random random_;
  double travelled_ = 0;  ///< [m]
  double phase_ = 0;      ///< [rad]
  double cosine_ = 0;     ///< of the phase reached
  glm::dvec2 offset_{0, 0};
  glm::dvec2 rate_{0, 0};  ///< of the offset while it relaxes [m/s]
};

}  // namespace moontrace
