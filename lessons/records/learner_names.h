#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/records/learner_history.h"

/// Which of the learners in the records a name means: the same in lessons, books and reports.
namespace moontrace {

/// Those that are people, without simulated learners, in the order of the records.
std::vector<std::string> PeopleAmong(const std::vector<LearnerEntry>& known);

/// The name under which somebody is kept who is called so but for capitals; the given one for
/// nobody, or for several.
std::string KeptName(std::string_view given, const std::vector<LearnerEntry>& known);

}  // namespace moontrace
