#include "sim/console/line_wrap.h"

#include <algorithm>
#include <string>

#include "sim/console/vocabulary.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

bool IsNumber(std::string_view word) {
  return !word.empty() && word.find_first_not_of("0123456789.") == std::string_view::npos &&
         word.front() != '.' && word.back() != '.';
}

/// Where a word of the vocabulary ends that stands behind its number ("22 how am i doing"), with
/// what follows it up to the next blank; 0: there is none.
std::size_t NumberedWordEnd(std::string_view text, std::size_t space) {
  std::size_t end = 0;
  for (const TypedWord& word : Vocabulary()) {
    const std::size_t size = space + 1 + word.word.size();
    const bool fits = text.substr(0, space) == std::to_string(word.number) &&
                      text.substr(space + 1, word.word.size()) == word.word;
    if (fits) end = std::min(text.find(' ', size), text.size());
  }
  return end;
}

/// Where the next piece that stays on one line ends: a word, or a number with what it counts or
/// names ("26 back", "12 mm"), a word's number with the whole of it, if that goes into `columns`.
std::size_t PieceEnd(std::string_view text, std::size_t columns) {
  const std::size_t space = std::min(text.find(' '), text.size());
  if (space == text.size() || !IsNumber(text.substr(0, space))) return space;
  const std::size_t word = NumberedWordEnd(text, space);
  if (word > 0 && CountCharacters(text.substr(0, word)) <= columns) return word;
  const std::size_t next = std::min(text.find(' ', space + 1), text.size());
  const bool alone = next == space + 1 || CountCharacters(text.substr(0, next)) > columns;
  return alone ? space : next;
}

std::string WrappedLine(std::string_view text, std::size_t columns) {
  if (columns == 0) return std::string(text) + '\n';
  std::string lines;
  std::size_t used = 0;
  while (!text.empty()) {
    const std::size_t end = PieceEnd(text, columns);
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t length = CountCharacters(word);
    if (used > 0 && used + 1 + length > columns) {
      lines += '\n';
      used = 0;
    }
    if (used > 0) {
      lines += ' ';
      ++used;
    }
    lines += word;
    used += length;
  }
  return lines + '\n';
}

bool BeginsASentence(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '"' || c == '\'';
}

}  // namespace

std::string Wrapped(std::string_view text, std::size_t columns) {
  std::string lines;
  for (;;) {
    const std::size_t end = text.find('\n');
    lines += WrappedLine(text.substr(0, end), columns);
    if (end == std::string_view::npos || end + 1 == text.size()) return lines;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string> Sentences(std::string_view text) {
  std::vector<std::string> sentences(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& now = sentences.back();
    const bool blank = text[i] == ' ' || text[i] == '\n';
    if (!blank) {
      now += text[i];
      continue;
    }
    if (now.empty() || now.back() == ' ') continue;
    const std::size_t mark = now.find_last_not_of("\"'");
    const bool ends = mark != std::string::npos &&
                      std::string_view(".!?").find(now[mark]) != std::string_view::npos;
    const std::size_t next = text.find_first_not_of(" \n", i);
    const bool begins = next != std::string_view::npos && BeginsASentence(text[next]);
    if (ends && begins) {
      sentences.emplace_back();
    } else {
      now += ' ';
    }
  }
  while (!sentences.back().empty() && sentences.back().back() == ' ') sentences.back().pop_back();
  if (sentences.back().empty()) sentences.pop_back();
  return sentences;
}

}  // namespace moontrace
