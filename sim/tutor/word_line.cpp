#include "sim/tutor/word_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sim/tutor/word_messages.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view Trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool IsWithin(const NumberRule& rule, double value) {
  constexpr double kRounding = 1e-9;  // of "0.1 m" in mm
  return value >= rule.low - kRounding && value <= rule.high + kRounding;
}

/// A number and its unit in the rule's own; nothing if it is none.
std::optional<double> NumberIn(const NumberRule& rule, std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [after, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit = Trimmed(text.substr(static_cast<std::size_t>(after - text.data())));
  if (unit.empty()) {
    const bool as_is = rule.units.empty() || IsWithin(rule, value);
    return as_is ? value : value * rule.units.front().factor;
  }
  for (const NumberUnit& known : rule.units) {
    if (unit == known.name) return value * known.factor;
  }
  return std::nullopt;
}

}  // namespace

WordLine SplitWord(std::string_view line) {
  const std::string_view whole = Trimmed(line);
  const std::size_t end = std::min(whole.find_first_of(kBlanks), whole.size());
  return {LowerCase(whole.substr(0, end)), std::string(Trimmed(whole.substr(end)))};
}

WordChoice ChooseWord(std::string_view given, const std::vector<std::string>& words) {
  WordChoice choice;
  std::size_t begun = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (given == words[i] || given == std::to_string(i + 1)) return {i, {}};
    if (words[i].compare(0, given.size(), given) != 0) continue;
    choice.begun.push_back(words[i]);
    begun = i;
  }
  if (choice.begun.size() == 1) choice.index = begun;
  return choice;
}

std::variant<double, std::string> ReadNumberBehind(std::string_view word, const NumberRule& rule,
                                                   std::string_view behind) {
  if (behind.empty()) return say::WordWants(word, rule.wants);
  const std::optional<double> value = NumberIn(rule, LowerCase(behind));
  if (!value) return say::WordCannotBe(word, behind, rule.wants);
  if (!IsWithin(rule, *value)) return say::WordOutOfRange(word, behind, rule.wants);
  return *value * rule.scale;
}

}  // namespace moontrace
