#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace moontrace {

/// The integer whose bytes stand at `place`, the lowest first. The span must hold them.
template <std::integral T>
constexpr T GetLittle(std::span<const std::uint8_t> bytes, std::size_t place) noexcept {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    value |= static_cast<std::uint64_t>(bytes[place + i]) << (8 * i);
  }
  return static_cast<T>(value);
}

/// Writes an integer at `place`, the lowest byte first. The span must hold it.
template <std::integral T>
constexpr void PutLittle(std::span<std::uint8_t> bytes, std::size_t place, T value) noexcept {
  const auto bits = static_cast<std::uint64_t>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bytes[place + i] = static_cast<std::uint8_t>(bits >> (8 * i));
  }
}

}  // namespace moontrace
