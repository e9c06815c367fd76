#include "lessons/machine/lesson_machine.h"

#include <algorithm>
#include <utility>

#include "lessons/machine/item_choice.h"
#include "lessons/machine/lesson_turn.h"

namespace moontrace {

namespace {

using lesson_action::Sentence;

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
