#include "textures/base/utf8_check.h"

#include <cstdint>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

using Byte = std::uint8_t;

bool Within(Byte byte, Byte low, Byte high) { return low <= byte && byte <= high; }

/// Bytes of the character that starts here, 0 if it is broken.
std::size_t LengthOf(std::string_view bytes) {
  const auto at = [&](std::size_t i) { return i < bytes.size() ? static_cast<Byte>(bytes[i]) : 0; };
  const auto tail = [&](std::size_t i) { return Within(static_cast<Byte>(at(i)), 0x80, 0xBF); };
  const Byte first = static_cast<Byte>(at(0)), second = static_cast<Byte>(at(1));
  if (first < 0x80) return 1;
  if (Within(first, 0xC2, 0xDF)) return tail(1) ? 2 : 0;
  if (Within(first, 0xE0, 0xEF)) {
    const Byte low = first == 0xE0 ? 0xA0 : 0x80, high = first == 0xED ? 0x9F : 0xBF;
    return Within(second, low, high) && tail(2) ? 3 : 0;
  }
  if (!Within(first, 0xF0, 0xF4)) return 0;
  const Byte low = first == 0xF0 ? 0x90 : 0x80, high = first == 0xF4 ? 0x8F : 0xBF;
  return Within(second, low, high) && tail(2) && tail(3) ? 4 : 0;
}

}  // namespace

std::optional<std::size_t> FirstBadUtf8(std::string_view bytes) noexcept {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = LengthOf(bytes.substr(at, 4));
    if (length == 0) return at;
    at += length;
  }
  return std::nullopt;
}

void RequireUtf8(std::string_view bytes, const std::string& file_name) {
  const std::optional<std::size_t> bad = FirstBadUtf8(bytes);
  if (!bad) return;
  const std::string_view mark = bytes.substr(0, 2);
  const bool wide = mark == "\xFF\xFE" || mark == "\xFE\xFF";
  const TextPlace place = PlaceOf(bytes, *bad);
  throw InputError(file_name + ":" + std::to_string(place.line) + ":" +
                   std::to_string(place.column) + ": " +
                   (wide ? "this is UTF-16" : "this is not UTF-8") + "; save it as UTF-8");
}

}  // namespace moontrace
