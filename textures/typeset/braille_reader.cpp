#include "textures/typeset/braille_reader.h"

#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "textures/base/utf8.h"
#include "textures/typeset/braille_writer.h"

namespace moontrace {
namespace {

using Cells = std::vector<std::uint8_t>;

constexpr std::size_t kLongestLine = std::size_t{1} << 16U;  // in one call [cells]
constexpr std::size_t kLongestInParts = 96;                  // [cells]
constexpr std::size_t kMostEdge = 3;           // of a bracket or quotation mark [cells]
constexpr std::size_t kMostMark = 2;           // of a colon or a full stop within a word [cells]
constexpr std::size_t kMostWords = 1U << 16U;  // remembered
constexpr std::size_t kMostUnread = 100;       // before a table counts as one that cannot be read
constexpr std::uint8_t kCapital = 0x20;        // dot 6
constexpr std::uint8_t kApostrophe = 0x04;     // dot 3; behind dot 6 it ends a passage

std::string Upper(std::string_view text) {
  std::string upper;
  for (const char32_t c : ToCodePoints(text)) {
    upper += ToUtf8(static_cast<char32_t>(utf8proc_toupper(static_cast<utf8proc_int32_t>(c))));
  }
  return upper;
}

std::string Lower(std::string_view text) {
  std::string lower;
  for (const char32_t c : ToCodePoints(text)) {
    lower += ToUtf8(static_cast<char32_t>(utf8proc_tolower(static_cast<utf8proc_int32_t>(c))));
  }
  return lower;
}

void ReplaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string Typewritten(std::string text) {
  ReplaceAll(text, "\u2019", "'");
  ReplaceAll(text, "\u2026", "...");
  ReplaceAll(text, "\u2237", "::");
  return text;
}

// Straight quotation marks as a pair: the first of them opens.
std::string Quoted(std::string text, std::string_view opening, std::string_view closing) {
  const std::size_t letter = text.find_first_not_of("\"([{");
  for (std::size_t at = text.size(); at-- > 0;) {
    if (text[at] == '"') text.replace(at, 1, at < letter ? opening : closing);
  }
  return text;
}

// Whether a word has a symbol that liblouis puts where letters are meant ("L○d" for Ledford), or
// a private one of its own.
bool HasSymbol(std::string_view text) {
  const std::u32string codes = ToCodePoints(text);
  const bool has_letter =
      std::any_of(codes.begin(), codes.end(), [](char32_t c) { return c < 0x80 && IsLetter(c); });
  return std::any_of(codes.begin(), codes.end(), [has_letter](char32_t c) {
    if (c >= 0xE000 && c <= 0xF8FF) return true;
    const bool greek = c >= 0x370 && c < 0x400;
    const bool mark = c < 0x80 || (c >= 0x2010 && c < 0x2060);
    return has_letter && !mark && (greek || !IsLetter(c));
  });
}

// "ABM'S" as "ABM's": capitals end at an apostrophe.
std::string SmallBehindApostrophe(std::string text) {
  const std::size_t at = text.find('\'');
  return at == std::string::npos ? text : text.substr(0, at) + Lower(text.substr(at));
}

Cells Part(const Cells& cells, std::size_t begin, std::size_t end) {
  return {cells.begin() + static_cast<std::ptrdiff_t>(begin),
          cells.begin() + static_cast<std::ptrdiff_t>(end)};
}

// Where the pattern begins, or the end.
template <std::size_t kSize>
std::size_t FindIn(const Cells& cells, const std::array<std::uint8_t, kSize>& pattern) {
  const auto found = std::search(cells.begin(), cells.end(), pattern.begin(), pattern.end());
  return static_cast<std::size_t>(found - cells.begin());
}

std::optional<BrailleTable> PlainTable(const Script& script, const TypeStyle& style) {
  if (!style.table.empty() || script.braille_tables.empty()) return std::nullopt;
  const auto& first = *script.braille_tables.begin();
  if (first.first == style.grade) return std::nullopt;
  return BrailleTable(first.second);
}

}  // namespace

BrailleReader::BrailleReader(const Script& script, const TypeStyle& style)
    : table_(BrailleTableOf(script, style.grade, style.table)), plain_(PlainTable(script, style)) {}

bool BrailleReader::Writes(const std::string& text, const Cells& cells) const {
  const std::vector<BrailleCell> written = table_.Translate(ToCodePoints(text));
  return std::equal(written.begin(), written.end(), cells.begin(), cells.end(),
                    [](const BrailleCell& cell, std::uint8_t dots) { return cell.dots == dots; });
}

std::optional<std::string> BrailleReader::Confirmed(const std::string& text,
                                                    const Cells& cells) const {
  std::string plain = Typewritten(text);
  if (Writes(plain, cells)) return plain;
  if (plain != text && Writes(text, cells)) return text;
  return std::nullopt;
}

// The same for a word, with other capitals and quotation marks.
std::optional<std::string> BrailleReader::ConfirmedWord(const std::string& text,
                                                        const Cells& cells) const {
  if (text.empty() || text.find(' ') != std::string::npos) return std::nullopt;
  if (std::optional<std::string> same = Confirmed(text, cells)) return same;
  const std::string plain = Typewritten(text);
  for (std::string other : {SmallBehindApostrophe(plain), Upper(plain),
                            Quoted(plain, "\u2018", "\u2019"), Quoted(plain, "\u201C", "\u201D")}) {
    if (other != plain && Writes(other, cells)) return other;
  }
  return std::nullopt;
}

// In two parts, or three of which one or both ends are short or the middle is a mark; each by
// either table.
std::optional<std::string> BrailleReader::InParts(const Cells& word) const {
  const BrailleTable& plain = plain_ ? *plain_ : table_;
  const std::size_t size = word.size();
  const auto by_table = [&](std::size_t i, std::size_t j) {
    return table_.ReadBack(Part(word, i, j));
  };
  const auto plainly = [&](std::size_t i, std::size_t j) {
    return plain.ReadBack(Part(word, i, j));
  };
  const auto letters = [&](const std::string& text) {
    std::optional<std::string> read = ConfirmedWord(text, word);
    return read && HasSymbol(*read) ? std::nullopt : read;
  };
  if (auto read = letters(plainly(0, size))) return read;
  for (std::size_t i = 1; i < size; ++i) {
    const std::string begin = by_table(0, i), end = by_table(i, size);
    for (const std::string& text : {begin + end, begin + plainly(i, size), plainly(0, i) + end}) {
      if (auto read = letters(text)) return read;
    }
    for (std::size_t j = i + 1; j < std::min(size, i + kMostMark + 1); ++j) {
      if (auto read = letters(begin + plainly(i, j) + by_table(j, size))) return read;
    }
  }
  for (std::size_t i = 1; i <= kMostEdge; ++i) {
    for (std::size_t j = size; j-- > i + 1 && j + kMostEdge >= size;) {
      const std::string begin = plainly(0, i), end = plainly(j, size);
      for (const std::string& middle : {by_table(i, j), plainly(i, j)}) {
        std::string text = begin + middle;
        text += end;
        if (auto read = letters(text)) return read;
      }
    }
  }
  return std::nullopt;
}

std::string BrailleReader::ReadWord(const Cells& word) {
  if (word.empty()) return {};
  const std::string key(word.begin(), word.end());
  const auto known = words_.find(key);
  if (known != words_.end()) return known->second;
  std::string text = table_.ReadBack(word);
  std::optional<std::string> read = ConfirmedWord(text, word);
  const bool try_parts = word.size() <= kLongestInParts && unread_ < kMostUnread + read_in_parts_;
  if ((!read || HasSymbol(*read)) && try_parts) {
    std::optional<std::string> other = InParts(word);
    ++(other ? read_in_parts_ : unread_);
    if (other) read = std::move(other);
  }
  if (words_.size() >= kMostWords) words_.clear();
  return words_.emplace(key, read.value_or(Typewritten(std::move(text)))).first->second;
}

// A word of which a part may be of a passage of capitals: that has three signs for capitals before
// its first word, and one with an apostrophe's dot behind its last.
std::string BrailleReader::ReadCapitalWord(const Cells& word, bool& in_passage) {
  constexpr std::array<std::uint8_t, 3> kBegins = {kCapital, kCapital, kCapital};
  constexpr std::array<std::uint8_t, 2> kEnds = {kCapital, kApostrophe};
  std::string text;
  Cells rest = word;
  while (!rest.empty()) {
    const std::size_t at = in_passage ? FindIn(rest, kEnds) : FindIn(rest, kBegins);
    // What stands before a passage is a bracket or a quotation mark.
    const bool edge = !in_passage && at < rest.size();
    const std::string part = edge ? (plain_ ? *plain_ : table_).ReadBack(Part(rest, 0, at))
                                  : ReadWord(Part(rest, 0, at));
    text += in_passage ? Upper(part) : part;
    if (at == rest.size()) break;
    rest = Part(rest, at + (in_passage ? kEnds.size() : kBegins.size()), rest.size());
    in_passage = !in_passage;
  }
  return text;
}

std::string BrailleReader::ReadByWords(const Cells& cells) {
  std::string text;
  bool in_passage = false;
  for (std::size_t at = 0; at <= cells.size();) {
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = std::find(begin, cells.end(), std::uint8_t{0});
    text += ReadCapitalWord(Cells(begin, end), in_passage);
    at = static_cast<std::size_t>(end - cells.begin()) + 1;
    if (at <= cells.size()) text += ' ';
  }
  return text;
}

std::string BrailleReader::Read(const Cells& cells) {
  if (cells.empty()) return {};
  if (cells.size() > kLongestLine) return ReadByWords(cells);
  const std::string text = table_.ReadBack(cells);
  const std::optional<std::string> read = Confirmed(text, cells);
  if (read && !HasSymbol(*read)) return *read;
  std::string words = ReadByWords(cells);
  return read && !Writes(words, cells) ? *read : words;
}

}  // namespace moontrace
