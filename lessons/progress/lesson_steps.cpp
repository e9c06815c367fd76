#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/item_choice.h"
#include "lessons/progress/lesson_path.h"
#include "lessons/progress/lesson_turn.h"

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
  turn.state.own_text.clear();
  Say(turn, Sentence::kCourseDone);
  AwaitNow(turn, Await::kEnd);
}

/// The beginning of a step, aloud: what the course says, what is coming.
void Announce(Turn& turn, const Step& step) {
  LessonState& state = turn.state;
  if (std::exchange(state.announced, true)) return;
  state.another = false;
  if (state.practising) return Say(turn, Sentence::kTestAgain);
  const std::string& said = state.held && !step.say_held.empty() ? step.say_held : step.say;
  if (!said.empty()) Say(turn, Sentence::kCourseText, said);
  if (step.kind == StepKind::kTest) {
    const auto asked = Unfinished(turn.course, state.progress).size();
    if (asked > 0) SayCount(turn, Sentence::kTestBegins, {}, static_cast<int>(asked), 0);
  }
}

bool IsDone(const Turn& turn, const Lesson& lesson) {
  const std::vector<std::string>& done = turn.state.progress.done;
  return std::find(done.begin(), done.end(), lesson.id) != done.end();
}

/// Shows the next item of the step, if there is one. One that is new comes before what the course
/// says of a step that asks for it: who comes back has only heard it named.
bool PresentNext(Turn& turn, const Step& step) {
  LessonState& state = turn.state;
  ItemChooser chooser;
  chooser.random = state.random;
  chooser.queue = state.queue;
  chooser.skipped = state.skipped;
  chooser.named = state.named;
  chooser.last = state.item;
  chooser.last_traced = state.task == StepKind::kTrace || state.task == StepKind::kDemonstrate;
  const auto next = ChooseItem(turn.course, state.progress, chooser);
  state.random = chooser.random;
  state.queue = std::move(chooser.queue);
  const bool is_new =
      next && next->task == StepKind::kDemonstrate && step.kind != StepKind::kDemonstrate;
  const bool back = std::exchange(state.back, false) && !step.say.empty();
  const bool traces =
      next && next->task == StepKind::kTrace && step.kind == StepKind::kTrace;  // "Follow it."
  if (back && traces) Say(turn, Sentence::kOnWith, next->item);
  if (!is_new) Announce(turn, step);
  if (next) PresentItem(turn, next->item, next->task, false);
  return next.has_value();
}

}  // namespace

void SayLesson(Turn& turn, Sentence sentence, const Lesson& lesson) {
  turn.state.lesson_announced = lesson.id;
  const auto index = LessonIndex(turn.course, lesson.id);
  SayCount(turn, sentence, lesson.title, static_cast<int>(index.value_or(0)) + 1,
           lesson.optional ? 0 : static_cast<int>(LessonsInOrder(turn.course)));
}

void ForgetStep(Turn& turn) {
  turn.state.announced = false;
  turn.state.queue.clear();
  turn.state.skipped.clear();
  turn.state.item.clear();
  turn.state.mate.clear();
}

bool FindPlace(Turn& turn) {
  if (StepNow(turn) != nullptr) return true;
  const auto next = LessonAfter(turn.course, turn.state.progress, turn.state.progress.lesson);
  if (!next) return false;
  KeepArrival(turn, turn.course.lessons[*next]);
  ForgetStep(turn);
  return StepNow(turn) != nullptr;
}

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
  Say(turn, IsDone(turn, lesson) ? Sentence::kLessonDone : Sentence::kLessonLeft, lesson.title);
  turn.state.lesson_announced.clear();
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
    if (state.lesson_announced != lesson.id) SayLesson(turn, Sentence::kLesson, lesson);
    if (step.kind == StepKind::kExplore || step.kind == StepKind::kRead) {
      state.back = false;
      Announce(turn, step);
      return PresentText(turn, step);
    }
    if (PresentNext(turn, step)) return;
    EndStepNow(turn, lesson, step);
  }
  End(turn);
}

void GoToLesson(Turn& turn, const Lesson& lesson) {
  LessonState& state = turn.state;
  if (const Lesson* left = LessonNow(turn); left != nullptr && !IsDone(turn, *left)) {
    Say(turn, Sentence::kLessonLeft, left->title);
  }
  KeepArrival(turn, lesson);
  ForgetStep(turn);
  state.reviews.clear();
  state.lesson_announced.clear();
  state.ended = false;
  GoOn(turn);
}

}  // namespace moontrace
