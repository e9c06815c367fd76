#include "textures/base/digest.h"

#include <fmt/core.h>

#include <charconv>

namespace moontrace {

std::string ToHex(std::uint64_t value) { return fmt::format("{:#018x}", value); }

std::optional<std::uint64_t> FromHex(std::string_view text) {
  if (text.size() != 18 || text.substr(0, 2) != "0x") return std::nullopt;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data() + 2, text.data() + 18, value, 16);
  if (error != std::errc() || end != text.data() + 18 || ToHex(value) != text) return std::nullopt;
  return value;
}

}  // namespace moontrace
