#include "textures/base/utf8.h"

#include <fmt/core.h>
#include <utf8proc.h>

#include <array>
#include <cstdlib>
#include <memory>

namespace moontrace {
namespace {

utf8proc_category_t Category(char32_t c) {
  return utf8proc_category(static_cast<utf8proc_int32_t>(c));
}

}  // namespace

std::size_t Decode(std::string_view utf8, char32_t& c) noexcept {
  const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(utf8.data());
  if (utf8.empty()) return 0;
  if (bytes[0] < 0x80) {
    c = bytes[0];
    return 1;
  }
  utf8proc_int32_t code = 0;
  const auto length = utf8proc_iterate(bytes, static_cast<utf8proc_ssize_t>(utf8.size()), &code);
  if (length <= 0) return 0;
  c = static_cast<char32_t>(code);
  return static_cast<std::size_t>(length);
}

std::optional<std::size_t> FirstBadUtf8(std::string_view bytes) noexcept {
  char32_t c = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = Decode(bytes.substr(at, 4), c);
    if (length == 0) return at;
    at += length;
  }
  return std::nullopt;
}

bool IsMark(char32_t c) {
  if (c < 0x300) return false;  // the first combining mark
  const auto category = Category(c);
  return category == UTF8PROC_CATEGORY_MN || category == UTF8PROC_CATEGORY_MC ||
         category == UTF8PROC_CATEGORY_ME;
}

bool IsSpaceSeparator(char32_t c) { return Category(c) == UTF8PROC_CATEGORY_ZS; }

bool IsControlCode(char32_t c) { return Category(c) == UTF8PROC_CATEGORY_CC; }

bool IsLetter(char32_t c) {
  const auto category = Category(c);
  return (category >= UTF8PROC_CATEGORY_LU && category <= UTF8PROC_CATEGORY_LO) || IsMark(c);
}

std::u32string ToCodePoints(std::string_view utf8) {
  std::u32string result;
  char32_t c = 0;
  for (std::size_t length = 0; (length = Decode(utf8, c)) > 0; utf8.remove_prefix(length)) {
    result += c;
  }
  return result;
}

std::string ToUtf8(char32_t c) {
  std::array<utf8proc_uint8_t, 4> bytes{};
  const auto length = utf8proc_encode_char(static_cast<utf8proc_int32_t>(c), bytes.data());
  return std::string(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::size_t>(length > 0 ? length : 0));
}

std::string Shown(std::string_view utf8) {
  std::string result;
  char32_t c = 0;
  std::size_t count = 0;
  for (std::size_t length = 0; (length = Decode(utf8, c)) > 0; utf8.remove_prefix(length)) {
    if (++count > 16) return result + "...";
    const auto category = Category(c);
    const bool hidden = category == UTF8PROC_CATEGORY_CN || category >= UTF8PROC_CATEGORY_ZL;
    result += hidden ? fmt::format("U+{:04X}", static_cast<unsigned>(c))
                     : std::string(utf8.substr(0, length));
  }
  return result;
}

bool IsHidden(char32_t code) noexcept {
  if ((code & 0xFFFEU) == 0xFFFEU || (code >= 0xFDD0 && code <= 0xFDEF)) return true;
  // reserved for such characters
  if (code == 0x2065 || (code >= 0xE0000 && code <= 0xE0FFF)) return true;
  const auto category = Category(code);
  return category == UTF8PROC_CATEGORY_CC || category == UTF8PROC_CATEGORY_CF ||
         category == UTF8PROC_CATEGORY_ZL || category == UTF8PROC_CATEGORY_ZP ||
         category == UTF8PROC_CATEGORY_CO;
}

bool HasHidden(std::string_view utf8) noexcept {
  char32_t c = 0;
  for (std::size_t length = 0; (length = Decode(utf8, c)) > 0; utf8.remove_prefix(length)) {
    if (IsHidden(c)) return true;
  }
  return false;
}

std::string HiddenShown(std::string_view utf8) {
  std::string shown;
  shown.reserve(utf8.size());
  char32_t c = 0;
  for (std::size_t length = 0; (length = Decode(utf8, c)) > 0; utf8.remove_prefix(length)) {
    if (IsHidden(c)) {
      shown += '?';
    } else {
      shown += utf8.substr(0, length);
    }
  }
  return shown;
}

std::string CaseFolded(std::string_view utf8) {
  const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(utf8.data());
  utf8proc_uint8_t* made = nullptr;
  const auto options =
      static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE | UTF8PROC_CASEFOLD);
  const auto length =
      utf8proc_map(bytes, static_cast<utf8proc_ssize_t>(utf8.size()), &made, options);
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> folded(made, &std::free);
  if (length < 0) return std::string(utf8);
  return {reinterpret_cast<const char*>(folded.get()), static_cast<std::size_t>(length)};
}

}  // namespace moontrace
