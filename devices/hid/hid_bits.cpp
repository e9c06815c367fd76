#include "devices/hid/hid_bits.h"

#include <algorithm>

namespace moontrace {

std::int64_t ReadBits(std::span<const std::uint8_t> report, const HidBits& bits) noexcept {
  std::uint64_t value = 0;
  for (std::uint32_t i = 0; i < bits.size; ++i) {
    const std::size_t at = (std::size_t{bits.bit} + i) / 8;
    if (at >= report.size()) break;
    const std::uint64_t one = (static_cast<std::uint64_t>(report[at]) >> ((bits.bit + i) % 8)) & 1;
    value |= one << i;
  }
  const bool is_negative = bits.least < 0 && bits.size > 0 && (value >> (bits.size - 1) & 1) != 0;
  return static_cast<std::int64_t>(value) - (is_negative ? std::int64_t{1} << bits.size : 0);
}

void WriteBits(std::span<std::uint8_t> report, const HidBits& bits, std::int64_t value) noexcept {
  if (!bits.IsThere()) return;
  const std::int64_t span = std::int64_t{1} << bits.size;
  const bool is_signed = bits.least < 0;
  const std::int64_t held = is_signed ? std::clamp(value, -span / 2, span / 2 - 1)
                                      : std::clamp<std::int64_t>(value, 0, span - 1);
  for (std::uint32_t i = 0; i < bits.size; ++i) {
    const std::size_t at = (std::size_t{bits.bit} + i) / 8;
    if (at >= report.size()) return;
    const auto mask = static_cast<std::uint8_t>(1u << ((bits.bit + i) % 8));
    const bool one = (static_cast<std::uint64_t>(held) >> i & 1) != 0;
    report[at] = static_cast<std::uint8_t>(one ? report[at] | mask : report[at] & ~mask);
  }
}

}  // namespace moontrace
