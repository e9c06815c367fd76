#pragma once

namespace moontrace {

/// How warm one motor is, and what it may still give. Heat h is the share of the modelled limit:
///
///   h' = (f^2 / f_c^2 - h) / tau,
///
/// copper loss grows with force squared and is lost with the time constant tau; the continuous
/// force f_c held for ever ends at h = 1. The ceiling c falls with h, evenly in force squared:
///
///   c^2 = f_peak^2 (1 - h) + f_c^2 h.
///
/// At the ceiling h' = (f_peak / f_c)^2 (1 - h) / tau: h nears 1 as an exponential and never passes
/// it, whatever is asked for, and the force settles at f_c. The ceiling depends on h only, so it
/// moves as slowly as the motor warms: nothing drops under the hand.
class MotorHeat {
 public:
  /// `peak` and `continuous` [N], `time_constant` [s], `longest_hold` [s]: how long a force may
  /// stand before another takes its place; the ceiling is kept low enough that h stays within 1
  /// over that time. An infinite `continuous` does not heat; a finite one without a time constant
  /// is the ceiling at once.
  MotorHeat(double peak, double continuous, double time_constant, double longest_hold) noexcept;
  /// No force at all: a motor that is not there.
  MotorHeat() noexcept = default;

  /// `force` [N] has acted for `elapsed` [s], exact for a force that is held.
  void Advance(double force, double elapsed) noexcept;

  double heat() const noexcept { return heat_; }  ///< 1 = the modelled limit
  double Ceiling() const noexcept;                ///< greatest force now [N]

 private:
  double peak_ = 0;           ///< [N]
  double continuous_ = 0;     ///< [N]; 0: does not heat, `peak_` stands
  double time_constant_ = 0;  ///< [s]
  double cold_square_ = 0;    ///< of the ceiling when cold [N^2]
  double heat_ = 0;
};

}  // namespace moontrace
