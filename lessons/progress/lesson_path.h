#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/progress/progress.h"

namespace moontrace {

/// A learner's path through a course: when a step or a lesson is finished, and what comes next.

/// Whether an item has shown what the present step asks of it:
///
/// - demonstrate: it was gone through once;
/// - trace: one trial here at least, and its last `traces` traces at its size within the rule (here
///   and at the step's size, where the step names one). An item that is never to be named has to
///   come down to standard size by its traces;
/// - recognise, by name: one trial here at least, and sure at standard size; where the step names a
///   size, its last `attempts` answers here within the rule; in pairs (pick, same): the same;
/// - test: asked once.
///
/// Guided trials count for none of these.
bool ItemFinished(const Course& course, const Progress& progress, const Step& step,
                  std::string_view text);

/// Items of the present step that have not been finished; none where there is no step.
std::vector<std::string> Unfinished(const Course& course, const Progress& progress);

/// Of a test: how many were asked, and named right.
struct TestScore {
  int right = 0, asked = 0;
};
TestScore ScoreOf(const Progress& progress);
/// All asked and the rule's share right.
bool TestPassed(const Course& course, const Progress& progress);

/// Whether all lessons are done.
bool CourseDone(const Course& course, const Progress& progress);

/// The lesson to go to from this one, none once all are done: the next in the course's order that
/// is not done and whose needs are; otherwise the next that is not done; otherwise, from the
/// course's beginning, what was left over, needs first.
std::optional<std::size_t> LessonAfter(const Course& course, const Progress& progress,
                                       std::string_view lesson);

/// The lesson behind the one where the learner is, done or not, without those beside the course:
/// where a tutor goes on to. From one beside it: where the course goes on. None: that was the last.
std::optional<std::size_t> NextInOrder(const Course& course, const Progress& progress);

/// To the beginning of a step; what was shown at the last one is forgotten.
void MoveTo(Progress& progress, std::string_view lesson, std::size_t step);

/// The present step has ended. A test whose items were all asked, too few of them named right,
/// comes again once what was wrong is sure (Progress::practise). Otherwise the next step comes;
/// after the last one the lesson is done, unless one of its steps was left unfinished, and the next
/// lesson begins. At the end of the course the place is behind the last step.
void EndStep(const Course& course, Progress& progress);

}  // namespace moontrace
