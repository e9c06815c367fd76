#include "textures/base/hidden_character.h"

#include <algorithm>
#include <cstddef>

namespace moontrace {

namespace {

struct Range {
  char32_t first, last;
};

/// Unicode 15, UnicodeData.txt.
constexpr Range kHidden[] = {
    {0x00, 0x1F},       {0x7F, 0x9F},       {0xAD, 0xAD},       {0x600, 0x605},
    {0x61C, 0x61C},     {0x6DD, 0x6DD},     {0x70F, 0x70F},     {0x890, 0x891},
    {0x8E2, 0x8E2},     {0x180E, 0x180E},   {0x200B, 0x200F},   {0x2028, 0x202E},
    {0x2060, 0x206F},   {0xE000, 0xF8FF},   {0xFDD0, 0xFDEF},   {0xFEFF, 0xFEFF},
    {0xFFF9, 0xFFFB},   {0x110BD, 0x110BD}, {0x110CD, 0x110CD}, {0x13430, 0x1343F},
    {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF}, {0xF0000, 0x10FFFF},
};

/// Takes the character at the front off.
char32_t TakeFirst(std::string_view& utf8) noexcept {
  const auto first = static_cast<unsigned char>(utf8.front());
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  char32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < std::min(length, utf8.size()); ++i) {
    code = (code << 6U) | (static_cast<unsigned char>(utf8[i]) & 0x3FU);
  }
  utf8.remove_prefix(std::min(length, utf8.size()));
  return code;
}

}  // namespace

bool IsHidden(char32_t code) noexcept {
  if ((code & 0xFFFEU) == 0xFFFEU) return true;  // noncharacters end each plane
  return std::any_of(std::begin(kHidden), std::end(kHidden), [code](const Range& range) {
    return code >= range.first && code <= range.last;
  });
}

bool HasHidden(std::string_view utf8) noexcept {
  while (!utf8.empty()) {
    if (IsHidden(TakeFirst(utf8))) return true;
  }
  return false;
}

std::string HiddenShown(std::string_view utf8) {
  std::string shown;
  shown.reserve(utf8.size());
  while (!utf8.empty()) {
    const std::string_view before = utf8;
    if (IsHidden(TakeFirst(utf8))) {
      shown += '?';
    } else {
      shown += before.substr(0, before.size() - utf8.size());
    }
  }
  return shown;
}

}  // namespace moontrace
