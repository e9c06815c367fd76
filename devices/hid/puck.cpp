#include "devices/hid/puck.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/glm.hpp>

#include "devices/core/little_endian.h"
#include "devices/hid/hid_link.h"

namespace moontrace {
namespace {

constexpr std::uint8_t kTranslation = 1, kRotation = 2, kButtons = 3;
constexpr double kSilence = 0.5;      // deflected pucks report every 8 to 16 ms [s]
constexpr double kLongestStep = 0.1;  // a tip moves on for no longer between two readings [s]

/// The vDSO's clock: no system call.
double Now() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

HidLinkOptions LinkOptions() {
  HidLinkOptions options;
  options.inputs = {kTranslation, kRotation, kButtons};
  options.outputs = 0;
  return options;
}

class Puck final : public Device {
 public:
  Puck(const std::string& path, const PuckMap& map, const DeviceLimits& limits)
      : map_(map), limits_(limits), link_(path, LinkOptions()), time_(Now()), heard_(time_) {}

  DeviceLimits Limits() const noexcept override { return limits_; }

  DeviceStatus Read(DeviceState& state) noexcept override {
    if (is_lost_ || !link_.IsAlive()) return Lose();
    for (std::size_t box = 0; box < 3; ++box) {
      HidReport report;
      if (!link_.Take(box, report)) continue;
      if (!TakePuckReport(report.span(), puck_)) return Lose();
      if (box == 0) heard_ = report.time;
    }
    const double now = Now();
    const glm::dvec3 v = now - heard_ < kSilence ? PuckVelocity(map_, puck_) : glm::dvec3(0, 0, 0);
    p_D_ += std::clamp(now - time_, 0.0, kLongestStep) * v;
    p_D_ = glm::clamp(p_D_, -limits_.workspace_D, limits_.workspace_D);
    time_ = now;
    state.time = now;
    state.p_D = p_D_;
    state.v_D = v;
    state.velocity_known = true;
    state.buttons = puck_.buttons;
    return DeviceStatus::kOk;
  }

  DeviceStatus Write(glm::dvec3) noexcept override {
    return is_lost_ || !link_.IsAlive() ? DeviceStatus::kLost : DeviceStatus::kOk;
  }

 private:
  DeviceStatus Lose() noexcept {
    is_lost_ = true;
    return DeviceStatus::kLost;
  }

  const PuckMap map_;
  const DeviceLimits limits_;
  HidLink link_;
  PuckState puck_;
  glm::dvec3 p_D_{0, 0, 0};
  double time_ = 0;   // of the last reading [s]
  double heard_ = 0;  // newest translation [s]
  bool is_lost_ = false;
};

}  // namespace

bool TakePuckReport(std::span<const std::uint8_t> report, PuckState& state) noexcept {
  if (report.size() < 2) return false;
  if (report[0] == kTranslation && report.size() >= 7) {
    for (std::size_t i = 0; i < 3; ++i) {
      state.translation[i] = GetLittle<std::int16_t>(report, 1 + 2 * i);
    }
    return true;
  }
  if (report[0] == kRotation) return report.size() >= 7;
  if (report[0] == kButtons) {
    state.buttons = 0;
    for (std::size_t i = 1; i < report.size() && i <= 4; ++i) {
      state.buttons |= static_cast<std::uint32_t>(report[i]) << (8 * (i - 1));
    }
    return true;
  }
  return false;
}

glm::dvec3 PuckVelocity(const PuckMap& puck, const PuckState& state) noexcept {
  glm::dvec3 v(0, 0, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const double count = state.translation[static_cast<std::size_t>(puck.axis[i])];
    const double beyond = std::max(0.0, std::abs(count) - puck.dead_zone);
    const double share = std::min(1.0, beyond / (puck.full_scale - puck.dead_zone));
    v[static_cast<int>(i)] = puck.sign[i] * std::copysign(share * puck.top_speed, count);
  }
  return v;
}

std::unique_ptr<Device> MakePuck(const HidInfo& info, const DeviceProfile& profile, double tick) {
  return std::make_unique<Puck>(info.path, profile.puck, LimitsOf(profile, tick));
}

}  // namespace moontrace
