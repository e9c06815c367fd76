#include "devices/hid/raw_device.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "devices/core/device_error.h"
#include "devices/hid/hid_link.h"

namespace moontrace {
namespace {

constexpr double kKeepAlive = 0.005;    // [s]
constexpr double kLongestWrite = 0.25;  // a device that takes nothing for so long is lost [s]

HidReport ToReport(const RawOutput& output) {
  const auto bytes = EncodeRawOutput(output);
  HidReport report;
  report.size = static_cast<std::uint16_t>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), report.bytes.begin());
  return report;
}

HidLinkOptions LinkOptions(const std::string& name) {
  HidLinkOptions options;
  options.inputs = {kRawInputNumber};
  options.repeat_every = kKeepAlive;
  options.farewell = options.release = {ToReport({})};
  options.name = name;
  return options;
}

class RawDevice final : public Device {
 public:
  RawDevice(const std::string& path, const std::string& name, const DeviceLimits& limits)
      : limits_(limits), link_(path, LinkOptions(name)) {}

  DeviceLimits Limits() const noexcept override { return limits_; }
  std::string WhyLost() override { return link_.WhyLost(); }

  DeviceStatus Read(DeviceState& state) noexcept override {
    if (IsLost()) return Lose();
    if (link_.WasLetGo()) return NotReady();
    HidReport report;
    if (!link_.Take(0, report)) return is_ready_ ? DeviceStatus::kNoNewData : NotReady();
    const std::optional<RawInput> input = DecodeRawInput(report.span());
    if (!input) return Lose();
    is_ready_ = input->ready;
    if (!is_ready_) return NotReady();
    if (has_read_ && input->sequence == sequence_in_) return DeviceStatus::kNoNewData;
    has_read_ = true;
    sequence_in_ = input->sequence;
    state.time = report.time;
    state.p_D = input->p_D;
    state.v_D = input->v_D;
    state.velocity_known = input->velocity_known;
    state.buttons = input->buttons;
    return DeviceStatus::kOk;
  }

  DeviceStatus Write(glm::dvec3 f_D) noexcept override {
    if (IsLost()) return Lose();
    if (!is_ready_) return NotReady();
    RawOutput output{sequence_out_++, true, {0, 0, 0}};
    for (int i = 0; i < 3; ++i) {
      const bool may = limits_.pushes[i] && std::isfinite(f_D[i]);
      output.f_D[i] = may ? std::clamp(f_D[i], -limits_.peak_force, limits_.peak_force) : 0;
    }
    link_.Put(0, EncodeRawOutput(output), output.f_D != glm::dvec3(0, 0, 0));
    return DeviceStatus::kOk;
  }

 private:
  bool IsLost() const noexcept {
    return is_lost_ || !link_.IsAlive() || link_.Strays() > 0 ||
           link_.WaitingWrite() > kLongestWrite;
  }
  DeviceStatus Lose() noexcept {
    is_lost_ = true;
    LetGo();
    return DeviceStatus::kLost;
  }
  DeviceStatus NotReady() noexcept {
    LetGo();
    return DeviceStatus::kNotReady;
  }
  void LetGo() noexcept {
    link_.Put(0, EncodeRawOutput({sequence_out_++, false, {0, 0, 0}}), false);
  }

  const DeviceLimits limits_;
  HidLink link_;
  bool is_lost_ = false, is_ready_ = true, has_read_ = false;
  std::uint16_t sequence_in_ = 0, sequence_out_ = 0;
};

[[noreturn]] void Refuse(const std::string& path, const std::string& why) {
  throw DeviceError(fmt::format("{}: {}: see devices/raw_protocol.md", path, why));
}

void CheckHello(const std::string& path, const RawHello& hello) {
  if (!(hello.dead_man > 0 && hello.dead_man <= kRawLongestDeadMan)) {
    Refuse(path,
           fmt::format("its dead-man takes {:.0f} ms, it must be 1 to 20", hello.dead_man * 1e3));
  }
  if (!(hello.rate >= 10 && hello.rate <= 10000)) {
    Refuse(path, fmt::format("its rate is {:.0f} Hz, it must be 10 to 10000", hello.rate));
  }
  if (glm::any(hello.pushes) && !(hello.peak_force > 0)) {
    Refuse(path, "it pushes with a peak force of 0");
  }
  for (int i = 0; i < 3; ++i) {
    if (hello.measures[i] && !(hello.workspace_D[i] > 0)) Refuse(path, "its workspace is empty");
  }
}

}  // namespace

bool OffersRawProtocol(const HidInfo& info) {
  return std::any_of(info.usages.begin(), info.usages.end(), [](const HidInfo::Usage& usage) {
    return usage.page == kRawUsagePage && usage.id == kRawUsage;
  });
}

RawHello ReadRawHello(const std::string& path) {
  HidHandle handle = HidHandle::Open(path);
  std::array<std::uint8_t, 65> report{};
  report[0] = kRawHelloNumber;
  const int size = handle.GetFeature(report);
  if (size <= 0) Refuse(path, "it does not tell what it is (feature report 3)");
  const auto bytes = std::min(static_cast<std::size_t>(size), report.size());
  const std::optional<RawHello> hello = DecodeRawHello(std::span(report).first(bytes));
  if (!hello) Refuse(path, "what it tells of itself (feature report 3) is not of version 1");
  CheckHello(path, *hello);
  return *hello;
}

DeviceProfile WithHello(DeviceProfile profile, const RawHello& hello) {
  DeviceLimits& limits = profile.limits;
  limits.measures = hello.measures;
  limits.pushes = hello.pushes;
  limits.buttons = hello.buttons;
  limits.workspace_D = hello.workspace_D;
  limits.dead_man = hello.dead_man;
  limits.peak_force = std::min(limits.peak_force, hello.peak_force);
  limits.continuous_force = std::min(limits.continuous_force, limits.peak_force);
  profile.rate = hello.rate;
  profile.position_step = hello.position_step;
  profile.force_step = hello.force_step;
  return profile;
}

std::unique_ptr<Device> MakeRawDevice(const HidInfo& info, const DeviceProfile& profile,
                                      double tick) {
  const DeviceProfile full = WithHello(profile, ReadRawHello(info.path));
  return std::make_unique<RawDevice>(info.path, profile.name, LimitsOf(full, tick));
}

}  // namespace moontrace
