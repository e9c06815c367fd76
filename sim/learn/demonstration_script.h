#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// A part of the demonstration: a page, what is said of it line by line, then perhaps a question.
struct DemonstrationStep {
  std::string show;                  ///< text on the page; empty: the former one stays
  double size = 0.025;               ///< of its letters [m]
  std::vector<std::string> say;      ///< lines, in order
  std::string ask;                   ///< empty: nothing is asked
  std::vector<std::string> answers;  ///< right ones, in small letters
  std::string right, wrong;          ///< said to a right answer; to a wrong one, or to none
};

/// The demonstration that comes with the program, `lessons/demonstration.toml`. Throws InputError:
/// file:line:column, cause, cure.
std::vector<DemonstrationStep> ShippedDemonstration();
/// The same from TOML; `name` stands in messages.
std::vector<DemonstrationStep> ParseDemonstration(std::string_view toml, const std::string& name);

}  // namespace moontrace
