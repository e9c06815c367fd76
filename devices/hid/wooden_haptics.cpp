#include "devices/hid/wooden_haptics.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "devices/core/little_endian.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr int kButtonOffset = 10000;  // added to encoder d while the button is held

/// Frame M, x towards the person and y to the right, into D, x to the right and y away.
glm::dvec3 Turned(const glm::dvec3& v_M) noexcept { return {v_M.y, -v_M.x, v_M.z}; }

}  // namespace

glm::dvec3 ArmPosition(const ArmGeometry& arm, const ArmAngles& angles) noexcept {
  const auto [a, b, c] = angles;
  const double reach = arm.link[1] * std::sin(b) + arm.link[2] * std::sin(c);
  const double height = arm.link[0] + arm.link[1] * std::cos(b) - arm.link[2] * std::cos(c);
  const glm::dvec3 p_M(reach * std::cos(a), reach * std::sin(a), height);
  return Turned(p_M - arm.origin_M);
}

glm::dmat3 ArmJacobian(const ArmGeometry& arm, const ArmAngles& angles) noexcept {
  const auto [a, b, c] = angles;
  const double reach = arm.link[1] * std::sin(b) + arm.link[2] * std::sin(c);
  const glm::dvec3 out(std::cos(a), std::sin(a), 0);  // away from the base
  const glm::dvec3 side(-std::sin(a), std::cos(a), 0);
  const glm::dvec3 up(0, 0, 1);
  return {Turned(reach * side), Turned(arm.link[1] * (std::cos(b) * out - std::sin(b) * up)),
          Turned(arm.link[2] * (std::cos(c) * out + std::sin(c) * up))};
}

ArmAngles AnglesAt(const ArmGeometry& arm, const ArmCounts& counts,
                   const ArmCounts& rest) noexcept {
  ArmAngles angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto moved = static_cast<std::int16_t>(counts[i] - rest[i]);  // wraps as they do
    angles[i] =
        arm.rest[i] + arm.encoder_sign[i] * kTurn * moved / (arm.counts[i] * arm.reduction[i]);
  }
  return angles;
}

ArmCurrents CurrentsFor(const ArmGeometry& arm, const ArmAngles& angles, glm::dvec3 f_D) noexcept {
  const glm::dvec3 torque = glm::transpose(ArmJacobian(arm, angles)) * f_D;  // of the bodies
  ArmCurrents currents{};
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double motor = torque[static_cast<int>(i)] / arm.reduction[i];
    currents[i] = arm.current_sign[i] * motor / arm.motor_constant[i];
    if (!std::isfinite(currents[i])) return {};
    most = std::max(most, std::abs(currents[i]));
  }
  if (most > arm.peak_current) {
    for (double& current : currents) current *= arm.peak_current / most;
  }
  return currents;
}

bool IsReachable(const ArmGeometry& arm, const ArmAngles& angles) noexcept {
  const auto [a, b, c] = angles;
  const double reach = arm.link[1] * std::sin(b) + arm.link[2] * std::sin(c);
  return std::abs(a) < 100 * kDegree && std::abs(b) < 100 * kDegree && c > -40 * kDegree &&
         c < 180 * kDegree && reach > 0;
}

std::optional<ArmReport> DecodeArm(const ArmGeometry& arm,
                                   std::span<const std::uint8_t> report) noexcept {
  if (report.size() != arm.report_bytes || report.size() < 8) return std::nullopt;
  ArmReport out;
  for (std::size_t i = 0; i < 3; ++i) out.counts[i] = GetLittle<std::int16_t>(report, 2 * i);
  if (report.size() == 8) {
    out.counter = GetLittle<std::uint16_t>(report, 6);
  } else {
    out.button = GetLittle<std::int16_t>(report, 6) > kButtonOffset / 2;
  }
  return out;
}

ArmOutput EncodeArm(const ArmGeometry& arm, const ArmCurrents& currents) noexcept {
  ArmOutput out;
  out.size = std::min(1 + arm.report_bytes, out.bytes.size());
  for (std::size_t i = 0; i < 3; ++i) {
    const double held = std::clamp(currents[i], -arm.peak_current, arm.peak_current);
    const double milliamperes = std::isfinite(currents[i]) ? std::round(held * 1000) : 0;
    PutLittle(out.bytes, 1 + 2 * i, static_cast<std::int16_t>(milliamperes));
  }
  return out;
}

}  // namespace moontrace
