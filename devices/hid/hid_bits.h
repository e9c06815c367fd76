#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace moontrace {

/// A number inside a HID report: `size` bits from bit `bit` on, least bit first, as HID packs them.
/// Counted from the report's byte 0, which holds its number.
struct HidBits {
  std::uint32_t bit = 0;
  std::uint8_t size = 0;             ///< 0 to 32; 0: the report has no such number
  std::int64_t least = 0, most = 0;  ///< logical range; a negative `least` means a signed number

  bool IsThere() const noexcept { return size > 0; }
};

/// The number, signed where its range is. Bits beyond the report's end count as 0.
std::int64_t ReadBits(std::span<const std::uint8_t> report, const HidBits& bits) noexcept;
/// Writes the number, held within its size, not its logical range. Bits beyond the end are dropped.
void WriteBits(std::span<std::uint8_t> report, const HidBits& bits, std::int64_t value) noexcept;

}  // namespace moontrace
