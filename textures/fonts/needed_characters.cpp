#include "textures/fonts/needed_characters.h"

#include <utf8proc.h>

#include <array>

#include "textures/base/error.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

bool IsDrawn(char32_t c) {
  const auto category = utf8proc_category(static_cast<utf8proc_int32_t>(c));
  return category != UTF8PROC_CATEGORY_CN && category < UTF8PROC_CATEGORY_ZS;
}

void AddWithFolds(char32_t c, std::set<char32_t>& needed) {
  if (!needed.insert(c).second) return;
  const auto code = static_cast<utf8proc_int32_t>(c);
  needed.insert(static_cast<char32_t>(utf8proc_tolower(code)));
  std::array<utf8proc_int32_t, 32> parts{};
  int last_bound = 0;
  const utf8proc_ssize_t count = utf8proc_decompose_char(
      code, parts.data(), static_cast<utf8proc_ssize_t>(parts.size()),
      static_cast<utf8proc_option_t>(UTF8PROC_DECOMPOSE | UTF8PROC_COMPAT | UTF8PROC_CASEFOLD |
                                     UTF8PROC_STRIPMARK),
      &last_bound);
  for (utf8proc_ssize_t i = 0; i < count && i < static_cast<utf8proc_ssize_t>(parts.size()); ++i) {
    const auto part = static_cast<char32_t>(parts[static_cast<std::size_t>(i)]);
    if (IsDrawn(part)) needed.insert(part);
  }
}

}  // namespace

std::set<char32_t> NeededCharacters(std::string_view text) {
  RequireUtf8(text, "text");
  std::set<char32_t> needed;
  for (const char32_t c : ToCodePoints(text)) {
    if (IsDrawn(c)) AddWithFolds(c, needed);
  }
  if (needed.empty()) throw InputError("the text is empty or blank: give at least one letter");
  return needed;
}

}  // namespace moontrace
