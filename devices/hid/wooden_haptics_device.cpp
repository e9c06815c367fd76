#include "devices/hid/wooden_haptics_device.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

#include "devices/core/device_error.h"
#include "devices/hid/hid_descriptor.h"
#include "devices/hid/hid_link.h"
#include "devices/hid/homing.h"
#include "devices/hid/wooden_haptics.h"

namespace moontrace {
namespace {

constexpr double kKeepAlive = 0.005;    // [s]; the arm only sends reports in answer to ours
constexpr double kLongestWrite = 0.25;  // a device that takes nothing for so long is lost [s]

// No hand turns a body faster; beyond this and a first tenth of a radian the counts are garbage.
constexpr double kFastestTurn = 50;  // [rad/s]
constexpr double kLeap = 0.1;        // [rad]

HidLinkOptions LinkOptions(const DeviceProfile& profile) {
  const ArmOutput zero = EncodeArm(profile.arm, {});
  HidReport report;
  report.size = static_cast<std::uint16_t>(zero.size);
  std::copy_n(zero.bytes.begin(), zero.size, report.bytes.begin());
  HidLinkOptions options;
  options.repeat_every = kKeepAlive;
  options.farewell = options.release = {report};
  options.name = profile.name;
  return options;
}

class WoodenHaptics final : public Device, public NeedsHoming {
 public:
  WoodenHaptics(const std::string& path, const DeviceProfile& profile, const DeviceLimits& limits)
      : arm_(profile.arm), limits_(limits), link_(path, LinkOptions(profile)), homing_(arm_) {}

  DeviceLimits Limits() const noexcept override { return limits_; }
  std::string WhyLost() override { return link_.WhyLost(); }
  HomingStep NextStep() const noexcept override { return step_.load(std::memory_order_relaxed); }

  DeviceStatus Read(DeviceState& state) noexcept override {
    if (IsLost()) return Lose();
    if (link_.WasLetGo()) return DeviceStatus::kNotReady;
    HidReport report;
    if (!link_.Take(0, report)) return NothingNew();
    const std::optional<ArmReport> input = DecodeArm(arm_, report.span());
    if (!input) return Lose();
    if (has_read_ && input->counter && input->counter == counter_) return NothingNew();
    counter_ = input->counter;
    if (HasLeapt(input->counts, report.time)) return Lose();
    counts_ = input->counts;
    time_ = report.time;
    has_read_ = true;
    homing_.Advance(counts_, time_);
    if (IsHomed()) angles_ = AnglesAt(arm_, counts_, homing_.rest());
    if (IsHomed() && !IsReachable(arm_, angles_)) homing_.Reset();
    step_.store(homing_.step(), std::memory_order_relaxed);
    if (!IsHomed()) return DeviceStatus::kNotReady;
    state.time = time_;
    state.p_D = ArmPosition(arm_, angles_);
    state.v_D = {0, 0, 0};
    state.velocity_known = false;
    state.buttons = input->button ? 1 : 0;
    return DeviceStatus::kOk;
  }

  DeviceStatus Write(glm::dvec3 f_D) noexcept override {
    if (IsLost()) return Lose();
    if (!IsHomed()) {
      Send({});  // the arm answers only what it hears
      return DeviceStatus::kNotReady;
    }
    for (int i = 0; i < 3; ++i) {
      const bool may = limits_.pushes[i] && std::isfinite(f_D[i]);
      f_D[i] = may ? std::clamp(f_D[i], -limits_.peak_force, limits_.peak_force) : 0;
    }
    Send(CurrentsFor(arm_, angles_, f_D));
    return DeviceStatus::kOk;
  }

 private:
  bool IsHomed() const noexcept { return homing_.step() == HomingStep::kDone; }
  bool IsLost() const noexcept {
    return is_lost_ || !link_.IsAlive() || link_.WaitingWrite() > kLongestWrite;
  }
  DeviceStatus Lose() noexcept {
    is_lost_ = true;
    Send({});
    return DeviceStatus::kLost;
  }
  DeviceStatus NothingNew() const noexcept {
    return IsHomed() ? DeviceStatus::kNoNewData : DeviceStatus::kNotReady;
  }
  bool HasLeapt(const ArmCounts& counts, double time) const noexcept {
    if (!has_read_) return false;
    const ArmAngles turned = AnglesAt(arm_, counts, counts_);
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const double most = kLeap + kFastestTurn * (time - time_);
      if (std::abs(turned[i] - arm_.rest[i]) > most) return true;
    }
    return false;
  }
  void Send(const ArmCurrents& currents) noexcept {
    link_.Put(0, EncodeArm(arm_, currents).span(), currents != ArmCurrents{});
  }

  const ArmGeometry arm_;
  const DeviceLimits limits_;
  HidLink link_;
  Homing homing_;
  std::atomic<HomingStep> step_{HomingStep::kRest};
  bool is_lost_ = false, has_read_ = false;
  std::optional<std::uint16_t> counter_;
  ArmCounts counts_{};
  ArmAngles angles_{};
  double time_ = 0;  // of the newest reading [s]
};

}  // namespace

bool FitsArm(const HidInfo& info, const DeviceProfile& profile) {
  try {
    const HidDescriptor descriptor = ParseHidDescriptor(ReportDescriptorOf(info.path));
    const HidReportLayout* const input = descriptor.Find(HidReportType::kInput, 0);
    return input != nullptr && input->bytes == 1 + profile.arm.report_bytes;
  } catch (const DeviceError&) {
    return false;
  }
}

std::unique_ptr<Device> MakeWoodenHaptics(const HidInfo& info, const DeviceProfile& profile,
                                          double tick) {
  return std::make_unique<WoodenHaptics>(info.path, profile, LimitsOf(profile, tick));
}

}  // namespace moontrace
