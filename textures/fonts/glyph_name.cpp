#include "textures/fonts/glyph_name.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>

#include "textures/base/utf8.h"

namespace moontrace {
namespace {

constexpr std::string_view kUni = "uni";

bool IsAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool IsPlain(std::string_view name) {
  const auto allowed = [](char c) {
    return IsAsciiLetter(c) || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
  };
  return !name.empty() && IsAsciiLetter(name[0]) && std::all_of(name.begin(), name.end(), allowed);
}

/// Appends the character that these digits number. False where they number none to be shown.
bool AppendNumbered(std::string_view digits, std::string& text) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F'); };
  if (!std::all_of(digits.begin(), digits.end(), is_digit)) return false;
  unsigned code = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (read.ec != std::errc() || surrogate || code > 0x10FFFF || IsHidden(code)) return false;
  text += ToUtf8(code);
  return true;
}

/// Appends what one component ("uni00220023", "u1F600") holds.
bool AppendComponent(std::string_view component, std::string& text) {
  if (component.substr(0, kUni.size()) == kUni) {
    const std::string_view digits = component.substr(kUni.size());
    if (digits.empty() || digits.size() % 4 != 0) return false;
    for (std::size_t i = 0; i < digits.size(); i += 4) {
      if (!AppendNumbered(digits.substr(i, 4), text)) return false;
    }
    return true;
  }
  const bool one = component.size() >= 5 && component.size() <= 7 && component[0] == 'u';
  return one && AppendNumbered(component.substr(1), text);
}

}  // namespace

std::string FontGlyphName(std::string_view name) {
  if (IsPlain(name)) return std::string(name);
  std::string result;
  bool in_uni = false;
  for (const char32_t c : ToCodePoints(name)) {
    const bool beyond = c > 0xFFFF;
    if (!result.empty() && (beyond || !in_uni)) result += '_';
    if (!beyond && !in_uni) result += kUni;
    result += fmt::format(fmt::runtime(beyond ? "u{:X}" : "{:04X}"), static_cast<unsigned>(c));
    in_uni = !beyond;
  }
  return result;
}

std::string CharactersNamed(std::string_view glyph_name) {
  std::string text;
  for (std::size_t at = 0; at <= glyph_name.size();) {
    const std::size_t end = std::min(glyph_name.find('_', at), glyph_name.size());
    if (!AppendComponent(glyph_name.substr(at, end - at), text)) return {};
    at = end + 1;
  }
  return text;
}

}  // namespace moontrace
