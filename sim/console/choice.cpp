#include "sim/console/choice.h"

#include <array>

#include "textures/base/utf8.h"

namespace moontrace {
namespace {

struct Number {
  std::string_view figure, word, ordinal;
};
constexpr std::array<Number, 4> kNumbers{{{"1", "one", "first"},
                                          {"2", "two", "second"},
                                          {"3", "three", "third"},
                                          {"4", "four", "fourth"}}};

bool Names(std::string_view word, const std::string& choice, std::size_t number) {
  if (word.size() > 1 && std::string_view(choice).substr(0, word.size()) == word) return true;
  if (number >= kNumbers.size()) return false;
  const Number& said = kNumbers[number];
  return word == said.figure || word == said.word || word == said.ordinal;
}

}  // namespace

std::optional<std::size_t> ChoiceOf(std::string_view line,
                                    const std::vector<std::string>& choices) {
  const std::string said = CaseFolded(line);
  constexpr std::string_view kBetween = " \t\r\n.,;:!?()\"'/";
  std::optional<std::size_t> chosen;
  for (std::size_t begin = 0; begin < said.size();) {
    std::size_t end = said.find_first_of(kBetween, begin);
    if (end == std::string::npos) end = said.size();
    std::string_view word = std::string_view(said).substr(begin, end - begin);
    begin = end + 1;
    if (word == "one" && chosen) continue;  // the second one
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (!Names(word, choices[i], i)) continue;
      if (chosen && *chosen != i) return std::nullopt;
      chosen = i;
    }
  }
  return chosen;
}

}  // namespace moontrace
