#pragma once

#include <cstdint>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/progress/lesson_state.h"
#include "lessons/progress/progress.h"

namespace moontrace {

struct LessonTurn {
  LessonState state;
  std::vector<Action> actions;
};

/// The state in which a learner with this progress sits down.
LessonState StartLesson(const Course& course, Progress progress, std::uint64_t seed);

/// The lesson machine: pure. Never throws on any event in any state: what does not fit is answered
/// by a sentence. The last action is always an Await.
LessonTurn Advance(const Course& course, LessonState state, const Event& event);

}  // namespace moontrace
