#pragma once

#include <cstddef>
#include <vector>

#include "lessons/course/course.h"

namespace moontrace {

/// The order for a learner who does every lesson once, as indices into Course::lessons.
struct LessonOrder {
  /// Each lesson after those it needs: the next one in the course's order whose needs are done;
  /// otherwise, from the course's beginning, what was left over.
  std::vector<std::size_t> walk;
  /// Those that are never reached: a need is unknown, goes round in a circle, or is itself one of
  /// them. In the course's order.
  std::vector<std::size_t> unreachable;
};

/// Takes time quadratic in lessons, linear in needs.
LessonOrder OrderOf(const Course& course);

/// Lessons that need each other in a circle, from this one through its first needs back to it;
/// empty if it is in none.
std::vector<std::size_t> CircleOf(const Course& course, std::size_t lesson);

}  // namespace moontrace
