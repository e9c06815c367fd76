#pragma once

#include "lessons/course/course.h"
#include "sim/console/console.h"
#include "sim/learn/learn_options.h"

namespace moontrace {

/// Writes the pages of a lesson, black on white in true size, for swell paper: its items and the
/// texts that are read, a line each. Throws UsageError (no such lesson), InputError, LackError.
int PrintLesson(const LearnOptions& options, const Course& course, Console& console);

}  // namespace moontrace
