#include "sim/tutor/number_behind.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "sim/console/word_messages.h"
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

std::variant<double, std::string> ReadNumberBehind(std::string_view word, const NumberRule& rule,
                                                   std::string_view behind) {
  if (behind.empty()) return say::WordWants(word, rule.wants);
  const std::optional<double> value = NumberIn(rule, LowerCase(behind));
  if (!value) return say::WordCannotBe(word, behind, rule.wants);
  if (!IsWithin(rule, *value)) return say::WordOutOfRange(word, behind, rule.wants);
  return *value * rule.scale;
}

}  // namespace moontrace
