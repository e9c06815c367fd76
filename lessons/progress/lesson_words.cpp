// Words of the learner and the tutor, who overrules anything.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lessons/course/lesson_items.h"
#include "lessons/guide/fading.h"
#include "lessons/progress/answer.h"
#include "lessons/progress/lesson_path.h"
#include "lessons/progress/lesson_turn.h"
#include "lessons/progress/mastery.h"

namespace moontrace {

namespace {

using lesson_action::Await;
using lesson_action::Sentence;
using lesson_event::Overrule;
using lesson_event::Word;

constexpr double kSpeedFactor = 1.25, kSlowest = 0.25, kFastest = 4;
constexpr double kSmallestSize = 1e-3, kLargestSize = 0.2;  ///< that a tutor can ask for [m]

bool IsAsked(const Turn& turn) {
  return turn.state.task == StepKind::kRecognise || turn.state.task == StepKind::kTest;
}

/// The next size of the ladder beyond the one that is shown; none: there is no such.
std::optional<double> SizeBeyond(const Turn& turn, bool larger) {
  std::optional<double> beyond;
  for (const double size : turn.course.sizes) {
    if (SameSize(size, turn.state.size) || (size > turn.state.size) != larger) continue;
    const bool nearer =
        !beyond || std::abs(size - turn.state.size) < std::abs(*beyond - turn.state.size);
    if (nearer) beyond = size;
  }
  return beyond;
}

void ChangeSize(Turn& turn, bool larger) {
  const std::optional<double> size = SizeBeyond(turn, larger);
  if (!size) {
    Say(turn, larger ? Sentence::kCannotLarger : Sentence::kCannotSmaller);
    return AwaitNow(turn, turn.state.await);
  }
  turn.state.overrule.size = size;
  // Back to what the rules want: they may choose again.
  if (SameSize(*size, SizeByRules(turn))) turn.state.overrule.size.reset();
  Say(turn, Sentence::kSizeNow, {}, {}, *size);
  ShowPage(turn);
}

/// The push as it has been overruled, on the page that is felt.
void PushAnew(Turn& turn) {
  if (IsAsked(turn)) {
    Say(turn, Sentence::kNoHelpHere);
    return AwaitNow(turn, turn.state.await);
  }
  ChangePush(turn);
}

/// Help of the next trials by one more or less; of this one too, unless the hand is being led.
void ChangeHelp(Turn& turn, bool more) {
  LessonState& state = turn.state;
  if (IsAsked(turn)) {
    Say(turn, Sentence::kNoHelpHere);
    return AwaitNow(turn, state.await);
  }
  const int planned = HelpByRules(turn);
  const int help = state.probe ? 0 : planned;
  if (more ? help >= kMostHelp : help <= 0) {
    Say(turn, more ? Sentence::kNoMoreHelp : Sentence::kNoLessHelp);
    return AwaitNow(turn, state.await);
  }
  // In a probe, more help is the help that the plan held back: then it is a probe no longer.
  const int next = state.probe ? planned : help + (more ? 1 : -1);
  state.probe = false;
  if (more && state.overrule.mode == GuidanceMode::kOff) state.overrule.mode.reset();
  state.overrule.help.reset();
  if (HelpByRules(turn) != next) state.overrule.help = next;  // otherwise the rules may choose
  Say(turn, Sentence::kHelpNow, {}, {}, next);
  ChangePush(turn);
}

void ChangeSpeed(Turn& turn, double factor) {
  turn.state.speed = std::clamp(turn.state.speed * factor, kSlowest, kFastest);
  Say(turn, Sentence::kSpeedNow, {}, {}, turn.state.speed);
  ChangePush(turn);
}

void GiveHint(Turn& turn) {
  const std::string hint = HintNow(turn);
  if (hint.empty()) {
    SayCount(turn, Sentence::kNoHint, {}, IsAsked(turn) ? 1 : 0, 0);
  } else {
    Say(turn, Sentence::kHint, hint);
  }
  AwaitNow(turn, turn.state.await);
}

void Again(Turn& turn) {
  const Step* step = StepNow(turn);
  const bool text = turn.state.task == StepKind::kExplore || turn.state.task == StepKind::kRead;
  if (text && turn.state.own_text.empty() && step != nullptr && !step->say.empty())
    Say(turn, Sentence::kCourseText, step->say);
  Ask(turn);
  ShowPage(turn);
}

/// To the newest page of this lesson that was there to be felt or read: the signs behind it come
/// again where they are not sure.
void Back(Turn& turn) {
  if (IsAsked(turn)) {
    Say(turn, Sentence::kNoWayBack);
    return AwaitNow(turn, turn.state.await);
  }
  const Lesson* lesson = LessonNow(turn);
  for (std::size_t step = turn.state.progress.step; lesson != nullptr && step > 0; --step) {
    const StepKind kind = lesson->steps[step - 1].kind;
    if (kind != StepKind::kExplore && kind != StepKind::kRead) continue;
    KeepArrival(turn, *lesson, step - 1);
    ForgetStep(turn);
    turn.state.own_text.clear();
    turn.state.reviews.clear();
    return GoOn(turn);
  }
  Say(turn, Sentence::kNoTextBefore);
  AwaitNow(turn, turn.state.await);
}

/// Goes to another lesson; if there is none, says so and stays.
void Leap(Turn& turn, const Overrule& overrule) {
  const auto there = overrule.lesson ? LessonIndex(turn.course, *overrule.lesson)
                                     : NextInOrder(turn.course, turn.state.progress);
  if (!there) {
    if (overrule.lesson) {
      Say(turn, Sentence::kNoSuchLesson, Shortened(*overrule.lesson));
    } else {
      Say(turn, Sentence::kLastLesson);
    }
    return AwaitNow(turn, turn.state.await);
  }
  GoToLesson(turn, turn.course.lessons[*there]);
}

/// Takes over what is set; true if anything was.
bool Merge(Turn& turn, const Overrule& overrule) {
  LessonState& state = turn.state;
  const bool size = overrule.size && std::isfinite(*overrule.size);
  if (size) {
    state.overrule.size = std::clamp(*overrule.size, kSmallestSize, kLargestSize);
    const Sentence now = *overrule.size > kLargestSize    ? Sentence::kLargestSize
                         : *overrule.size < kSmallestSize ? Sentence::kSmallestSize
                                                          : Sentence::kSizeNow;
    lesson_action::Say say{now, {}, {}, *state.overrule.size};
    constexpr double kMost = 1e6;  // [mm]
    const double asked = std::min(1e3 * *overrule.size, kMost);
    if (now == Sentence::kLargestSize) say.number = static_cast<int>(std::lround(asked));
    turn.actions.emplace_back(std::move(say));
  }
  if (overrule.mode) {
    state.overrule.mode = overrule.mode;
    Say(turn, Sentence::kModeNow, NameOf(*overrule.mode));
  }
  if (overrule.help) {
    state.overrule.help = std::clamp(*overrule.help, 0, kMostHelp);
    if (*state.overrule.help > 0) state.probe = false;
    Say(turn, Sentence::kHelpNow, {}, {}, *state.overrule.help);
  }
  return size || overrule.mode || overrule.help;
}

/// Of the lesson that an item comes in, from 1, as the list of lessons has it.
int LessonNumber(const Turn& turn, const std::string& item) {
  const Lesson* home = HomeOf(turn.course, item);
  return home != nullptr ? static_cast<int>(home - turn.course.lessons.data()) + 1 : 0;
}

/// A review that is left for something else comes again behind it.
void PutBackReview(Turn& turn) {
  LessonState& state = turn.state;
  const bool asked = state.review && !state.item.empty() && state.await == Await::kAnswer;
  if (asked) state.reviews.insert(state.reviews.begin(), state.item);
}

}  // namespace

void HandleOwnText(Turn& turn, const std::string& text) {
  if (turn.state.own_text.empty()) PutBackReview(turn);
  PresentOwnText(turn, text);
}

/// A sign that was learned before is traced once more, whatever is asked now; that comes again.
void HandlePractise(Turn& turn, const std::string& name) {
  const std::optional<std::string> item = ItemSaid(turn.course, name, {});
  if (!item || !IsIntroduced(turn, *item)) {
    SayCount(turn, Sentence::kCannotPractise, item ? *item : Shortened(name),
             item ? LessonNumber(turn, *item) : 0, 0);
    return AwaitNow(turn, turn.state.await);
  }
  PutBackReview(turn);
  PresentItem(turn, *item, StepKind::kTrace, true);
}

void HandleSaid(Turn& turn, const lesson_event::Said& said) {
  if (turn.state.await == Await::kEnd) {
    Say(turn, Sentence::kCourseDone);
    return AwaitNow(turn, Await::kEnd);
  }
  switch (said.word) {
    case Word::kAgain:
      return Again(turn);
    case Word::kNext:
      return Skip(turn);
    case Word::kBack:
      return Back(turn);
    case Word::kBigger:
      return ChangeSize(turn, true);
    case Word::kSmaller:
      return ChangeSize(turn, false);
    case Word::kMoreHelp:
      return ChangeHelp(turn, true);
    case Word::kLessHelp:
      return ChangeHelp(turn, false);
    case Word::kSlower:
      return ChangeSpeed(turn, 1 / kSpeedFactor);
    case Word::kFaster:
      return ChangeSpeed(turn, kSpeedFactor);
    case Word::kHint:
      return GiveHint(turn);
  }
  AwaitNow(turn, turn.state.await);
}

void HandleOverrule(Turn& turn, const Overrule& overrule) {
  LessonState& state = turn.state;
  const bool end = state.await == Await::kEnd;
  const bool changed = Merge(turn, overrule);
  if (overrule.lesson || overrule.next_lesson) return Leap(turn, overrule);
  if (overrule.practise) return HandlePractise(turn, *overrule.practise);
  if (overrule.skip) return HandleSaid(turn, {Word::kNext, true});
  if (!changed) {
    state.overrule = {};
    Say(turn, Sentence::kByRules);
  }
  if (end) return AwaitNow(turn, Await::kEnd);
  if (overrule.size || !changed) return ShowPage(turn);
  PushAnew(turn);
}

}  // namespace moontrace
