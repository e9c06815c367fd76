#include "textures/typeset/structure.h"

namespace moontrace {
namespace {

using Kind = FoldedChar::Kind;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::size_t kMostHashes = 3;

// The characters of a line as the text has them: one may have become several.
class Characters {
 public:
  Characters(std::string_view text, const std::vector<FoldedChar>& line)
      : text_(text), line_(line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i].begin < line[i].end) first_.push_back(i);
    }
  }
  std::size_t count() const { return first_.size(); }
  const FoldedChar& operator[](std::size_t i) const { return line_[first_[i]]; }
  /// A character with a mark of its own on it is another.
  bool Is(std::size_t i, char mark) const {
    const FoldedChar& c = (*this)[i];
    return c.end - c.begin == 1 && text_[c.begin] == mark;
  }
  bool IsBlank(std::size_t i) const {
    const Kind kind = (*this)[i].kind;
    return kind == Kind::kSpace || kind == Kind::kNothing;
  }
  bool AllBlank(std::size_t from) const {
    while (from < count() && IsBlank(from)) ++from;
    return from == count();
  }

 private:
  std::string_view text_;
  const std::vector<FoldedChar>& line_;
  std::vector<std::size_t> first_;  // of each character, in the line
};

// Whether backslashes begin the line and a mark follows that they make a character.
bool BeginsEscaped(const Characters& characters) {
  std::size_t at = 0;
  while (at < characters.count() && characters.Is(at, '\\')) ++at;
  return at > 0 && at < characters.count() && (characters.Is(at, '#') || characters.Is(at, '>'));
}

// Characters of the mark that begins the line, the blanks behind it with it.
std::size_t TakeBeginning(const Characters& characters, LineKind& kind) {
  const std::size_t count = characters.count();
  if (BeginsEscaped(characters)) return 1;
  std::size_t at = 0;
  if (count > 0 && characters.Is(0, '>')) {
    at = 1;
    kind = LineKind::kQuotation;
  } else {
    while (at < count && at <= kMostHashes && characters.Is(at, '#')) ++at;
    if (at == 0 || at > kMostHashes || characters.AllBlank(at)) return 0;
    kind = LineKind::kHeading;
  }
  if (at < count && characters[at].kind != Kind::kSpace) {
    kind = LineKind::kPlain;
    return 0;
  }
  while (at < count && characters[at].kind == Kind::kSpace) ++at;
  return at;
}

// For each opening parenthesis the one that closes it.
std::vector<std::size_t> Closings(const Characters& characters) {
  std::vector<std::size_t> closing(characters.count(), kNone), open;
  for (std::size_t i = 0; i < characters.count(); ++i) {
    if (characters.Is(i, '(')) open.push_back(i);
    if (characters.Is(i, ')') && !open.empty()) {
      closing[open.back()] = i;
      open.pop_back();
    }
  }
  return closing;
}

void TakeLinks(const Characters& characters, std::size_t from, std::vector<bool>& mark,
               std::vector<ByteRange>& links) {
  const std::vector<std::size_t> closing = Closings(characters);
  std::size_t open = kNone;
  bool has_words = false;
  for (std::size_t i = from; i < characters.count(); ++i) {
    if (characters.Is(i, '[') && i > from && characters.Is(i - 1, '\\')) {
      mark[i - 1] = true;
      open = kNone;
    } else if (characters.Is(i, '[')) {
      open = i;
      has_words = false;
    } else if (!characters.Is(i, ']')) {
      has_words |= !characters.IsBlank(i);
    } else {
      const bool address =
          i + 1 < characters.count() && characters.Is(i + 1, '(') && closing[i + 1] != kNone;
      if (open != kNone && has_words && address) {
        links.push_back({characters[open].end, characters[i].begin});
        mark[open] = mark[i] = true;
        for (const std::size_t end = closing[i + 1]; i < end;) mark[++i] = true;
      }
      open = kNone;
    }
  }
}

// Whether the part of the text that a line stands for holds what a mark begins with: most do not,
// and a book has a hundred thousand.
bool MayHoldMarks(std::string_view text, const std::vector<FoldedChar>& line) {
  if (line.empty()) return false;
  const std::size_t begin = line.front().begin;
  return text.substr(begin, line.back().end - begin).find_first_of("#>[") != std::string::npos;
}

}  // namespace

LineMarks TakeMarks(std::string_view text, std::vector<FoldedChar>& line, bool begins_line) {
  LineMarks found;
  if (!MayHoldMarks(text, line)) return found;
  const Characters characters(text, line);
  std::vector<bool> mark(characters.count(), false);
  const std::size_t begin = begins_line ? TakeBeginning(characters, found.kind) : 0;
  for (std::size_t i = 0; i < begin; ++i) mark[i] = true;
  TakeLinks(characters, begin, mark, found.links);

  std::size_t kept = 0, character = kNone;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].begin < line[i].end) ++character;  // from kNone to 0
    if (character != kNone && mark[character]) continue;
    line[kept++] = line[i];
  }
  line.resize(kept);
  return found;
}

}  // namespace moontrace
