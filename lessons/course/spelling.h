#pragma once

#include <string_view>

#include "lessons/course/course.h"

namespace moontrace {

/// Lesson::spellings of every item that no lesson teaches, as its lesson's script and grade set it:
/// "bath" may be b, a and the sign TH. A lesson whose script cannot be had gets none; nor does one
/// of another script than the course's, whose pages teach no letters.
void AddSpellings(Course& course);

/// The learner's name as one more item of the steps that ask for it (Step::own_name), with its
/// spelling: where it is one short word that can be written with the signs taught by then, and no
/// item of the step already.
void AddOwnName(Course& course, std::string_view name);

}  // namespace moontrace
