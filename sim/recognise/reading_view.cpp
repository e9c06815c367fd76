#include "sim/recognise/reading_view.h"

#include <algorithm>
#include <string>
#include <vector>

#include "sim/reading/read_text.h"
#include "sim/recognise/recognise_messages.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

constexpr char32_t kFirstCell = 0x2800;  ///< of Unicode's Braille patterns

/// Braille cells by the numbers of their dots, a space behind each: panels have no font for cells.
std::u32string CellsAsDots(const std::u32string& text) {
  std::u32string dots;
  for (const char32_t c : text) {
    if (c <= kFirstCell || c >= kFirstCell + 0x100) {
      dots += c;
      continue;
    }
    for (unsigned dot = 0; dot < 8; ++dot) {
      if ((c >> dot & 1) != 0) dots += static_cast<char32_t>(U'1' + dot);
    }
    dots += U' ';
  }
  return dots;
}

/// Some three lines of the panel.
std::string EndOf(const std::string& text) {
  constexpr std::size_t kMost = 60;
  std::u32string points = CellsAsDots(ToCodePoints(text));
  while (!points.empty() && (points.back() == U'\n' || points.back() == U' ')) points.pop_back();
  std::replace(points.begin(), points.end(), U'\n', U' ');
  if (points.size() > kMost) points.erase(0, points.size() - kMost);
  std::string end;
  for (const char32_t c : points) end += ToUtf8(c);
  return end;
}

std::string Likeliest(const std::vector<SignGuess>& belief, const SignShapes& shapes,
                      const Script& script) {
  constexpr std::size_t kMost = 3;
  constexpr double kWorthSaying = 0.01;
  std::string words;
  for (std::size_t i = 0; i < belief.size() && i < kMost; ++i) {
    const SignGuess& guess = belief[i];
    if (i > 0 && guess.probability < kWorthSaying) break;
    const bool known = guess.sign != SignGuess::kUnknown;
    if (!words.empty()) words += ", ";
    words += say::Belief(known ? EndOf(TextOfSign(shapes.GlyphOf(guess.sign), script)) : "",
                         guess.probability);
  }
  return words;
}

}  // namespace

TrialTexts::Reading ReadingTexts(const PageReader& reader, const SignShapes& shapes,
                                 const Script& script) {
  std::vector<ReadToken> tokens = reader.tokens();
  for (const ReadToken& token : reader.Pending()) tokens.push_back(token);
  return {EndOf(say::Spoken(TextRead(tokens, script))), Likeliest(reader.belief(), shapes, script),
          say::Doing(reader.activity())};
}

}  // namespace moontrace
