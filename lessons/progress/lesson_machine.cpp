#include "lessons/progress/lesson_machine.h"

#include <algorithm>
#include <utility>

#include "lessons/progress/item_choice.h"
#include "lessons/progress/lesson_turn.h"
#include "textures/base/overload.h"

namespace moontrace {

namespace {

using lesson_action::Sentence;

void Begin(Turn& turn) {
  LessonState& state = turn.state;
  state.begun = true;
  state.ended = false;
  state.session_begin = state.break_announced = turn.time;
  state.lesson_announced.clear();
  state.offered = false;
  state.back = LessonNow(turn) != nullptr;
  ForgetStep(turn);
  const Lesson* lesson = LessonNow(turn);
  if (lesson != nullptr) {
    SayLesson(turn, Sentence::kWelcomeBack, *lesson);
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

/// Proposes a break each time the learner has worked for the course's `break_after`.
void ProposeBreak(Turn& turn) {
  LessonState& state = turn.state;
  const double after = turn.course.break_after;
  if (!state.begun || !(after > 0)) return;
  const auto since = [&](std::int64_t begin) {
    return static_cast<double>(turn.time) - static_cast<double>(begin);
  };
  if (since(state.break_announced) < after) return;
  state.break_announced = turn.time;
  const double minutes = std::clamp(since(state.session_begin) / 60, 0.0, 1e6);
  SayCount(turn, Sentence::kBreak, {}, static_cast<int>(minutes), 0);
}

}  // namespace

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
    std::visit(
        Overload{
            [](const lesson_event::Begin&) {},  // above
            [&turn](const lesson_event::Traced& traced) { HandleTraced(turn, traced); },
            [&turn](const lesson_event::Answered& answered) { HandleAnswered(turn, answered); },
            [&turn](const lesson_event::Said& said) { HandleSaid(turn, said); },
            [&turn](const lesson_event::Overrule& overrule) { HandleOverrule(turn, overrule); },
            [&turn](const lesson_event::OwnText& own) { HandleOwnText(turn, own.text); },
            [&turn](const lesson_event::Tick&) { AwaitNow(turn, turn.state.await); },
        },
        event.what);
  }
  return {std::move(turn.state), std::move(turn.actions)};
}

}  // namespace moontrace
