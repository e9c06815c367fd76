#include "sim/book/unset_words.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/documents/document_places.h"

namespace moontrace {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// Bytes of the text that the page's glyphs stand for, ascending.
using Ranges = std::vector<std::pair<std::size_t, std::size_t>>;

bool IsSet(const Ranges& set, std::size_t byte) {
  return std::any_of(set.begin(), set.end(), [byte](const auto& range) {
    return byte >= range.first && byte < range.second;
  });
}

/// Whether a byte begins a character that wants a sign: a letter or a digit.
bool WantsSign(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         (static_cast<unsigned char>(c) & 0xC0U) == 0xC0U;
}

bool IsWhole(std::string_view text, std::size_t begin, std::size_t end, const Ranges& set) {
  for (std::size_t i = begin; i < end; ++i) {
    if (WantsSign(text[i]) && !IsSet(set, i)) return false;
  }
  return true;
}

}  // namespace

std::string UnsetWords(const FeltPage& page, std::size_t glyph) {
  const std::string_view text = page.text->text;
  const std::vector<PlacedGlyph>& glyphs = page.set().glyphs;
  const auto word_end = [text](std::size_t at) {
    while (at < text.size() && !IsBlank(text[at])) ++at;
    return at;
  };
  // from behind the word before that is set
  std::size_t first = glyph;
  while (first > 0 && glyphs[first - 1].word == glyphs[glyph].word) --first;
  std::size_t from = 0;
  if (first > 0) {
    from = word_end(glyphs[first - 1].source_begin);
  } else if (page.index > 0 && !page.text->set.pages[page.index - 1].glyphs.empty()) {
    from = word_end(page.text->set.pages[page.index - 1].glyphs.back().source_begin);
  }
  const bool last =
      page.index + 1 == page.text->set.pages.size() && glyphs[glyph].word == glyphs.back().word;
  const std::size_t to = last ? text.size() : word_end(glyphs[glyph].source_begin);
  Ranges set;
  for (const PlacedGlyph& one : glyphs) {
    if (one.source_begin >= from && one.source_begin < to) {
      set.emplace_back(one.source_begin, one.source_end);
    }
  }
  std::string words;
  for (std::size_t at = from; at < to;) {
    if (IsBlank(text[at])) {
      ++at;
      continue;
    }
    const std::size_t end = word_end(at);
    if (!IsWhole(text, at, end, set)) {
      words.append(words.empty() ? "" : " ").append(text.substr(at, end - at));
    }
    at = end;
  }
  return WordsOf(words);
}

}  // namespace moontrace
