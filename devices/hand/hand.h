#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// The simulated hand: a mass pulled along a timed path by a spring and a damper, with tremor and a
/// sideways drift that it does not see. Values from `devices/hand.toml` (ours, the same for every
/// size).
struct HandModel {
  double mass = 0;         ///< [kg]
  double stiffness = 0;    ///< [N/m]
  double damping = 0;      ///< [N s/m]
  double press = 0;        ///< force into a grooved page [N]
  double light_press = 0;  ///< force onto a ridged page [N]
  double tremor_rms = 0;   ///< per axis [m]
  double tremor_low = 0;   ///< band [Hz]
  double tremor_high = 0;
  double drift = 0;  ///< sideways, greatest share of the length travelled while pressing [m/m]
  double drift_wavelength = 0;  ///< travelled length over which drift swings left and right [m]
  int late_ticks = 0;           ///< ticks by which a force arrives late
};

/// Reads a hand from a TOML file. Throws std::runtime_error with one line: what, file:line:column,
/// how to mend it.
HandModel LoadHand(const std::string& path);
/// The same from memory; `name` stands in messages.
HandModel ParseHand(std::string_view text, const std::string& name);

/// One point of the path a hand means to follow; between points aim and press change evenly in
/// time.
struct HandPoint {
  double time = 0;          ///< [s], ascending
  glm::dvec3 p_D{0, 0, 0};  ///< aim of the tip [m]
  /// Force along the path's press direction [N], >= 0; where it is 0 the hand holds the height.
  double press = 0;
};
struct HandPath {
  std::vector<HandPoint> points;
  glm::dvec3 press_direction_D{0, 0, -1};  ///< unit, into the page
  bool repeats = false;  ///< begins again at its end, which should lie where it began
};

}  // namespace moontrace
