#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/trial.h"

namespace moontrace {

/// Trials as CSV (RFC 4180, UTF-8): a row of names with units, then a row for each, numbers with
/// all their digits. Rows that only mark the way are left out.
std::string TrialsToCsv(std::string_view learner, std::string_view course,
                        const std::vector<Trial>& trials);

}  // namespace moontrace
