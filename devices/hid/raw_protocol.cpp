#include "devices/hid/raw_protocol.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "devices/core/little_endian.h"

namespace moontrace {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t kVersion = 1;
constexpr std::array<std::uint8_t, 4> kMagic{'M', 'O', 'O', 'N'};
constexpr double kMicro = 1e-6, kMilli = 1e-3, kNano = 1e-9;

// Bits of an input report's status and of an output report's flags.
constexpr std::uint8_t kReady = 1, kHasLetGo = 2, kVelocityKnown = 4;
constexpr std::uint8_t kPush = 1;

template <std::integral T>
T ToWire(double value, double unit) noexcept {
  const double counts = std::round(value / unit);
  if (!std::isfinite(counts)) return 0;
  constexpr auto kLeast = static_cast<double>(std::numeric_limits<T>::min());
  constexpr auto kMost = static_cast<double>(std::numeric_limits<T>::max());
  return static_cast<T>(std::clamp(counts, kLeast, kMost));
}

template <std::integral T>
glm::dvec3 GetVector(Bytes report, std::size_t place, double unit) noexcept {
  glm::dvec3 out{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    out[i] = unit * GetLittle<T>(report, place + sizeof(T) * static_cast<std::size_t>(i));
  }
  return out;
}

template <std::integral T>
void PutVector(std::span<std::uint8_t> report, std::size_t place, const glm::dvec3& value,
               double unit) noexcept {
  for (int i = 0; i < 3; ++i) {
    PutLittle(report, place + sizeof(T) * static_cast<std::size_t>(i), ToWire<T>(value[i], unit));
  }
}

bool IsReport(Bytes report, std::uint8_t number, std::size_t size) noexcept {
  return report.size() >= size && report[0] == number &&
         GetLittle<std::uint16_t>(report, size - 2) == RawCheckSum(report.first(size - 2));
}

void PutCheckSum(std::span<std::uint8_t> report) noexcept {
  const std::size_t place = report.size() - 2;
  PutLittle(report, place, RawCheckSum(report.first(place)));
}

glm::bvec3 Axes(unsigned bits) noexcept {
  return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
}

unsigned Bits(glm::bvec3 axes) noexcept {
  return (axes.x ? 1u : 0u) | (axes.y ? 2u : 0u) | (axes.z ? 4u : 0u);
}

}  // namespace

std::uint16_t RawCheckSum(Bytes bytes) noexcept {
  unsigned sum = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    sum ^= static_cast<unsigned>(byte) << 8;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 0x8000) != 0 ? (sum << 1) ^ 0x1021 : sum << 1;
  }
  return static_cast<std::uint16_t>(sum);
}

std::optional<RawInput> DecodeRawInput(Bytes report) noexcept {
  if (!IsReport(report, kRawInputNumber, kRawInputBytes)) return std::nullopt;
  RawInput input;
  input.ready = (report[1] & kReady) != 0;
  input.has_let_go = (report[1] & kHasLetGo) != 0;
  input.velocity_known = (report[1] & kVelocityKnown) != 0;
  input.sequence = GetLittle<std::uint16_t>(report, 2);
  input.p_D = GetVector<std::int32_t>(report, 4, kMicro);
  input.v_D = GetVector<std::int32_t>(report, 16, kMicro);
  input.buttons = GetLittle<std::uint32_t>(report, 28);
  input.answered = GetLittle<std::uint16_t>(report, 32);
  return input;
}

std::array<std::uint8_t, kRawInputBytes> EncodeRawInput(const RawInput& input) noexcept {
  std::array<std::uint8_t, kRawInputBytes> report{};
  report[0] = kRawInputNumber;
  report[1] =
      static_cast<std::uint8_t>((input.ready ? kReady : 0) | (input.has_let_go ? kHasLetGo : 0) |
                                (input.velocity_known ? kVelocityKnown : 0));
  PutLittle(report, 2, input.sequence);
  PutVector<std::int32_t>(report, 4, input.p_D, kMicro);
  PutVector<std::int32_t>(report, 16, input.v_D, kMicro);
  PutLittle(report, 28, input.buttons);
  PutLittle(report, 32, input.answered);
  PutCheckSum(report);
  return report;
}

std::optional<RawOutput> DecodeRawOutput(Bytes report) noexcept {
  if (!IsReport(report, kRawOutputNumber, kRawOutputBytes)) return std::nullopt;
  RawOutput output;
  output.push = (report[1] & kPush) != 0;
  output.sequence = GetLittle<std::uint16_t>(report, 2);
  output.f_D = GetVector<std::int32_t>(report, 4, kMilli);
  return output;
}

std::array<std::uint8_t, kRawOutputBytes> EncodeRawOutput(const RawOutput& output) noexcept {
  std::array<std::uint8_t, kRawOutputBytes> report{};
  report[0] = kRawOutputNumber;
  report[1] = output.push ? kPush : std::uint8_t{0};
  PutLittle(report, 2, output.sequence);
  PutVector<std::int32_t>(report, 4, output.f_D, kMilli);
  PutCheckSum(report);
  return report;
}

std::optional<RawHello> DecodeRawHello(Bytes report) noexcept {
  if (!IsReport(report, kRawHelloNumber, kRawHelloBytes)) return std::nullopt;
  if (report[1] != kVersion || !std::equal(kMagic.begin(), kMagic.end(), report.begin() + 2)) {
    return std::nullopt;
  }
  RawHello hello;
  hello.dead_man = kMilli * GetLittle<std::uint16_t>(report, 6);
  hello.workspace_D = GetVector<std::uint32_t>(report, 8, kMicro / 2);
  hello.peak_force = kMilli * GetLittle<std::uint32_t>(report, 20);
  hello.rate = GetLittle<std::uint16_t>(report, 24);
  hello.buttons = report[26];
  hello.measures = Axes(report[27]);
  hello.pushes = Axes(static_cast<unsigned>(report[27]) >> 3);
  hello.position_step = kNano * GetLittle<std::uint32_t>(report, 28);
  hello.force_step = kMicro * GetLittle<std::uint32_t>(report, 32);
  return hello;
}

std::array<std::uint8_t, kRawHelloBytes> EncodeRawHello(const RawHello& hello) noexcept {
  std::array<std::uint8_t, kRawHelloBytes> report{};
  report[0] = kRawHelloNumber;
  report[1] = kVersion;
  std::copy(kMagic.begin(), kMagic.end(), report.begin() + 2);
  PutLittle(report, 6, ToWire<std::uint16_t>(hello.dead_man, kMilli));
  PutVector<std::uint32_t>(report, 8, hello.workspace_D, kMicro / 2);
  PutLittle(report, 20, ToWire<std::uint32_t>(hello.peak_force, kMilli));
  PutLittle(report, 24, ToWire<std::uint16_t>(hello.rate, 1));
  report[26] = static_cast<std::uint8_t>(std::clamp(hello.buttons, 0, 32));
  report[27] = static_cast<std::uint8_t>(Bits(hello.measures) | Bits(hello.pushes) << 3);
  PutLittle(report, 28, ToWire<std::uint32_t>(hello.position_step, kNano));
  PutLittle(report, 32, ToWire<std::uint32_t>(hello.force_step, kMicro));
  PutCheckSum(report);
  return report;
}

}  // namespace moontrace
