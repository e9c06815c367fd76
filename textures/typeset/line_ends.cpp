#include "textures/typeset/line_ends.h"

#include <utf8proc.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

#include "textures/base/utf8.h"

namespace moontrace {
namespace {

enum class Role { kWord, kOpens, kCloses };

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

utf8proc_category_t CategoryOf(char32_t c) {
  return utf8proc_category(static_cast<utf8proc_int32_t>(c));
}

// A letter, a digit, or a sign of a script that is neither, such as one of its own area.
bool IsOfWord(const FoldedChar& c) {
  switch (CategoryOf(c.code)) {
    case UTF8PROC_CATEGORY_PC:
    case UTF8PROC_CATEGORY_PD:
    case UTF8PROC_CATEGORY_PS:
    case UTF8PROC_CATEGORY_PE:
    case UTF8PROC_CATEGORY_PI:
    case UTF8PROC_CATEGORY_PF:
    case UTF8PROC_CATEGORY_PO:
    case UTF8PROC_CATEGORY_SC:
    case UTF8PROC_CATEGORY_SM:
    case UTF8PROC_CATEGORY_SK:
      return false;
    default:
      return true;
  }
}

bool IsQuote(char32_t c) {
  const utf8proc_category_t category = CategoryOf(c);
  return c == U'\'' || c == U'"' || (c >= 0x2018 && c <= 0x201F) ||
         category == UTF8PROC_CATEGORY_PI || category == UTF8PROC_CATEGORY_PF;
}

// No line ends at it (UAX #14, class GL).
bool IsNoBreak(char32_t c) { return c == 0xA0 || c == 0x202F || c == 0x2007 || c == 0x2011; }

// A mark that opens or closes by its form, whatever it is written as: of quotation marks those that
// French sets apart.
bool OpensAlone(char32_t c) {
  return CategoryOf(c) == UTF8PROC_CATEGORY_PS || c == 0xAB || c == 0x2039;
}

bool ClosesAlone(char32_t c) {
  constexpr std::u32string_view kMarks = U"!?;:\u203D\u2026\u037E\u061B\u061F";
  return CategoryOf(c) == UTF8PROC_CATEGORY_PE || c == 0xBB || c == 0x203A ||
         kMarks.find(c) != std::u32string_view::npos;
}

// Fullwidth and wide, of those that lines of text are made of.
bool IsEastAsian(char32_t c) { return utf8proc_charwidth(static_cast<utf8proc_int32_t>(c)) == 2; }

// Whether the marks that stand between blanks from `at` on all close.
bool CloseAlone(const std::vector<FoldedChar>& line, std::size_t at) {
  bool any = false;
  for (; at < line.size() && line[at].kind != FoldedChar::Kind::kSpace; ++at) {
    if (line[at].kind != FoldedChar::Kind::kSign) continue;
    if (!ClosesAlone(line[at].was) && !(any && IsQuote(line[at].code))) return false;
    any = true;
  }
  return any;
}

// A word that is read from its begin.
class Roles {
 public:
  Role Next(const FoldedChar& c, const FoldedChar* next) {
    const bool behind_wide = std::exchange(wide_, IsEastAsian(c.code));
    if (IsOfWord(c)) {
      begun_ = part_begun_ = true;
      return Role::kWord;
    }
    const utf8proc_category_t category = CategoryOf(c.code);
    if (IsQuote(c.code)) {
      bool opens = !begun_ || (!part_begun_ && next != nullptr && IsOfWord(*next));
      const bool beside_wide = behind_wide || (next != nullptr && IsEastAsian(next->code));
      if (beside_wide && category == UTF8PROC_CATEGORY_PI) opens = true;
      if (beside_wide && category == UTF8PROC_CATEGORY_PF) opens = false;
      return opens ? Role::kOpens : Role::kCloses;
    }
    if (category == UTF8PROC_CATEGORY_PS) {
      part_begun_ = false;
      return Role::kOpens;
    }
    if (category == UTF8PROC_CATEGORY_PE) return Role::kCloses;
    if (category == UTF8PROC_CATEGORY_SC) return part_begun_ ? Role::kCloses : Role::kOpens;
    if (category == UTF8PROC_CATEGORY_PD || c.code == U'/') part_begun_ = false;
    return begun_ ? Role::kCloses : Role::kOpens;
  }
  void EndWord() { begun_ = part_begun_ = false; }

 private:
  bool begun_ = false;       // it has a letter or a digit
  bool wide_ = false;        // the character before is one of East Asian width
  bool part_begun_ = false;  // since its last hyphen, stroke or bracket
};

}  // namespace

std::vector<LineEnd> LineEndsOf(const std::vector<FoldedChar>& line) {
  using Kind = FoldedChar::Kind;
  std::vector<LineEnd> ends(line.size());
  Roles roles;
  std::size_t before = kNone;  // the sign before this one in its word
  Role role_before = Role::kWord;
  bool apostrophe = false;  // that sign is one behind a letter
  std::size_t next = 0;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const FoldedChar& c = line[at];
    if (c.kind == Kind::kSpace) {
      const bool opened =
          before != kNone && role_before == Role::kOpens && OpensAlone(line[before].was);
      const bool closes = CloseAlone(line, at + 1);
      if (!closes) roles.EndWord();
      const bool ties = opened || closes || IsNoBreak(c.was);
      if (ties && before != kNone) ends[before].keep_next = true;
      ends[at].bound = opened || closes;
      before = ties ? at : kNone;
      role_before = Role::kOpens;
      apostrophe = false;
      continue;
    }
    if (c.kind != Kind::kSign) continue;
    next = std::max(next, at + 1);
    while (next < line.size() && line[next].kind != Kind::kSign && line[next].kind != Kind::kSpace)
      ++next;
    const bool more = next < line.size() && line[next].kind == Kind::kSign;
    const bool in_word = before != kNone && role_before == Role::kWord;
    const Role role = roles.Next(c, more ? &line[next] : nullptr);
    ends[at].mark = role != Role::kWord;
    ends[at].may_end = IsEastAsian(c.code);
    if (before != kNone) {
      LineEnd& end = ends[before];
      end.keep_next = role_before == Role::kOpens || role == Role::kCloses ||
                      (apostrophe && role == Role::kWord) || IsNoBreak(line[before].was) ||
                      IsMark(c.code);
      end.bound = end.bound || (role != Role::kWord && line[before].code == c.code);
      end.may_end = end.may_end || (ends[at].may_end && line[before].kind == Kind::kSign);
    }
    apostrophe = in_word && role == Role::kCloses && IsQuote(c.code);
    before = at;
    role_before = role;
  }
  return ends;
}

}  // namespace moontrace
