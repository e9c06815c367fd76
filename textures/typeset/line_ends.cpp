#include "textures/typeset/line_ends.h"

#include <utf8proc.h>

#include <algorithm>
#include <cstddef>
#include <limits>

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

// A word that is read from its begin.
class Roles {
 public:
  Role Next(const FoldedChar& c, const FoldedChar* next) {
    if (IsOfWord(c)) {
      begun_ = part_begun_ = true;
      return Role::kWord;
    }
    const utf8proc_category_t category = CategoryOf(c.code);
    if (IsQuote(c.code)) {
      const bool opens = !begun_ || (!part_begun_ && next != nullptr && IsOfWord(*next));
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
      roles.EndWord();
      before = kNone;
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
    if (before != kNone) {
      ends[before].keep_next = role_before == Role::kOpens || role == Role::kCloses ||
                               (apostrophe && role == Role::kWord);
      ends[before].bound = role != Role::kWord && line[before].code == c.code;
    }
    apostrophe = in_word && role == Role::kCloses && IsQuote(c.code);
    before = at;
    role_before = role;
  }
  return ends;
}

}  // namespace moontrace
