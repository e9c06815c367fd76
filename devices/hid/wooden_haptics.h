#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "devices/core/profile.h"

namespace moontrace {

/// Mathematics and reports of the WoodenHaptics family of arms: pure functions. Geometry as the
/// makers' host program (haptikfabrikenapi) states it; ArmGeometry in profile.h has the frames.

/// Angles of bodies A, B, C [rad]. A: 0 towards the person, growing to the right. B: 0 upright,
/// growing towards the person. C: 0 hanging, growing towards the person and up.
using ArmAngles = std::array<double, 3>;
using ArmCounts = std::array<std::int16_t, 3>;  ///< of the encoders; they wrap
using ArmCurrents = std::array<double, 3>;      ///< of the motors [A]

/// Tip in frame D [m].
glm::dvec3 ArmPosition(const ArmGeometry& arm, const ArmAngles& angles) noexcept;
/// Columns: what the tip does per radian of A, B, C, frame D [m/rad].
glm::dmat3 ArmJacobian(const ArmGeometry& arm, const ArmAngles& angles) noexcept;

/// Angles at `counts` when `rest` were those in the rest position. Right while no body is more than
/// half of the 16 bits away from its rest (more than a turn on all known arms).
ArmAngles AnglesAt(const ArmGeometry& arm, const ArmCounts& counts, const ArmCounts& rest) noexcept;

/// Currents that give force f_D [N] at the tip. Where a motor would need more than the arm's peak
/// current, all are lowered alike: the direction stays. What is not finite gives no current.
ArmCurrents CurrentsFor(const ArmGeometry& arm, const ArmAngles& angles, glm::dvec3 f_D) noexcept;

/// Whether an arm can have these angles: A and B within 100 degrees of the middle, C from 40
/// degrees inwards to level with the ceiling, the tip in front of the base. An arm homed elsewhere
/// than in its rest leaves this sooner or later.
bool IsReachable(const ArmGeometry& arm, const ArmAngles& angles) noexcept;

/// An input report.
struct ArmReport {
  ArmCounts counts{};
  bool button = false;
  std::optional<std::uint16_t> counter;  ///< one more with each report, where the device sends it
};

/// Nothing if the report has not the size of the arm's generation.
std::optional<ArmReport> DecodeArm(const ArmGeometry& arm,
                                   std::span<const std::uint8_t> report) noexcept;

/// An output report with its leading 0 (the device does not number reports).
struct ArmOutput {
  std::array<std::uint8_t, 65> bytes{};
  std::size_t size = 0;
  std::span<const std::uint8_t> span() const noexcept { return {bytes.data(), size}; }
};
ArmOutput EncodeArm(const ArmGeometry& arm, const ArmCurrents& currents) noexcept;

}  // namespace moontrace
