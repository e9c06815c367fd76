#include "textures/typeset/older_punctuation.h"

#include <utf8proc.h>

#include <algorithm>
#include <string>
#include <utility>

#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

using Kind = FoldedChar::Kind;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::size_t kLongestWord = 32;        // of abbreviations [bytes]
constexpr std::size_t kLongestQuestion = 4096;  // that is looked for below its line [bytes]

bool IsDigit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool IsEnd(char c) { return c == '.' || c == '!' || c == '?'; }

bool IsSmallLetter(char32_t c) {
  const auto code = static_cast<utf8proc_int32_t>(c);
  return IsLetter(c) && utf8proc_tolower(code) == code;
}

/// The text as sentences, whatever its lines.
class Sentences {
 public:
  Sentences(std::string_view text, const OlderPunctuation& rules) : text_(text), rules_(rules) {}

  char At(std::size_t at) const { return at < text_.size() ? text_[at] : '\n'; }
  bool JoinsBehind(std::size_t at) const {
    const char32_t next = Character(at + 1);
    return IsLetter(next) || IsDigit(next);
  }
  bool IsAbbreviation(std::size_t stop) const;
  bool EndsSentence(std::size_t at) const;
  bool GoesOnAt(std::size_t line_begin) const;
  bool IsAsked(std::size_t line_end, bool inner) const;

 private:
  char32_t Character(std::size_t at) const {
    char32_t c = 0;
    if (at < text_.size()) Decode(text_.substr(at), c);
    return c;
  }
  std::u32string WordBefore(std::size_t end) const;
  std::size_t PastBlanks(std::size_t at, int& line_ends) const {
    while (at < text_.size() && (IsBlank(text_[at]) || text_[at] == '\n')) {
      line_ends += text_[at++] == '\n' ? 1 : 0;
    }
    return at;
  }

  std::string_view text_;
  const OlderPunctuation& rules_;
};

// The letters before a full stop, the last of a long word.
std::u32string Sentences::WordBefore(std::size_t end) const {
  std::size_t begin = end;
  for (std::size_t at = end; at > 0 && end - at < kLongestWord;) {
    --at;
    if ((static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U) continue;
    if (!IsLetter(Character(at))) break;
    begin = at;
  }
  return ToCodePoints(LowerCase(text_.substr(begin, end - begin)));
}

bool Sentences::IsAbbreviation(std::size_t stop) const {
  const std::u32string word = WordBefore(stop);
  if (word.empty() || At(stop + 1) == '.') return false;
  if (JoinsBehind(stop) || At(stop + 1) == ',') return true;
  std::string utf8;
  for (const char32_t c : word) utf8 += ToUtf8(c);
  if (rules_.abbreviations.count(utf8) > 0 || (word.size() == 1 && word != U"i")) return true;
  int line_ends = 0;
  const std::size_t next = PastBlanks(stop + 1, line_ends);
  return next > stop + 1 && line_ends < 2 && IsSmallLetter(Character(next));
}

bool Sentences::EndsSentence(std::size_t at) const {
  if (!IsEnd(At(at)) || JoinsBehind(at)) return false;
  if (At(at) != '.') return true;
  if (At(at + 1) == '.' || IsAbbreviation(at)) return false;
  // An ellipsis ends one where no small letter follows.
  int line_ends = 0;
  return at == 0 || At(at - 1) != '.' || !IsSmallLetter(Character(PastBlanks(at + 1, line_ends)));
}

// Whether the sentence at a line's beginning began on the line above.
bool Sentences::GoesOnAt(std::size_t line_begin) const {
  std::size_t at = line_begin;
  int line_ends = 0;
  while (at > 0 && line_ends < 2 && (IsBlank(text_[at - 1]) || text_[at - 1] == '\n')) {
    line_ends += text_[--at] == '\n' ? 1 : 0;
  }
  if (at == 0 || line_ends != 1) return false;
  while (at > 1 && (text_[at - 1] == '"' || text_[at - 1] == '\'' || text_[at - 1] == ')')) --at;
  return !EndsSentence(at - 1);
}

// Whether the sentence that goes on below a line is a question. An inner one ends where what it
// stands in closes; of an outer one quotations and brackets are passed over.
bool Sentences::IsAsked(std::size_t line_end, bool inner) const {
  const std::size_t most = std::min(text_.size(), line_end + kLongestQuestion);
  bool passing = false;
  for (std::size_t at = line_end; at < most; ++at) {
    const char c = text_[at];
    int line_ends = 0;
    if (c == '\n' && (PastBlanks(at, line_ends) == text_.size() || line_ends > 1)) return false;
    if (c == '"' || c == '(' || c == ')') {
      if (inner && c != '(') return false;
      passing = c == '"' ? !passing : c == '(';
    }
    if (!passing && EndsSentence(at)) return c == '?';
  }
  return false;
}

/// One line while it is rewritten.
class OlderLine {
 public:
  OlderLine(std::string_view text, const Script& script, std::vector<FoldedChar>& line)
      : sentences_(text, script.older_punctuation), rules_(script.older_punctuation), line_(line) {}
  void Rewrite();

 private:
  struct Sentence {
    std::size_t first = kNone;  // its first letter or digit on this line
    bool from_above = false;
  };
  bool Is(std::size_t at, char32_t code) const {
    return at < line_.size() && line_[at].kind == Kind::kSign && line_[at].code == code;
  }
  bool Opens(std::size_t at) const;
  bool Closes(std::size_t at) const { return inner_ && (Is(at, U'"') || Is(at, U')')); }
  bool HasBegun() const { return now_.first != kNone || now_.from_above; }
  void Take(std::size_t at);
  void MakeShort(std::size_t at);
  void NoteQuestion() {
    if (now_.first != kNone && !now_.from_above) questions_.push_back(now_.first);
  }
  void InsertQuestions();

  Sentences sentences_;
  const OlderPunctuation& rules_;
  std::vector<FoldedChar>& line_;
  Sentence now_, outer_;
  bool inner_ = false;                  // now_ is in quotation marks or brackets within outer_
  std::vector<std::size_t> questions_;  // where question marks go, ascending
};

bool OlderLine::Opens(std::size_t at) const {
  if (inner_ || at + 1 >= line_.size() || line_[at + 1].kind == Kind::kSpace) return false;
  if (Is(at, U'(')) return true;
  return Is(at, U'"') && (at == 0 || line_[at - 1].kind == Kind::kSpace);
}

void OlderLine::MakeShort(std::size_t at) {
  line_[at].code = rules_.short_stop;
  line_[at].changed = true;
}

void OlderLine::Take(std::size_t at) {
  const FoldedChar& c = line_[at];
  const bool itself =
      c.end - c.begin == 1 && static_cast<char32_t>(sentences_.At(c.begin)) == c.code;
  if (Opens(at)) {
    inner_ = true;
    outer_ = std::exchange(now_, Sentence{});
  } else if (Closes(at)) {
    inner_ = false;
    now_ = outer_;
  } else if (c.letter || IsDigit(c.code)) {
    if (now_.first == kNone) now_.first = at;
  } else if (rules_.serves.count(c.code) > 0 ||
             (itself && c.code == U'.' && sentences_.IsAbbreviation(c.begin))) {
    MakeShort(at);
  } else if (itself && sentences_.EndsSentence(c.begin)) {
    if (c.code == U'?' && HasBegun()) {
      NoteQuestion();
      MakeShort(at);
    }
    now_ = {};
  }
}

void OlderLine::InsertQuestions() {
  if (questions_.empty()) return;
  std::sort(questions_.begin(), questions_.end());
  std::vector<FoldedChar> written;
  written.reserve(line_.size() + questions_.size());
  auto question = questions_.begin();
  for (std::size_t at = 0; at < line_.size(); ++at) {
    if (question != questions_.end() && *question == at) {
      FoldedChar mark;
      mark.code = U'?';
      mark.kind = Kind::kSign;
      mark.begin = mark.end = line_[at].begin;
      mark.column = line_[at].column;
      written.push_back(mark);
      ++question;
    }
    written.push_back(line_[at]);
  }
  line_ = std::move(written);
}

void OlderLine::Rewrite() {
  if (line_.empty()) return;
  now_.from_above = sentences_.GoesOnAt(line_.front().begin);
  for (std::size_t at = 0; at < line_.size(); ++at) {
    if (line_[at].kind == Kind::kSign) Take(at);
  }
  const bool goes_on = now_.first != kNone && !now_.from_above;
  if (goes_on && sentences_.IsAsked(line_.back().end, inner_)) NoteQuestion();
  InsertQuestions();
}

}  // namespace

void UseOlderPunctuation(std::string_view text, const Script& script,
                         std::vector<FoldedChar>& line) {
  if (script.older_punctuation.short_stop != 0) OlderLine(text, script, line).Rewrite();
}

}  // namespace moontrace
