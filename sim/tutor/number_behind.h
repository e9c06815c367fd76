#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace moontrace {

/// A unit that may stand behind a number.
struct NumberUnit {
  std::string_view name;
  double factor = 1;  ///< to the unit of `low` and `high`
};

/// The number that a word wants behind it.
struct NumberRule {
  const char* wants = "";  ///< for messages: "mm, 1 to 1000"
  double low = 0, high = 0;
  double scale = 1;               ///< to SI
  std::vector<NumberUnit> units;  ///< first the one of `wants`
};

/// The number in SI units; otherwise one line: what is wrong, and the cure. A number alone is in
/// the unit of the range, or in that of `wants` if only so it is within: depth 0.5 and depth 50.
std::variant<double, std::string> ReadNumberBehind(std::string_view word, const NumberRule& rule,
                                                   std::string_view behind);

}  // namespace moontrace
