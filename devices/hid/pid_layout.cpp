#include "devices/hid/pid_layout.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "devices/core/device_error.h"

namespace moontrace {
namespace {

constexpr HidUsage kDesktop = 0x010000, kButtonPage = 0x090000, kOrdinal = 0x0a0000;
constexpr std::size_t kMostButtons = 32;

bool Lies(const HidField& field, HidUsage collection) {
  return std::ranges::find(field.collections, collection) != field.collections.end();
}

/// The number that belongs to `usage` in a report; below `collection` if it is not 0.
HidBits BitsOf(const HidReportLayout& report, HidUsage usage, HidUsage collection = 0) {
  for (const HidField& field : report.fields) {
    if (collection != 0 && !Lies(field, collection)) continue;
    const auto found = std::ranges::find(field.usages, usage);
    if (found == field.usages.end()) continue;
    const auto i = static_cast<std::uint32_t>(found - field.usages.begin());
    if (field.is_variable && i < field.count) return field.At(i);
    if (!field.is_variable && field.usages.size() == 1) return field.first;  // a lone "array"
  }
  return {};
}

/// Every option that the report offers of the PID page, by number or by bits.
HidChoice ChoiceOf(const HidReportLayout& report, std::initializer_list<HidUsage> wanted) {
  HidChoice choice;
  for (const HidUsage usage : wanted) {
    for (const HidField& field : report.fields) {
      const auto found = std::ranges::find(field.usages, usage);
      if (found == field.usages.end() || field.first.size == 0) continue;
      const auto i = static_cast<std::uint32_t>(found - field.usages.begin());
      if (field.is_variable && i >= field.count) continue;
      // A bit is on when it is 1, whatever logical range the firmware declares for it.
      choice.options.push_back(field.is_variable
                                   ? HidChoice::Option{usage, field.At(i), 1}
                                   : HidChoice::Option{usage, field.first, field.first.least + i});
      break;
    }
  }
  return choice;
}

/// The first report of a type that has the usage, below `collection` if it is not 0.
const HidReportLayout* ReportWith(const HidDescriptor& descriptor, HidReportType type,
                                  HidUsage usage, HidUsage collection = 0) {
  for (const HidReportLayout& report : descriptor.reports) {
    if (report.type != type) continue;
    for (const HidField& field : report.fields) {
      if ((collection == 0 || Lies(field, collection)) &&
          std::ranges::find(field.usages, usage) != field.usages.end()) {
        return &report;
      }
    }
  }
  return nullptr;
}

HidReportId IdOf(const HidReportLayout& report) { return {report.id, report.bytes}; }

void FindEffect(const HidDescriptor& d, PidLayout& out) {
  const auto* const report = ReportWith(d, HidReportType::kOutput, pid::kPage | 0x50);
  if (report == nullptr) return;
  auto& effect = out.effect;
  effect.report = IdOf(*report);
  effect.block = BitsOf(*report, pid::kPage | 0x22);
  effect.duration = BitsOf(*report, pid::kPage | 0x50);
  effect.gain = BitsOf(*report, pid::kPage | 0x52);
  effect.direction_enable = BitsOf(*report, pid::kPage | 0x56);
  effect.type = ChoiceOf(*report, {pid::kConstantForce});
  for (std::uint32_t i = 0; i < 2; ++i) {
    effect.axis_enable[i] = BitsOf(*report, kDesktop | (0x30 + i), pid::kPage | 0x55);
    effect.direction[i] = BitsOf(*report, kOrdinal | (1 + i), pid::kPage | 0x57);
    out.motors[i] = effect.axis_enable[i].IsThere();
  }
  if (!out.motors[0] && !out.motors[1]) {  // axes not named: as many as directions
    out.motors = {true, effect.direction[1].IsThere()};
  }
}

void FindForce(const HidDescriptor& d, PidLayout& out) {
  // Periodic effects have a magnitude too: the collection distinguishes them.
  const auto* const report =
      ReportWith(d, HidReportType::kOutput, pid::kPage | 0x70, pid::kPage | 0x73);
  if (report == nullptr) return;
  out.constant.report = IdOf(*report);
  out.constant.block = BitsOf(*report, pid::kPage | 0x22);
  out.constant.magnitude = BitsOf(*report, pid::kPage | 0x70);
}

void FindOperations(const HidDescriptor& d, PidLayout& out) {
  if (const auto* report = ReportWith(d, HidReportType::kOutput, pid::kStart)) {
    out.operation.report = IdOf(*report);
    out.operation.block = BitsOf(*report, pid::kPage | 0x22);
    out.operation.loops = BitsOf(*report, pid::kPage | 0x7c);
    out.operation.operation = ChoiceOf(*report, {pid::kStart, pid::kStop});
  }
  if (const auto* report =
          ReportWith(d, HidReportType::kOutput, pid::kPage | 0x22, pid::kPage | 0x90)) {
    out.free.report = IdOf(*report);
    out.free.block = BitsOf(*report, pid::kPage | 0x22, pid::kPage | 0x90);
  }
  if (const auto* report = ReportWith(d, HidReportType::kOutput, pid::kEnable)) {
    out.control.report = IdOf(*report);
    out.control.command =
        ChoiceOf(*report, {pid::kEnable, pid::kDisable, pid::kStopAll, pid::kReset});
  }
  if (const auto* report = ReportWith(d, HidReportType::kOutput, pid::kPage | 0x7e)) {
    out.gain.report = IdOf(*report);
    out.gain.gain = BitsOf(*report, pid::kPage | 0x7e);
  }
}

void FindPool(const HidDescriptor& d, PidLayout& out) {
  if (const auto* report = ReportWith(d, HidReportType::kFeature, pid::kConstantForce)) {
    out.create.report = IdOf(*report);
    out.create.type = ChoiceOf(*report, {pid::kConstantForce});
  }
  if (const auto* report = ReportWith(d, HidReportType::kFeature, pid::kLoadSuccess)) {
    out.load.report = IdOf(*report);
    out.load.block = BitsOf(*report, pid::kPage | 0x22);
    out.load.status = ChoiceOf(*report, {pid::kLoadSuccess, pid::kLoadFull, pid::kLoadError});
  }
  if (const auto* report = ReportWith(d, HidReportType::kInput, pid::kPage | 0xa0)) {
    out.state.report = IdOf(*report);
    out.state.paused = BitsOf(*report, pid::kPage | 0x9f);
    out.state.enabled = BitsOf(*report, pid::kPage | 0xa0);
    out.state.safety = BitsOf(*report, pid::kPage | 0xa4);
    out.state.power = BitsOf(*report, pid::kPage | 0xa6);
    out.state.playing = BitsOf(*report, pid::kPage | 0x94);
    out.state.block = BitsOf(*report, pid::kPage | 0x22);
  }
}

std::string MissingFrom(const PidLayout& layout) {
  std::string missing;
  const auto need = [&missing](bool is_there, const char* name) {
    if (!is_there) missing += (missing.empty() ? "" : ", ") + std::string(name);
  };
  need(layout.effect.report.IsThere(), "set effect (21) with a duration (50)");
  if (layout.effect.report.IsThere()) {
    need(layout.effect.block.IsThere(), "its block index (22)");
    need(layout.effect.duration.IsThere(), "its duration (50)");
    need(layout.effect.type.Offers(pid::kConstantForce), "its type constant force (26)");
  }
  need(layout.constant.block.IsThere() && layout.constant.magnitude.IsThere(),
       "set constant force (73)");
  need(layout.operation.block.IsThere() && layout.operation.operation.Offers(pid::kStart) &&
           layout.operation.operation.Offers(pid::kStop),
       "effect operation (77) with start and stop");
  const bool hands_out = layout.create.report.IsThere();
  need(hands_out == (layout.load.block.IsThere() && layout.load.status.Offers(pid::kLoadSuccess)),
       hands_out ? "block load (89)" : "create new effect (AB)");
  return missing;
}

HidNumber AxisOf(const HidDescriptor& descriptor, std::uint16_t usage) {
  const HidUsage full = kDesktop | usage;
  const auto* const report = ReportWith(descriptor, HidReportType::kInput, full);
  if (report == nullptr) {
    throw DeviceError(
        fmt::format("the device lacks axis {:02X}, which its profile names: correct that", usage));
  }
  const HidBits bits = BitsOf(*report, full);
  if (!bits.IsThere() || bits.most <= bits.least) {
    throw DeviceError(
        fmt::format("the device tells no range of axis {:02X}: update its firmware", usage));
  }
  return {IdOf(*report), bits};
}

}  // namespace

bool HidChoice::Offers(HidUsage usage) const noexcept {
  return std::ranges::any_of(options, [&](const Option& o) { return o.usage == usage; });
}

void HidChoice::Choose(std::span<std::uint8_t> report, HidUsage usage) const noexcept {
  for (const Option& option : options) {
    if (option.usage == usage) WriteBits(report, option.bits, option.value);
  }
}

bool HidChoice::IsChosen(std::span<const std::uint8_t> report, HidUsage usage) const noexcept {
  return std::ranges::any_of(options, [&](const Option& o) {
    if (o.usage != usage) return false;
    const std::int64_t value = ReadBits(report, o.bits);
    return o.bits.size == 1 ? value != 0 : value == o.value;
  });
}

bool SpeaksPid(const HidDescriptor& descriptor) {
  return ReportWith(descriptor, HidReportType::kOutput, pid::kPage | 0x70) != nullptr ||
         ReportWith(descriptor, HidReportType::kOutput, pid::kPage | 0x50) != nullptr;
}

PidLayout FindPidLayout(const HidDescriptor& descriptor) {
  PidLayout layout;
  FindEffect(descriptor, layout);
  FindForce(descriptor, layout);
  FindOperations(descriptor, layout);
  FindPool(descriptor, layout);
  const std::string missing = MissingFrom(layout);
  // Gamepads borrow a magnitude and a duration of PID for their rumble, and have no effects.
  if (!layout.constant.report.IsThere() && !layout.operation.report.IsThere() &&
      ReportWith(descriptor, HidReportType::kOutput, pid::kPage | 0x70, pid::kPage | 0x21) !=
          nullptr) {
    throw DeviceError("it is no force-feedback device: its motors only rumble");
  }
  if (!missing.empty()) {
    throw DeviceError(
        fmt::format("the device's force feedback (PID) lacks {}: update its firmware", missing));
  }
  return layout;
}

StickLayout FindStick(const HidDescriptor& descriptor, const StickMap& map) {
  StickLayout stick;
  stick.right = AxisOf(descriptor, map.right.usage);
  stick.away = AxisOf(descriptor, map.away.usage);
  if (map.press == StickMap::Press::kAxis) stick.press = AxisOf(descriptor, map.press_axis.usage);
  for (const HidReportLayout& report : descriptor.reports) {
    if (report.type != HidReportType::kInput) continue;
    for (const HidField& field : report.fields) {
      if (!field.is_variable || field.usages.empty() || field.first.size != 1) continue;
      if ((field.usages.front() & 0xffff0000) != kButtonPage) continue;
      for (std::uint32_t i = 0; i < field.count && stick.buttons.size() < kMostButtons; ++i) {
        stick.buttons.push_back({IdOf(report), field.At(i)});
      }
    }
  }
  return stick;
}

}  // namespace moontrace
