#include "textures/typeset/fold.h"

#include <fmt/core.h>
#include <utf8proc.h>

#include <array>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostMarks = 16;  // that a character keeps (ours: no language has so many)
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Unicode's mandatory breaks (UAX #14, classes CR, LF, NL, BK).
bool EndsLine(char32_t c) {
  return (c >= U'\n' && c <= U'\r') || c == 0x85 || c == 0x2028 || c == 0x2029;
}

bool IsBlank(char32_t c) { return c == U'\t' || IsSpaceSeparator(c); }

// Digits of "x²" or "2½" are not part of the number before them.
bool StandsApart(char32_t c) {
  switch (utf8proc_get_property(static_cast<utf8proc_int32_t>(c))->decomp_type) {
    case UTF8PROC_DECOMP_TYPE_SUPER:
    case UTF8PROC_DECOMP_TYPE_SUB:
    case UTF8PROC_DECOMP_TYPE_FRACTION:
    case UTF8PROC_DECOMP_TYPE_CIRCLE:
      return true;
    default:
      return false;
  }
}

// Compatibility decomposition, case folded if asked for (which opens more letters, ß), without
// marks and characters that Unicode lets be ignored. No code point decomposes to more than 18.
std::u32string Decomposed(char32_t c, bool fold_case) {
  std::array<utf8proc_int32_t, 32> codes{};
  int last_bound = 0;
  unsigned options = UTF8PROC_DECOMPOSE | UTF8PROC_COMPAT | UTF8PROC_STRIPMARK | UTF8PROC_IGNORE;
  if (fold_case) options |= UTF8PROC_CASEFOLD;
  const auto count = utf8proc_decompose_char(static_cast<utf8proc_int32_t>(c), codes.data(),
                                             static_cast<utf8proc_ssize_t>(codes.size()),
                                             static_cast<utf8proc_option_t>(options), &last_bound);
  std::u32string result;
  for (utf8proc_ssize_t i = 0; i < count && i < static_cast<utf8proc_ssize_t>(codes.size()); ++i) {
    result += static_cast<char32_t>(codes[static_cast<std::size_t>(i)]);
  }
  return result;
}

char32_t Lower(char32_t c) {
  return static_cast<char32_t>(utf8proc_tolower(static_cast<utf8proc_int32_t>(c)));
}

char32_t Upper(char32_t c) {
  return static_cast<char32_t>(utf8proc_toupper(static_cast<utf8proc_int32_t>(c)));
}

void CheckUtf8(std::string_view text) {
  std::size_t line = 1, column = 1;
  bool after_cr = false;
  for (std::size_t at = 0; at < text.size();) {
    char32_t c = 0;
    const std::size_t length = Decode(text.substr(at), c);
    if (length == 0) {
      throw InputError(
          fmt::format("the text is not UTF-8 at byte offset {} (line {}, column {}): save it as "
                      "UTF-8",
                      at, line, column));
    }
    if (EndsLine(c)) {
      if (!(c == U'\n' && after_cr)) ++line;
      column = 1;
    } else if (at > 0 || text.substr(0, 3) != kByteOrderMark) {
      ++column;
    }
    after_cr = c == U'\r';
    at += length;
  }
}

}  // namespace

Folder::Folder(std::string_view text, const Script& script)
    : Folder(text, script, [&script](char32_t c) {
        return script.signs.count(c) > 0 || script.digits.count(c) > 0;
      }) {}

Folder::Folder(std::string_view text, const Script& script, std::function<bool(char32_t)> has_sign)
    : text_(text), script_(script), has_sign_(std::move(has_sign)) {
  if (text.size() > kMostText) {
    throw InputError(fmt::format("the text has {} MB, at most {} MB are taken: split it",
                                 (text.size() + (1u << 20) - 1) >> 20, kMostText >> 20));
  }
  CheckUtf8(text);
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) at_ = kByteOrderMark.size();
  if (at_ == text.size()) throw InputError("the text is empty: give at least one letter");
}

char32_t Folder::Read(std::size_t at, std::size_t& next) const {
  char32_t c = 0;
  next = at + Decode(text_.substr(at), c);
  return c;
}

// End of the combining marks that follow a character.
std::size_t Folder::ClusterEnd(std::size_t next, std::size_t& code_points) const {
  while (next < text_.size() && static_cast<unsigned char>(text_[next]) >= 0x80) {
    std::size_t behind = 0;
    if (!IsMark(Read(next, behind))) break;
    next = behind;
    ++code_points;
  }
  return next;
}

bool Folder::NextLine(std::vector<FoldedChar>& line) {
  line.clear();
  if (at_ >= text_.size()) return false;
  begins_line_ = line_ended_;
  line_ended_ = false;
  if (begins_line_) {
    ++line_number_;
    column_ = 1;
    written_ = 0;
  }
  const std::size_t line_begin = at_;
  while (at_ < text_.size()) {
    std::size_t base_end = 0;
    const char32_t c = Read(at_, base_end);
    if (EndsLine(c)) {
      if (begins_line_ && at_ == line_begin) in_low_double_ = in_low_single_ = false;
      at_ = base_end;
      if (c == U'\r' && at_ < text_.size() && text_[at_] == '\n') ++at_;
      line_ended_ = true;
      return true;
    }
    std::size_t code_points = 1;
    const std::size_t end = ClusterEnd(base_end, code_points);
    FoldedChar first;
    first.begin = static_cast<std::uint32_t>(at_);
    first.end = static_cast<std::uint32_t>(end);
    first.column = static_cast<std::uint32_t>(column_);
    first.was = c;
    if (end == base_end) {
      const Form& form = FormInQuotation(c);
      const bool padded = form.text.size() > 1 && form.changed &&
                          (form.text.front() == U' ' || form.text.back() == U' ');
      Append(padded ? Parted(form, end, line) : form, first, line);
    } else {
      AppendCluster(c, base_end, first, line);
    }
    if (written_ + line.size() > kMostText) {
      throw InputError(
          fmt::format("script {}: its folds make over {} million characters: shorten them",
                      script_.name, kMostText >> 20));
    }
    column_ += code_points;
    at_ = end;
    if (line.size() > (IsBlank(c) ? kLinePart : 2 * kLinePart)) break;
  }
  written_ += line.size();
  return true;
}

// One composed character if there is one (its own sign or fold counts), else the first and those of
// its marks that a table of Braille writes (vowels of Hindi, Arabic and Hebrew, say); the others
// go.
void Folder::AppendCluster(char32_t c, std::size_t base_end, FoldedChar first,
                           std::vector<FoldedChar>& line) {
  const std::size_t end = first.end;
  const char32_t composed = Composed(first.begin, end);
  Form form = FormOf(composed ? composed : c);
  std::vector<FoldedChar> marks;
  bool all = !composed;
  for (std::size_t at = base_end, next = at; !composed && at < end; at = next) {
    FoldedChar mark = first;
    mark.code = mark.was = Read(at, next);
    mark.kind = FoldedChar::Kind::kSign;
    mark.letter = form.letter;
    mark.begin = static_cast<std::uint32_t>(at);
    mark.end = static_cast<std::uint32_t>(next);
    const bool has = !script_.braille_tables.empty() && HasSign(mark.code);
    const bool kept = has && form.kind == FoldedChar::Kind::kSign && marks.size() < kMostMarks;
    if (kept) marks.push_back(mark);
    all = all && kept;
  }
  if (!composed && !all) form.changed = true;
  if (all) first.end = static_cast<std::uint32_t>(base_end);
  Append(form, first, line);
  for (FoldedChar& mark : marks) {
    if (!all) mark.begin = mark.end = first.end;
    line.push_back(mark);
  }
}

// The form with spaces at its edges only where it would else join a word or a number.
Folder::Form Folder::Parted(const Form& form, std::size_t next,
                            const std::vector<FoldedChar>& line) {
  const auto joins = [](char32_t c) { return IsLetter(c) || (c >= U'0' && c <= U'9'); };
  Form parted = form;
  const bool join_before =
      !line.empty() && line.back().kind == FoldedChar::Kind::kSign && joins(line.back().code);
  if (parted.text.front() == U' ' && !join_before) parted.text.erase(0, 1);
  bool join_behind = false;
  if (next < text_.size()) {
    std::size_t behind = 0;
    const Form& other = FormOf(Read(next, behind));
    join_behind = other.kind == FoldedChar::Kind::kSign && joins(other.text.front());
  }
  if (parted.text.back() == U' ' && !join_behind) parted.text.pop_back();
  return parted;
}

void Folder::Append(const Form& form, FoldedChar first, std::vector<FoldedChar>& line) const {
  first.kind = form.kind;
  first.changed = form.changed;
  first.letter = form.letter;
  first.apart = form.apart;
  first.replaced = form.replaced;
  if (form.text.empty()) {
    line.push_back(first);
    return;
  }
  std::size_t i = 0;
  if (form.text.size() > 1 && form.text.front() == U' ') {  // stands for nothing
    FoldedChar space;
    space.begin = space.end = first.begin;
    space.column = first.column;
    space.kind = FoldedChar::Kind::kSpace;
    line.push_back(space);
    i = 1;
  }
  for (; i < form.text.size(); ++i) {
    first.code = form.text[i];
    if (form.kind == FoldedChar::Kind::kSign) {
      first.letter = IsLetter(first.code);
      if (first.code == U' ') first.kind = FoldedChar::Kind::kSpace;
    }
    line.push_back(first);
    first.kind = form.kind;
    first.begin = first.end;
    first.changed = false;
  }
}

// The one character that a short cluster composes to, or 0.
char32_t Folder::Composed(std::size_t begin, std::size_t end) const {
  std::array<utf8proc_int32_t, 32> codes{};
  if (end - begin > 16) return 0;
  const auto options = static_cast<utf8proc_option_t>(UTF8PROC_COMPOSE | UTF8PROC_STABLE);  // NFC
  auto count = utf8proc_decompose(reinterpret_cast<const utf8proc_uint8_t*>(text_.data() + begin),
                                  static_cast<utf8proc_ssize_t>(end - begin), codes.data(),
                                  static_cast<utf8proc_ssize_t>(codes.size()), options);
  if (count <= 0 || count > static_cast<utf8proc_ssize_t>(codes.size())) return 0;
  count = utf8proc_normalize_utf32(codes.data(), count, options);
  return count == 1 ? static_cast<char32_t>(codes[0]) : 0;
}

const Folder::Form& Folder::FormOf(char32_t c) {
  const auto found = forms_.find(c);
  if (found != forms_.end()) return found->second;
  return forms_.emplace(c, Fold(c)).first->second;
}

// The form of a character, and of “ where it closes what a low mark opened.
const Folder::Form& Folder::FormInQuotation(char32_t c) {
  constexpr char32_t kLowDouble = 0x201E, kLowSingle = 0x201A;
  constexpr char32_t kDouble = 0x201C, kSingle = 0x2018, kBehind = 1;  // ” is behind “ in Unicode
  const Form& form = FormOf(c);
  if (c == kLowDouble) in_low_double_ = form.text == std::u32string(1, kDouble);
  if (c == kLowSingle) in_low_single_ = form.text == std::u32string(1, kSingle);
  if (c == kDouble + kBehind) in_low_double_ = false;
  if (c != kDouble && c != kSingle) return form;
  bool& open = c == kDouble ? in_low_double_ : in_low_single_;
  if (!std::exchange(open, false) || !HasSign(c + kBehind)) return form;
  Form& closing = closing_[c];
  closing = FormOf(c + kBehind);
  closing.changed = true;
  return closing;
}

// The character's sign, or that of its small letter.
bool Folder::AppendSign(char32_t c, std::u32string& text) const {
  const char32_t found = HasSign(c) ? c : HasSign(Lower(c)) ? Lower(c) : 0;
  if (found != 0) text += found;
  return found != 0;
}

// The script's replacement, if all of it can be written.
bool Folder::FoldByTable(char32_t c, Form& form) const {
  const auto found = script_.folds.find(c);
  if (found == script_.folds.end()) return false;
  std::u32string text = ToCodePoints(found->second);
  for (const char32_t part : text) {
    if (part != U' ' && !HasSign(part)) return false;
  }
  form.kind = text.empty() ? FoldedChar::Kind::kNothing : FoldedChar::Kind::kSign;
  form.text = std::move(text);
  form.changed = true;
  return true;
}

Folder::Form Folder::Fold(char32_t c) const {
  using Kind = FoldedChar::Kind;
  Form form;
  form.text = std::u32string(1, c);
  form.letter = IsLetter(c);
  form.apart = StandsApart(c);
  if (IsBlank(c)) {
    form.text.front() = U' ';
    form.kind = Kind::kSpace;
    return form;
  }
  if (c == script_.protect_mark && c != 0) {
    form.kind = HasSign(c) ? Kind::kSign : Kind::kMissing;
    return form;
  }
  const char32_t lower = Lower(c);
  const bool liblouis_has = !script_.braille_tables.empty() && HasSign(c);
  if (!liblouis_has && FoldByTable(c, form)) return form;
  if (HasSign(c)) {
    form.kind = Kind::kSign;
    form.changed = script_.borrowed.count(c) > 0;
    form.replaced = form.changed ? Replaced::kOtherScript : Replaced::kFolded;
    return form;
  }
  if (lower != c && FoldByTable(lower, form)) return form;
  if (lower != c && HasSign(lower)) {
    form.text = std::u32string(1, lower);
    form.kind = Kind::kSign;
    return form;
  }
  if (IsControlCode(c) || FoldByUnicode(c, false, form)) return form;
  std::u32string letters;
  if (Transliterate(c, letters)) {
    form.kind = letters.empty() ? Kind::kNothing : Kind::kSign;
    form.changed = true;
    form.replaced = Replaced::kTransliterated;
    form.text = std::move(letters);
    return form;
  }
  if (!FoldByUnicode(c, true, form)) Name(c, form);
  return form;
}

// Leaves the form as it is unless every part can be written.
bool Folder::FoldByUnicode(char32_t c, bool transliterate, Form& form) const {
  const std::u32string parts = Decomposed(c, false);
  std::u32string written;
  if (!WriteParts(parts, transliterate, written) &&
      !WriteParts(Decomposed(c, true), transliterate, written)) {
    return false;
  }
  const bool ignorable = utf8proc_get_property(static_cast<utf8proc_int32_t>(c))->ignorable != 0;
  if (written.empty() && !ignorable && parts.empty()) return false;  // a mark on nothing
  form.kind = written.empty() ? FoldedChar::Kind::kNothing : FoldedChar::Kind::kSign;
  form.text = std::move(written);
  form.changed = true;
  form.replaced = transliterate ? Replaced::kTransliterated : Replaced::kFolded;
  return true;
}

// By the script's table, by signs, and if asked for by letters that sound alike.
bool Folder::WriteParts(const std::u32string& parts, bool transliterate,
                        std::u32string& written) const {
  written.clear();
  for (const char32_t part : parts) {
    Form by_table;
    if (FoldByTable(part, by_table)) {
      written += by_table.text;
    } else if (!AppendSign(part, written) && !(transliterate && Transliterate(part, written))) {
      return false;
    }
  }
  return true;
}

// Appends the letters that sound like the character, if the script has all of them; a capital's
// begin with a capital where the script has any.
bool Folder::Transliterate(char32_t c, std::u32string& text) const {
  auto found = script_.transliterations.find(c);
  const bool capital = found == script_.transliterations.end() && Lower(c) != c;
  if (capital) found = script_.transliterations.find(Lower(c));
  if (found == script_.transliterations.end()) return false;
  const std::u32string letters = ToCodePoints(found->second);
  std::u32string written;
  for (const char32_t letter : letters) {
    const char32_t first = capital && written.empty() ? Upper(letter) : letter;
    if (!AppendSign(first, written)) return false;
  }
  text += written;
  return true;
}

// "[euro sign]", if the script has all its letters; brackets as the script has them.
bool Folder::Name(char32_t c, Form& form) const {
  const auto found = script_.names.find(c);
  if (found == script_.names.end()) return false;
  std::u32string written;
  for (const char32_t part : ToCodePoints("[" + found->second + "]")) {
    Form by_table;
    if (part == U' ') {
      written += part;
    } else if (FoldByTable(part, by_table)) {
      written += by_table.text;
    } else if (!AppendSign(part, written)) {
      return false;
    }
  }
  form.kind = FoldedChar::Kind::kSign;
  form.text = std::move(written);
  form.changed = true;
  form.replaced = Replaced::kNamed;
  return true;
}

}  // namespace moontrace
