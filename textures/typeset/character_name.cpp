#include "textures/typeset/character_name.h"

#include <fmt/core.h>
#include <utf8proc.h>

#include "textures/base/utf8.h"
#include "textures/typeset/fold.h"

namespace moontrace {
namespace {

struct Named {
  char32_t code;
  const char* name;
};

constexpr Named kNames[] = {
    {U'!', "exclamation mark"},
    {U'"', "quotation mark"},
    {U'\'', "apostrophe"},
    {U'(', "left parenthesis"},
    {U')', "right parenthesis"},
    {U'*', "asterisk"},
    {U',', "comma"},
    {U'-', "hyphen"},
    {U'.', "full stop"},
    {U'/', "slash"},
    {U':', "colon"},
    {U';', "semicolon"},
    {U'?', "question mark"},
    {U'[', "left square bracket"},
    {U'\\', "backslash"},
    {U']', "right square bracket"},
    {U'^', "circumflex accent"},
    {U'_', "low line"},
    {U'`', "grave accent"},
    {U'{', "left curly bracket"},
    {U'|', "vertical line"},
    {U'}', "right curly bracket"},
    {U'~', "tilde"},
    {0x1B, "escape"},
    {0x7F, "delete"},
    {0xAB, "left-pointing double angle quotation mark"},
    {0xAD, "soft hyphen"},
    {0xB4, "acute accent"},
    {0xB7, "middle dot"},
    {0xBB, "right-pointing double angle quotation mark"},
    {0x2BC, "modifier letter apostrophe"},
    {0x200B, "zero width space"},
    {0x200C, "zero width non-joiner"},
    {0x200D, "zero width joiner"},
    {0x200E, "left-to-right mark"},
    {0x200F, "right-to-left mark"},
    {0x2010, "hyphen"},
    {0x2011, "non-breaking hyphen"},
    {0x2012, "figure dash"},
    {0x2013, "en dash"},
    {0x2014, "em dash"},
    {0x2015, "horizontal bar"},
    {0x2018, "left single quotation mark"},
    {0x2019, "right single quotation mark"},
    {0x201A, "single low-9 quotation mark"},
    {0x201B, "single high-reversed-9 quotation mark"},
    {0x201C, "left double quotation mark"},
    {0x201D, "right double quotation mark"},
    {0x201E, "double low-9 quotation mark"},
    {0x201F, "double high-reversed-9 quotation mark"},
    {0x2022, "bullet"},
    {0x2026, "horizontal ellipsis"},
    {0x2032, "prime"},
    {0x2033, "double prime"},
    {0x2039, "single left-pointing angle quotation mark"},
    {0x203A, "single right-pointing angle quotation mark"},
    {0x2044, "fraction slash"},
    {0x2060, "word joiner"},
    {0x2212, "minus sign"},
    {0x2215, "division slash"},
    {0xFE0E, "variation selector-15"},
    {0xFE0F, "variation selector-16"},
    {0xFEFF, "zero width no-break space"},
    {0xFFFD, "replacement character"},
};

// Characters that cannot be seen: controls, formats, private and unassigned ones, lone marks.
bool IsUnseen(char32_t c) {
  const auto category = utf8proc_category(static_cast<utf8proc_int32_t>(c));
  return category == UTF8PROC_CATEGORY_CN || category >= UTF8PROC_CATEGORY_ZL ||
         (category >= UTF8PROC_CATEGORY_MN && category <= UTF8PROC_CATEGORY_ME);
}

}  // namespace

std::string CharacterName(std::string_view utf8) {
  if (utf8.size() > 4) return {};
  const std::u32string codes = ToCodePoints(utf8);
  if (codes.size() != 1) return {};
  const std::string number = fmt::format("U+{:04X}", static_cast<unsigned>(codes[0]));
  for (const Named& named : kNames) {
    if (named.code != codes[0]) continue;
    const bool printable = codes[0] > U' ' && codes[0] < 0x7F;
    return printable ? named.name : fmt::format("{} ({})", named.name, number);
  }
  return IsUnseen(codes[0]) ? number : std::string();
}

}  // namespace moontrace
