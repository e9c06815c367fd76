#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "devices/core/device.h"
#include "sim/console/console.h"
#include "sim/loop/clock.h"
#include "sim/safety/safety.h"

namespace moontrace {

/// What a device did during one push or look.
struct SessionView {
  std::uint64_t reports = 0;
  std::uint32_t buttons = 0;  ///< bit i: button i was held at some time
  glm::dvec3 low_D{0, 0, 0};  ///< least and greatest position [m]
  glm::dvec3 high_D{0, 0, 0};
  glm::dvec3 first_D{0, 0, 0};  ///< positions at the beginning and the end [m]
  glm::dvec3 last_D{0, 0, 0};
  glm::dvec3 greatest_force{0, 0, 0};  ///< commanded, per axis without sign [N]
  std::uint32_t events = 0;            ///< bit per SafetyEvent
  double time = 0;                     ///< [s]
  bool lost = false, not_ready = false;
  bool stopped = false;  ///< by a button, while force was asked for
};

/// Ticks a device at 1 kHz through the safety stage, for the steps of `devices test`. At the end of
/// every run the device has been given zero.
class DeviceSession {
 public:
  /// `force_cap` [N] is the greatest force on an axis, whatever a run asks for.
  DeviceSession(Device& device, double force_cap, Clock& clock);

  /// Pushes with `f_D` [N], zero or not, ramped in, for `seconds`. A button held while force is
  /// asked for ends it at once; so does the loss of the device. Throws Interrupted.
  SessionView Run(double seconds, glm::dvec3 f_D, const Console& console);

 private:
  Device& device_;
  Clock& clock_;
  Safety safety_;
  DeviceState newest_;
};

}  // namespace moontrace
