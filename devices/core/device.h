#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <string>

namespace moontrace {

/// One reading of a device. Frame D: the device's own, right-handed, x to the right, y away from
/// the person, z away from the desk; its origin is the middle of the workspace.
struct DeviceState {
  double time = 0;          ///< of the reading [s]
  glm::dvec3 p_D{0, 0, 0};  ///< tip [m]
  glm::dvec3 v_D{0, 0, 0};  ///< tip velocity [m/s], valid if `velocity_known`
  bool velocity_known = false;
  std::uint32_t buttons = 0;  ///< bit i: button i is held
};

/// What a device can do and endure. Frame D.
struct DeviceLimits {
  double peak_force = 3;    ///< on one axis, for a moment [N]
  double stiffness = 1000;  ///< greatest it renders stably [N/m]
  double damping = 3;       ///< of the device and the hand on it [N s/m]
  /// The coupling that the page is felt through: spring [N/m] and damper [N s/m], see CouplingOf.
  double coupling_stiffness = 1000, coupling_damping = 10;
  double position_step = 0;  ///< of the readings, on each axis [m]; 0: exact, or unknown
  int late_ticks = 1;        ///< whole ticks between a force and its effect

  /// On one axis, continuously [N]; the motors' heat grows with force squared and is lost with the
  /// time constant `heat_time` [s]. Infinite and 0: it does not heat.
  double continuous_force = std::numeric_limits<double>::infinity();
  double heat_time = 0;
  double peak_power = std::numeric_limits<double>::infinity();  ///< given to the hand [W]
  double force_rate = 3000;  ///< greatest change of a rising force [N/s], at least 3000
  double silence = 0.25;     ///< longest wait for a report while force is felt [s]
  /// Longest that reports may give the very same position while force is felt; then the force is
  /// reduced to see whether the tip moves [s]. Infinite: it cannot stick.
  double still = std::numeric_limits<double>::infinity();
  double friction = 0;  ///< Coulomb, on the tip [N]; 0 where it is unknown
  double dead_man = 0;  ///< after which the device itself lets go [s]; 0: it never does by itself
  glm::bvec3 measures{true, true, true};  ///< axes of position
  glm::bvec3 pushes{true, true, true};    ///< axes of force
  int buttons = 0;
  /// Edges of the workspace around the origin [m]; infinite where it has none.
  glm::dvec3 workspace_D{std::numeric_limits<double>::infinity()};
};

/// kOk: a new reading. kNoNewData: none since the last one. kLost: unplugged, closed, crashed or
/// talking garbage; it stays lost, a new one must be opened. kNotReady: there, but its motors are
/// off (a safety switch, not homed): it must not be given force.
enum class DeviceStatus { kOk, kNoNewData, kLost, kNotReady };

/// What moves the tip and receives the force. Opened by a factory that throws DeviceError
/// (device_error.h); the destructor commands zero force. Read and Write are called once per tick by
/// the loop's thread only: they do not block, allocate or throw.
class Device {
 public:
  virtual ~Device() = default;
  virtual DeviceLimits Limits() const noexcept = 0;
  /// Leaves `state` as it is unless kOk.
  virtual DeviceStatus Read(DeviceState& state) noexcept = 0;
  virtual DeviceStatus Write(glm::dvec3 f_D) noexcept = 0;
  /// Why a lost device was lost, as a clause like "the plug-in hung"; empty if nothing more is
  /// known than that it is gone. Not for the tick: may wait up to a second.
  virtual std::string WhyLost() { return {}; }
};

}  // namespace moontrace
