#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "devices/core/device.h"
#include "devices/core/tick_motion.h"
#include "devices/hand/drift.h"
#include "devices/hand/hand.h"
#include "devices/hand/tremor.h"

namespace moontrace {

/// Where a mind wants the tip of its stylus to be.
struct LedAim {
  glm::dvec3 p_D{0, 0, 0};  ///< [m]
  double press = 0;         ///< along -z [N], at least 0; where it is 0 the hand holds the height
};

/// How quickly a hand does what its mind wants. Ours.
struct Muscle {
  double lag = 0.030;         ///< by which an even movement comes later [s]
  double speed = 0.4;         ///< greatest of the aim [m/s]
  double acceleration = 8.0;  ///< greatest of the aim [m/s^2]
};

/// The stylus in a simulated hand that a mind leads tick by tick: spring, damper, tremor, drift and
/// late forces of MakeSimulatedStylus, but the aim follows what was wanted as a muscle does. The
/// press direction is -z. Same hand, seed, aims and forces: same bytes.
class LedStylus final : public Device {
 public:
  /// Rests at `start_D` [m]. `tick` [s]. Throws std::invalid_argument: a hand without mass or
  /// spring, a tick or a lag that is not above zero.
  LedStylus(const HandModel& hand, const Muscle& muscle, glm::dvec3 start_D, double tick,
            std::uint64_t seed);

  /// What the hand does from the next Read on. An aim that is not finite is left out.
  void Lead(const LedAim& aim) noexcept;

  DeviceLimits Limits() const noexcept override;
  DeviceStatus Read(DeviceState& state) noexcept override;
  DeviceStatus Write(glm::dvec3 f_D) noexcept override;

 private:
  void Advance() noexcept;
  void MoveIntent() noexcept;
  glm::dvec3 ArrivingForce() noexcept;
  void Follow(int axis, double from, double to, double force) noexcept;

  Muscle muscle_;
  double tick_ = 0;
  double damping_ = 0;
  int late_ticks_ = 0;
  TickMotion held_, pressed_;
  Tremor tremor_;
  Drift drift_;
  std::vector<glm::dvec3> forces_;  ///< not yet arrived, a ring buffer [N]
  std::size_t slot_ = 0;
  std::uint64_t ticks_ = 0;
  bool begun_ = false, pressing_ = false;
  LedAim wanted_;
  glm::dvec3 intent_{0, 0, 0}, intent_rate_{0, 0, 0};  ///< [m], [m/s]
  double press_ = 0;                                   ///< [N]
  glm::dvec3 written_{0, 0, 0};                        ///< [N]
  glm::dvec3 p_{0, 0, 0}, v_{0, 0, 0};                 ///< of the tip [m], [m/s]
  glm::dvec3 aim_{0, 0, 0};                            ///< intent, tremor and drift [m]
};

}  // namespace moontrace
