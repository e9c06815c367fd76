#include "devices/hid/pid_device.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "devices/core/device_error.h"
#include "devices/hid/hid_descriptor.h"
#include "devices/hid/hid_link.h"
#include "devices/hid/pid_codec.h"
#include "devices/hid/pid_layout.h"
#include "devices/hid/pid_setup.h"

namespace moontrace {
namespace {

constexpr double kRenewEvery = 0.015;  // [s], well within an effect's duration
constexpr double kUnboundReach =
    0.05;                         // from the middle to the end where no workspace is known [m]
constexpr double kLifted = 0.01;  // any height above the page [m]
constexpr double kAtRest = 0.02;  // share of a pressing axis that is no press

constexpr std::size_t kEnablePlace = 2;  // of the link's outputs, after the two motors

/// Everything that is known once the device is open.
struct Plan {
  std::string name;
  PidLayout layout;
  StickLayout stick;
  PidSetup setup;
  StickMap map;
  DeviceLimits limits;
  double press = 0;                          ///< of a pressing axis, at most [N]
  std::vector<std::uint8_t> inputs;          ///< numbers of all input reports
  std::vector<std::size_t> input_bytes;      ///< their lengths
  std::array<int, 2> motor_of_axis{-1, -1};  ///< of frame D: 0 HID's X, 1 HID's Y, -1 none
};

/// Zero force, and every effect is stopped; the next start and force undo it.
std::vector<HidReport> ReleaseOf(const Plan& plan) {
  std::vector<HidReport> release;
  for (const int block : plan.setup.blocks) {
    if (block != 0) release.push_back(EncodeConstantForce(plan.layout, block, 0));
  }
  for (const int block : plan.setup.blocks) {
    if (block != 0) release.push_back(EncodeOperation(plan.layout, block, pid::kStop));
  }
  return release;
}

HidLinkOptions LinkOptions(const Plan& plan) {
  HidLinkOptions options;
  options.name = plan.name;
  options.inputs = plan.inputs;
  options.outputs = kEnablePlace + 1;
  options.renew_every = kRenewEvery;
  options.release = ReleaseOf(plan);
  for (const int block : plan.setup.blocks) {
    if (block == 0) continue;
    options.renewed.push_back(EncodeOperation(plan.layout, block, pid::kStart));
    options.farewell.push_back(EncodeConstantForce(plan.layout, block, 0));
  }
  for (const int block : plan.setup.blocks) {
    if (block == 0) continue;
    options.farewell.push_back(EncodeOperation(plan.layout, block, pid::kStop));
    if (plan.layout.free.report.IsThere()) {
      options.farewell.push_back(EncodeBlockFree(plan.layout, block));
    }
  }
  for (const HidUsage command : {pid::kStopAll, pid::kDisable}) {
    if (plan.layout.control.command.Offers(command)) {
      options.farewell.push_back(EncodeControl(plan.layout, command));
    }
  }
  return options;
}

class PidDevice final : public Device {
 public:
  PidDevice(const std::string& path, Plan plan)
      : plan_(std::move(plan)),
        link_(path, LinkOptions(plan_)),
        newest_(plan_.inputs.size()),
        safety_at_opening_(plan_.setup.state.safety),
        is_ready_(IsReady(plan_.setup.state)) {
    // Once more through the link: a state reported between set-up and here would be missed.
    if (plan_.layout.control.command.Offers(pid::kEnable)) {
      link_.Put(kEnablePlace, EncodeControl(plan_.layout, pid::kEnable).span(), false);
    }
  }

  ~PidDevice() override { SendForce(glm::dvec3(0, 0, 0)); }

  DeviceLimits Limits() const noexcept override { return plan_.limits; }
  std::string WhyLost() override { return link_.WhyLost(); }

  DeviceStatus Read(DeviceState& state) noexcept override {
    const bool is_fresh = TakeReports();
    CheckLink();
    if (is_lost_) return DeviceStatus::kLost;
    if (!is_ready_ || link_.WasLetGo()) return DeviceStatus::kNotReady;
    if (!is_fresh) return DeviceStatus::kNoNewData;
    state = Decode();
    return DeviceStatus::kOk;
  }

  DeviceStatus Write(glm::dvec3 f_D) noexcept override {
    CheckLink();
    if (is_lost_) return DeviceStatus::kLost;
    SendForce(is_ready_ ? f_D : glm::dvec3(0, 0, 0));
    return is_ready_ ? DeviceStatus::kOk : DeviceStatus::kNotReady;
  }

 private:
  bool IsReady(const PidState& state) const noexcept {
    return state.is_enabled && !state.is_paused && state.has_power &&
           state.safety == safety_at_opening_;
  }

  void CheckLink() noexcept {
    is_lost_ = is_lost_ || !link_.IsAlive() || link_.Strays() > 0 ||
               link_.WaitingWrite() > plan_.limits.silence;
  }

  /// True if the position or a button was reported.
  bool TakeReports() noexcept {
    bool is_fresh = false;
    for (std::size_t i = 0; i < newest_.size(); ++i) {
      HidReport report;
      if (!link_.Take(i, report)) continue;
      if (report.size < plan_.input_bytes[i]) {
        is_lost_ = true;  // cut off: USB carries reports whole, so the firmware is out of step
        continue;
      }
      newest_[i] = report;
      const std::uint8_t id = plan_.inputs[i];
      if (plan_.layout.state.report.IsThere() && id == plan_.layout.state.report.id) {
        is_ready_ = IsReady(DecodeState(plan_.layout, report.span()));
      }
      is_fresh = is_fresh || IsOfStick(id);
    }
    return is_fresh && ReportOf(plan_.stick.right).size > 0 && ReportOf(plan_.stick.away).size > 0;
  }

  bool IsOfStick(std::uint8_t id) const noexcept {
    const StickLayout& stick = plan_.stick;
    return id == stick.right.report.id || id == stick.away.report.id ||
           (stick.press.IsThere() && id == stick.press.report.id);
  }

  const HidReport& ReportOf(const HidNumber& number) const noexcept {
    const auto at = std::ranges::find(plan_.inputs, number.report.id);
    return newest_[static_cast<std::size_t>(at - plan_.inputs.begin())];
  }

  double Share(const HidNumber& number, double sign) const noexcept {
    return sign * ShareOf(ReportOf(number).span(), number.bits);
  }

  DeviceState Decode() const noexcept {
    const StickLayout& stick = plan_.stick;
    DeviceState state;
    state.time = std::max(ReportOf(stick.right).time, ReportOf(stick.away).time);
    state.p_D.x = Share(stick.right, plan_.map.right.sign) * plan_.limits.workspace_D.x;
    state.p_D.y = Share(stick.away, plan_.map.away.sign) * plan_.limits.workspace_D.y;
    for (std::size_t i = 0; i < stick.buttons.size(); ++i) {
      const HidNumber& button = stick.buttons[i];
      if (ReadBits(ReportOf(button).span(), button.bits) != 0) state.buttons |= 1u << i;
    }
    state.p_D.z = HeightOf(state.buttons);
    return state;
  }

  double HeightOf(std::uint32_t buttons) const noexcept {
    if (plan_.map.press == StickMap::Press::kButton) {
      return (buttons >> plan_.map.press_button & 1) != 0 ? 0 : kLifted;
    }
    if (plan_.map.press == StickMap::Press::kAxis) {
      const double share = 0.5 + 0.5 * Share(plan_.stick.press, plan_.map.press_axis.sign);
      return share > kAtRest ? -share * plan_.press / plan_.limits.stiffness : kLifted;
    }
    return 0;
  }

  void SendForce(glm::dvec3 f_D) noexcept {
    const std::array<double, 2> sign{plan_.map.right.sign, plan_.map.away.sign};
    for (std::size_t i = 0; i < 2; ++i) {
      const int motor = plan_.motor_of_axis[i];
      if (motor < 0) continue;
      const auto m = static_cast<std::size_t>(motor);
      const double share = sign[i] * f_D[static_cast<int>(i)] / plan_.map.full_force;
      const HidReport report = EncodeConstantForce(plan_.layout, plan_.setup.blocks[m], share);
      link_.Put(m, report.span(), share != 0);
    }
  }

  const Plan plan_;
  HidLink link_;
  std::vector<HidReport> newest_;  // of each input; size 0: none yet
  bool safety_at_opening_;
  bool is_ready_;
  bool is_lost_ = false;
};

/// Which motor moves an axis of frame D; -1: none does.
int MotorFor(const AxisMap& axis, const PidLayout& layout) {
  const int motor = axis.usage - 0x30;
  return motor >= 0 && motor < 2 && layout.motors[static_cast<std::size_t>(motor)] ? motor : -1;
}

Plan MakePlan(const HidInfo& info, const DeviceProfile& profile, double tick, double press) {
  const HidDescriptor descriptor = ParseHidDescriptor(ReportDescriptorOf(info.path));
  Plan plan;
  plan.name = profile.name;
  plan.layout = FindPidLayout(descriptor);
  plan.stick = FindStick(descriptor, profile.stick);
  if (!descriptor.is_numbered || !PidReportsFit(plan.layout)) {
    throw DeviceError("the joystick's reports lack numbers or are too long: update its firmware");
  }
  for (const HidReportLayout& report : descriptor.reports) {
    if (report.type != HidReportType::kInput) continue;
    plan.inputs.push_back(report.id);
    plan.input_bytes.push_back(std::min(report.bytes, HidReport::kMostBytes));
  }
  plan.map = profile.stick;
  plan.press = press;
  plan.motor_of_axis = {MotorFor(profile.stick.right, plan.layout),
                        MotorFor(profile.stick.away, plan.layout)};
  plan.limits = LimitsOf(profile, tick);
  plan.limits.measures = {true, true, false};
  for (int i = 0; i < 2; ++i) {
    plan.limits.pushes[i] =
        plan.limits.pushes[i] && plan.motor_of_axis[static_cast<std::size_t>(i)] >= 0;
    double& reach = plan.limits.workspace_D[i];
    if (!std::isfinite(reach)) reach = kUnboundReach;
  }
  plan.limits.pushes.z = false;
  plan.limits.buttons = std::min(plan.limits.buttons, static_cast<int>(plan.stick.buttons.size()));
  return plan;
}

}  // namespace

std::unique_ptr<Device> MakePidDevice(const HidInfo& info, const DeviceProfile& profile,
                                      double tick, double press, std::string* autocentre) {
  try {
    Plan plan = MakePlan(info, profile, tick, press);
    HidHandle handle = HidHandle::Open(info.path);
    plan.setup = SetUpPid(handle, plan.layout);
    if (autocentre != nullptr) *autocentre = plan.setup.autocentre;
    return std::make_unique<PidDevice>(info.path, std::move(plan));
  } catch (const DeviceError& error) {
    throw DeviceError(fmt::format("{}: {}", profile.name, error.what()));
  }
}

}  // namespace moontrace
