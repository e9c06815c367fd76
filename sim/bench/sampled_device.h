#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

#include "devices/core/device.h"
#include "devices/core/profile.h"
#include "devices/core/tick_motion.h"

namespace moontrace {

/// How a device and the hand on it answer forces: each axis a mass with damping and perhaps a
/// spring to where the hand wants to be. Period and delay are whole ticks of the loop.
struct SampledModel {
  double mass = 0.1;              ///< [kg]
  double damping = 3;             ///< of device and hand [N s/m]
  glm::dvec3 stiffness{0, 0, 0};  ///< of the hand [N/m]
  double tick = 0.001;            ///< of the loop [s]
  int period = 1;                 ///< from one reading, and one force taken, to the next
  int delay = 0;                  ///< from a force taken to its effect
  double position_step = 0;       ///< of its readings [m]; 0: exact
};

/// The model of a profile with a hand on it: the hand's mass, the profile's damping (which counts
/// hand and device), rate, delay and position step. The hand has no spring yet.
SampledModel ModelOf(const DeviceProfile& profile, double hand_mass, double tick);

/// A simulated device: reads at its own rate, holds each force for its own period, answers late.
/// Motion between is exact. Frame D.
class SampledDevice {
 public:
  explicit SampledDevice(const SampledModel& model);

  /// The newest reading; kNoNewData between readings.
  DeviceStatus Read(DeviceState& state) noexcept;
  /// A tick passes with `force` [N] commanded: the device takes the newest command at each of its
  /// readings, holds it until the next and lets it act `delay` ticks later. The hand adds a force
  /// [N] and draws towards `aim` [m] by its spring.
  void Advance(glm::dvec3 force, glm::dvec3 hand_force, glm::dvec3 aim) noexcept;

  glm::dvec3 p() const noexcept { return p_; }        ///< where the tip is [m]
  glm::dvec3 v() const noexcept { return v_; }        ///< [m/s]
  glm::dvec3 felt() const noexcept { return felt_; }  ///< what acted over the last tick [N]
  /// Puts the tip somewhere, whatever the forces.
  void Place(glm::dvec3 p, glm::dvec3 v) noexcept {
    p_ = p;
    v_ = v;
  }

 private:
  static constexpr std::size_t kMostDelay = 256;

  SampledModel model_;
  std::array<TickMotion, 3> motion_;
  std::array<glm::dvec3, kMostDelay> late_;  ///< forces that have yet to act, a ring of ticks
  long tick_ = 0;
  glm::dvec3 taken_{0, 0, 0};
  glm::dvec3 felt_{0, 0, 0};
  glm::dvec3 p_{0, 0, 0}, v_{0, 0, 0};
};

}  // namespace moontrace
