#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>

#include "devices/core/device.h"
#include "devices/core/profile.h"
#include "devices/hid/hid_port.h"

namespace moontrace {

/// The last state that a six-axis puck reported (3Dconnexion: report 1 translation, followed by the
/// rotation on some models, 2 rotation, 3 buttons).
struct PuckState {
  std::array<std::int16_t, 3> translation{};  ///< counts along the puck's own axes
  std::uint32_t buttons = 0;
};

/// Takes a report in; false, and nothing changed, if it is not a puck's.
bool TakePuckReport(std::span<const std::uint8_t> report, PuckState& state) noexcept;

/// Velocity of the tip [m/s], frame D: deflection beyond the dead zone in proportion, the profile's
/// top speed at full deflection and beyond.
glm::dvec3 PuckVelocity(const PuckMap& puck, const PuckState& state) noexcept;

/// Opens a puck; limits for ticks of `tick` [s]. It moves the tip by rate control within its
/// profile's workspace and pushes nothing. It sends nothing at rest, which is no fault: it always
/// has a reading. A puck that was deflected and has been silent for half a second counts as at
/// rest. Reports of other numbers (a battery's) are ignored. Throws DeviceError.
std::unique_ptr<Device> MakePuck(const HidInfo& info, const DeviceProfile& profile, double tick);

}  // namespace moontrace
