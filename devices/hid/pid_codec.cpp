#include "devices/hid/pid_codec.h"

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

HidReport Blank(const HidReportId& id) noexcept {
  HidReport report;
  report.bytes[0] = id.id;
  report.size = static_cast<std::uint16_t>(std::min(id.bytes, HidReport::kMostBytes));
  return report;
}

std::span<std::uint8_t> BytesOf(HidReport& report) noexcept {
  return {report.bytes.data(), report.size};
}

/// Longest finite value: all bits set, and 0, mean "for ever".
std::int64_t Milliseconds(const HidBits& bits, double seconds) noexcept {
  const std::int64_t most = bits.most > 1 ? bits.most - 1 : (std::int64_t{1} << bits.size) - 2;
  return std::clamp<std::int64_t>(std::llround(seconds * 1e3), 1, std::max<std::int64_t>(most, 1));
}

}  // namespace

bool PidReportsFit(const PidLayout& layout) noexcept {
  for (const HidReportId& id :
       {layout.effect.report, layout.constant.report, layout.operation.report, layout.free.report,
        layout.control.report, layout.gain.report, layout.create.report, layout.load.report,
        layout.state.report}) {
    if (id.bytes > HidReport::kMostBytes) return false;
  }
  return true;
}

HidReport EncodeSetEffect(const PidLayout& layout, int block, int axis, double duration) noexcept {
  const auto& effect = layout.effect;
  HidReport report = Blank(effect.report);
  const auto bytes = BytesOf(report);
  const auto i = static_cast<std::size_t>(axis);
  WriteBits(bytes, effect.block, block);
  effect.type.Choose(bytes, pid::kConstantForce);
  WriteBits(bytes, effect.duration, Milliseconds(effect.duration, duration));
  WriteBits(bytes, effect.gain, effect.gain.most);
  WriteBits(bytes, effect.axis_enable[i], 1);
  WriteBits(bytes, effect.direction_enable, 1);
  // Directions are counted clockwise from away, the factor on X is the sine, that on Y, which grows
  // towards the person, less the cosine: X at a quarter turn, Y at a half.
  const HidBits& direction = effect.direction[0];
  const double turn = axis == 0 ? 0.25 : 0.5;
  const auto range = static_cast<double>(direction.most - direction.least);
  WriteBits(bytes, direction, direction.least + std::llround(turn * range));
  return report;
}

HidReport EncodeConstantForce(const PidLayout& layout, int block, double share) noexcept {
  const HidBits& magnitude = layout.constant.magnitude;
  HidReport report = Blank(layout.constant.report);
  const double s = std::isfinite(share) ? std::clamp(share, -1.0, 1.0) : 0;
  // A range without negative numbers has its zero in the middle.
  const double middle =
      magnitude.least < 0 ? 0 : 0.5 * static_cast<double>(magnitude.least + magnitude.most);
  const double reach = static_cast<double>(magnitude.most) - middle;
  WriteBits(BytesOf(report), layout.constant.block, block);
  WriteBits(BytesOf(report), magnitude, std::llround(middle + s * reach));
  return report;
}

HidReport EncodeOperation(const PidLayout& layout, int block, HidUsage operation) noexcept {
  HidReport report = Blank(layout.operation.report);
  WriteBits(BytesOf(report), layout.operation.block, block);
  layout.operation.operation.Choose(BytesOf(report), operation);
  WriteBits(BytesOf(report), layout.operation.loops, 1);
  return report;
}

HidReport EncodeBlockFree(const PidLayout& layout, int block) noexcept {
  HidReport report = Blank(layout.free.report);
  WriteBits(BytesOf(report), layout.free.block, block);
  return report;
}

HidReport EncodeControl(const PidLayout& layout, HidUsage command) noexcept {
  HidReport report = Blank(layout.control.report);
  layout.control.command.Choose(BytesOf(report), command);
  return report;
}

HidReport EncodeDeviceGain(const PidLayout& layout) noexcept {
  HidReport report = Blank(layout.gain.report);
  WriteBits(BytesOf(report), layout.gain.gain, layout.gain.gain.most);
  return report;
}

HidReport EncodeCreateEffect(const PidLayout& layout) noexcept {
  HidReport report = Blank(layout.create.report);
  layout.create.type.Choose(BytesOf(report), pid::kConstantForce);
  return report;  // byte count 0: constant forces bring no samples
}

PidBlockLoad DecodeBlockLoad(const PidLayout& layout,
                             std::span<const std::uint8_t> report) noexcept {
  using Status = PidBlockLoad::Status;
  PidBlockLoad load;
  load.block = static_cast<int>(ReadBits(report, layout.load.block));
  const HidChoice& status = layout.load.status;
  if (status.IsChosen(report, pid::kLoadSuccess)) load.status = Status::kSuccess;
  if (status.IsChosen(report, pid::kLoadFull)) load.status = Status::kFull;
  if (status.IsChosen(report, pid::kLoadError)) load.status = Status::kError;
  return load;
}

PidState DecodeState(const PidLayout& layout, std::span<const std::uint8_t> report) noexcept {
  const auto& s = layout.state;
  const auto bit = [&](const HidBits& bits, bool otherwise) {
    return bits.IsThere() ? ReadBits(report, bits) != 0 : otherwise;
  };
  PidState state;
  state.is_paused = bit(s.paused, false);
  state.is_enabled = bit(s.enabled, true);
  state.has_power = bit(s.power, true);
  state.safety = bit(s.safety, false);
  state.is_playing = bit(s.playing, false);
  state.block = static_cast<int>(ReadBits(report, s.block));
  return state;
}

double ShareOf(std::span<const std::uint8_t> report, const HidBits& bits) noexcept {
  const auto range = static_cast<double>(bits.most - bits.least);
  const auto value = static_cast<double>(ReadBits(report, bits) - bits.least);
  return std::clamp(2 * value / range - 1, -1.0, 1.0);
}

}  // namespace moontrace
