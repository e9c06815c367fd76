#include "lessons/machine/lesson_machine.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lessons/course/lesson_items.h"
#include "lessons/machine/item_choice.h"
#include "lessons/machine/lesson_turn.h"
#include "lessons/machine/lesson_way.h"
#include "lessons/machine/mastery.h"

namespace moontrace {

namespace {

using lesson_action::Await;
using lesson_action::Sentence;

/// Lessons and steps that can end without an event, at most, before something awaits one.
std::size_t MostSteps(const Course& course) {
  std::size_t count = 2;
  for (const Lesson& lesson : course.lessons) count += 1 + lesson.steps.size();
  return count;
}

void End(Turn& turn) {
  turn.state.ended = true;
  turn.state.item.clear();
  turn.state.mate.clear();
  Say(turn, Sentence::kCourseDone);
  AwaitNow(turn, Await::kEnd);
}

/// The beginning of a step, aloud: the lesson's title if it is another, what the course says, what
/// is coming.
void Announce(Turn& turn, const Lesson& lesson, const Step& step) {
  LessonState& state = turn.state;
  state.announced = true;
  if (state.lesson_told != lesson.id) {
    state.lesson_told = lesson.id;
    const auto index = LessonIndex(turn.course, lesson.id);
    SayCount(turn, Sentence::kLesson, lesson.title, static_cast<int>(index.value_or(0)) + 1,
             static_cast<int>(turn.course.lessons.size()));
  }
  if (state.practising) return Say(turn, Sentence::kTestAgain);
  if (!step.say.empty()) Say(turn, Sentence::kCourseText, step.say);
  if (step.kind == StepKind::kTest) {
    const auto asked = Unfinished(turn.course, state.progress).size();
    if (asked > 0) SayCount(turn, Sentence::kTestBegins, {}, static_cast<int>(asked), 0);
  }
}

/// What belongs to the step alone.
void ForgetStep(Turn& turn) {
  turn.state.announced = false;
  turn.state.queue.clear();
  turn.state.skipped.clear();
  turn.state.item.clear();
  turn.state.mate.clear();
}

bool IsDone(const Turn& turn, const Lesson& lesson) {
  const std::vector<std::string>& done = turn.state.progress.done;
  return std::find(done.begin(), done.end(), lesson.id) != done.end();
}

/// Shows the next item of the step, if there is one.
bool PresentNext(Turn& turn) {
  LessonState& state = turn.state;
  ItemChooser chooser;
  chooser.random = state.random;
  chooser.queue = state.queue;
  chooser.skipped = state.skipped;
  chooser.last = state.item;
  chooser.last_traced = state.task == StepKind::kTrace || state.task == StepKind::kDemonstrate;
  const auto next = ChooseItem(turn.course, state.progress, chooser);
  state.random = chooser.random;
  state.queue = std::move(chooser.queue);
  if (next) PresentItem(turn, next->item, next->task, false);
  return next.has_value();
}

/// To the lesson where the learner is; true: there is one with steps.
bool FindPlace(Turn& turn) {
  if (StepNow(turn) != nullptr) return true;
  const auto next = LessonAfter(turn.course, turn.state.progress, turn.state.progress.lesson);
  if (!next) return false;
  KeepArrival(turn, turn.course.lessons[*next]);
  ForgetStep(turn);
  return StepNow(turn) != nullptr;
}

void Begin(Turn& turn) {
  LessonState& state = turn.state;
  state.begun = true;
  state.ended = false;
  state.session_begin = state.break_told = turn.time;
  state.lesson_told.clear();
  ForgetStep(turn);
  const Lesson* lesson = LessonNow(turn);
  if (lesson != nullptr) {
    Say(turn, Sentence::kWelcomeBack, lesson->title);
  } else {
    Say(turn, Sentence::kWelcome, turn.course.title);
  }
  FindPlace(turn);
  state.reviews = DueItems(turn.course, state.progress, turn.time);
  if (!state.reviews.empty()) {
    SayCount(turn, Sentence::kReviewDue, {}, static_cast<int>(state.reviews.size()), 0);
  }
  GoOn(turn);
}

/// Proposes a break each time that the course's while has been worked.
void ProposeBreak(Turn& turn) {
  LessonState& state = turn.state;
  const double after = turn.course.break_after;
  if (!state.begun || !(after > 0)) return;
  const auto since = [&](std::int64_t begin) {
    return static_cast<double>(turn.time) - static_cast<double>(begin);
  };
  if (since(state.break_told) < after) return;
  state.break_told = turn.time;
  const double minutes = std::clamp(since(state.session_begin) / 60, 0.0, 1e6);
  SayCount(turn, Sentence::kBreak, {}, static_cast<int>(minutes), 0);
}

}  // namespace

void EndStepNow(Turn& turn, const Lesson& lesson, const Step& step) {
  const std::size_t place = turn.state.progress.step;
  const bool test = step.kind == StepKind::kTest && !ItemsOf(lesson, step).empty();
  const bool failed = test && Unfinished(turn.course, turn.state.progress).empty() &&
                      !TestPassed(turn.course, turn.state.progress);
  if (test) {
    const TestScore score = ScoreOf(turn.state.progress);
    SayCount(turn, Sentence::kTestResult, {}, score.right, score.asked);
  }
  KeepStepEnd(turn);
  ForgetStep(turn);
  const Progress& now = turn.state.progress;
  if (now.lesson == lesson.id && now.step == place + 1 && now.step < lesson.steps.size()) return;
  if (failed && now.lesson == lesson.id && now.step <= place)
    return Say(turn, Sentence::kTestAgain);
  Say(turn, IsDone(turn, lesson) ? Sentence::kLessonDone : Sentence::kSkipped, lesson.title);
  turn.state.lesson_told.clear();
}

void GoOn(Turn& turn) {
  LessonState& state = turn.state;
  if (!state.reviews.empty()) {
    const std::string item = state.reviews.front();
    state.reviews.erase(state.reviews.begin());
    return PresentItem(turn, item, StepKind::kRecognise, true);
  }
  for (std::size_t left = MostSteps(turn.course); left > 0; --left) {
    if (!FindPlace(turn)) break;
    const Lesson& lesson = *LessonNow(turn);
    const Step& step = *StepNow(turn);
    const bool practising = !state.progress.practise.empty();
    if (practising != state.practising) state.announced = false;
    state.practising = practising;
    if (!state.announced) Announce(turn, lesson, step);
    if (step.kind == StepKind::kExplore || step.kind == StepKind::kRead) {
      return PresentText(turn, step);
    }
    if (PresentNext(turn)) return;
    EndStepNow(turn, lesson, step);
  }
  End(turn);
}

void GoToLesson(Turn& turn, const Lesson& lesson) {
  LessonState& state = turn.state;
  if (const Lesson* left = LessonNow(turn); left != nullptr && !IsDone(turn, *left)) {
    Say(turn, Sentence::kSkipped, left->title);
  }
  KeepArrival(turn, lesson);
  ForgetStep(turn);
  state.reviews.clear();
  state.lesson_told.clear();
  state.ended = false;
  GoOn(turn);
}

LessonState StartLesson(const Course&, Progress progress, std::uint64_t seed) {
  LessonState state;
  state.progress = std::move(progress);
  state.random = seed;
  return state;
}

LessonTurn Advance(const Course& course, LessonState state, const Event& event) {
  Turn turn{course, std::move(state), event.time, {}};
  const bool begin = std::holds_alternative<lesson_event::Begin>(event.what);
  if (begin || !turn.state.begun) {
    Begin(turn);  // whatever comes first, the learner has sat down
  } else {
    ProposeBreak(turn);
    if (const auto* traced = std::get_if<lesson_event::Traced>(&event.what)) {
      HandleTraced(turn, *traced);
    } else if (const auto* answered = std::get_if<lesson_event::Answered>(&event.what)) {
      HandleAnswered(turn, *answered);
    } else if (const auto* said = std::get_if<lesson_event::Said>(&event.what)) {
      HandleSaid(turn, *said);
    } else if (const auto* overrule = std::get_if<lesson_event::Overrule>(&event.what)) {
      HandleOverrule(turn, *overrule);
    } else {
      AwaitNow(turn, turn.state.await);
    }
  }
  return {std::move(turn.state), std::move(turn.actions)};
}

}  // namespace moontrace
