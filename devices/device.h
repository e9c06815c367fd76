#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace moontrace {

/// One reading of a device. Frame D: the device's own, right-handed, z away from the desk.
struct DeviceState {
  double time = 0;          ///< of the reading [s]
  glm::dvec3 p_D{0, 0, 0};  ///< tip [m]
  glm::dvec3 v_D{0, 0, 0};  ///< tip velocity [m/s], valid if `velocity_known`
  bool velocity_known = false;
  std::uint32_t buttons = 0;  ///< bit i: button i is held
};

/// What a device holds.
struct DeviceLimits {
  double peak_force = 3;    ///< [N]
  double stiffness = 1000;  ///< greatest it renders stably [N/m]
  double damping = 3;       ///< of the device and the hand on it [N s/m]
  int late_ticks = 1;       ///< whole ticks between a force and its effect
};

enum class DeviceStatus { kOk, kNoNewData, kLost };

/// What moves the tip and receives the force. Opened by a factory that throws on failure; the
/// destructor commands zero force. Read and Write are called once per tick by the loop's thread
/// only: they do not block, allocate or throw.
class Device {
 public:
  virtual ~Device() = default;
  virtual DeviceLimits Limits() const noexcept = 0;
  virtual DeviceStatus Read(DeviceState& state) noexcept = 0;
  virtual DeviceStatus Write(glm::dvec3 f_D) noexcept = 0;
};

}  // namespace moontrace
