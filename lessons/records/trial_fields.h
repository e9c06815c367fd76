#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lessons/course/trial.h"

namespace moontrace {

/// One member of a Trial as data: a column of the records, a key of an export, a column of a CSV.
/// Members that are choices are written by name, yes or no as 1 or 0.
struct TrialField {
  using Value = std::variant<std::int64_t, double, std::string>;
  enum class Kind { kWhole, kReal, kText, kFlag };

  const char* name;  ///< with the unit in it: "size_m"
  Kind kind;
  Value (*get)(const Trial&);
  /// False, and nothing changed, where the value is of another type or no name of the choice.
  bool (*set)(Trial&, const Value&);
};

/// Every member of Trial, in the order of its declaration.
const std::vector<TrialField>& TrialFields();

/// Trials as CSV (RFC 4180, UTF-8): a row of names with units, then a row for each, numbers with
/// all their digits. Trials that are only a mark are left out. A text that begins with = + - @, a
/// tab or a carriage return has an apostrophe before it, so that no spreadsheet runs it as a
/// formula.
std::string TrialsToCsv(std::string_view learner, std::string_view course,
                        const std::vector<Trial>& trials);

}  // namespace moontrace
