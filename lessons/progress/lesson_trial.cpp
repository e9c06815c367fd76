// What was done with what is shown: traces, answers, and leaving it.

#include <algorithm>
#include <optional>
#include <utility>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/answer.h"
#include "lessons/progress/lesson_path.h"
#include "lessons/progress/lesson_turn.h"
#include "lessons/progress/mastery.h"

namespace moontrace {

namespace {

using lesson_action::Await;
using lesson_action::Sentence;

ItemProgress ProgressOf(const Turn& turn, const std::string& item) {
  const auto found = turn.state.progress.items.find(item);
  return found != turn.state.progress.items.end() ? found->second : ItemProgress{};
}

void Remove(std::vector<std::string>& items, const std::string& item) {
  items.erase(std::remove(items.begin(), items.end(), item), items.end());
}

/// The trial of what is shown; its metrics are as they were measured.
Trial TrialOf(const Turn& turn, Trial trial) {
  const LessonState& state = turn.state;
  trial.lesson = state.progress.lesson;
  trial.step = state.progress.step;
  trial.kind = state.task;
  trial.item = state.item;
  trial.size = state.size;
  // A push that was on at any time has helped.
  trial.help = state.most_help;
  trial.guidance = GuidanceMode::kOff;
  if (state.most_help > 0) {
    trial.guidance = state.mode != GuidanceMode::kOff ? state.mode : GuidanceMode::kAttract;
  }
  trial.probe = state.probe && state.most_help == 0;
  trial.answer.clear();
  trial.latency = 0;
  trial.right = false;
  return trial;
}

/// What the trial has changed of the item: sure, smaller, larger.
void SayChange(Turn& turn, const std::string& item, const ItemProgress& before) {
  const ItemProgress after = ProgressOf(turn, item);
  const double size = SizeAt(turn.course, after.size_step);
  const bool known = before.trials > 0;
  if (after.size_step > before.size_step && known) Say(turn, Sentence::kSmallerNow, item, {}, size);
  if (after.size_step < before.size_step) Say(turn, Sentence::kLargerAgain, item, {}, size);
  if (Mastered(turn.course, after) && !Mastered(turn.course, before))
    Say(turn, Sentence::kSure, item);
}

/// To who fails again and again at the largest size: a lesson beside the course, once a session.
void OfferLesson(Turn& turn, const ItemProgress& before) {
  LessonState& state = turn.state;
  const bool begins_anew = before.introduced && !ProgressOf(turn, state.item).introduced;
  if (!begins_anew || state.offered) return;
  const std::vector<Lesson>& lessons = turn.course.lessons;
  const auto beside = std::find_if(lessons.begin(), lessons.end(),
                                   [](const Lesson& lesson) { return lesson.optional; });
  if (beside == lessons.end() || beside->id == state.progress.lesson) return;
  state.offered = true;
  SayCount(turn, Sentence::kOfferLesson, beside->title,
           static_cast<int>(beside - lessons.begin()) + 1, 0);
}

/// After a wrong answer: once more soon, a review at the session's beginning until it has gone a
/// size up.
void AskAgainLater(Turn& turn, const ItemProgress& before) {
  LessonState& state = turn.state;
  const ItemProgress after = ProgressOf(turn, state.item);
  const bool stepped_back = after.failures <= before.failures;
  if (state.review) {
    if (!stepped_back) state.reviews.push_back(state.item);
  } else if (std::find(state.queue.begin(), state.queue.end(), state.item) == state.queue.end()) {
    state.queue.push_back(state.item);
  }
}

/// Which of what is shown the step asks for: the item, or of a pair the other one.
std::string ItemOfStep(const Turn& turn) {
  const std::vector<std::string> open = Unfinished(turn.course, turn.state.progress);
  const bool mate = std::find(open.begin(), open.end(), turn.state.item) == open.end() &&
                    std::find(open.begin(), open.end(), turn.state.mate) != open.end();
  return mate ? turn.state.mate : turn.state.item;
}

/// What was said as an answer to the present question, and whether it is right.
struct Reply {
  std::string answer;  ///< empty: not known
  bool right = false;
};

std::optional<Reply> ReplyOf(const Turn& turn, const std::string& text) {
  const LessonState& state = turn.state;
  if (DoesNotKnow(text)) return Reply{};
  if (state.question == Question::kSame) {
    const std::optional<bool> same = SameSaid(text);
    if (!same) return std::nullopt;
    return Reply{*same ? "same" : "different", *same == (state.item == state.mate)};
  }
  const std::optional<std::string> said = ItemSaid(turn.course, text, state.item);
  if (!said) return std::nullopt;
  return Reply{*said, *said == state.item};
}

}  // namespace

void HandleTraced(Turn& turn, const lesson_event::Traced& traced) {
  LessonState& state = turn.state;
  if (state.await != Await::kTrace) {
    Say(turn, Sentence::kNotNow);
    return AwaitNow(turn, state.await);
  }
  Trial trial = TrialOf(turn, traced.measured);
  const bool led = state.task == StepKind::kDemonstrate;
  trial.right = led || GoodTrace(turn.course.mastery, trial);
  const bool good = trial.right;
  const double coverage = trial.coverage;
  const ItemProgress before = ProgressOf(turn, state.item);
  Keep(turn, std::move(trial));
  if (!led) {
    Say(turn, good ? Sentence::kTraceGood : Sentence::kTraceBad, state.item, {}, coverage);
    SayChange(turn, state.item, before);
    OfferLesson(turn, before);
  }
  GoOn(turn);
}

void HandleAnswered(Turn& turn, const lesson_event::Answered& answered) {
  LessonState& state = turn.state;
  if (state.await != Await::kAnswer) {
    Say(turn, Sentence::kNotAsked, Shortened(answered.text));
    return AwaitNow(turn, state.await);
  }
  const std::optional<Reply> reply = ReplyOf(turn, answered.text);
  if (!reply) {
    Say(turn, Sentence::kNotAnAnswer, Shortened(answered.text));
    Ask(turn);
    return AwaitNow(turn, state.await);
  }
  Trial trial = TrialOf(turn, answered.measured);
  if (!state.mate.empty()) trial.item += "\n" + state.mate;
  trial.answer = reply->answer;
  trial.right = reply->right;
  trial.latency = answered.latency >= 0 ? answered.latency : 0;
  const std::string shown = state.question == Question::kSame ? trial.item : state.item;
  const ItemProgress before = ProgressOf(turn, state.item);
  Keep(turn, std::move(trial));
  if (state.task != StepKind::kTest) {
    const bool unknown = reply->answer.empty();
    if (reply->right) Say(turn, Sentence::kRight, shown);
    if (unknown) Say(turn, Sentence::kTold, shown);
    if (!reply->right && !unknown) Say(turn, Sentence::kWrong, shown, reply->answer);
    SayChange(turn, state.item, before);
    OfferLesson(turn, before);
    if (!reply->right) AskAgainLater(turn, before);
  }
  state.another = state.task == StepKind::kTest || !reply->right;
  GoOn(turn);
}

void Skip(Turn& turn) {
  LessonState& state = turn.state;
  if (!state.own_text.empty()) {
    state.own_text.clear();
    return GoOn(turn);
  }
  switch (state.task) {
    case StepKind::kExplore:
    case StepKind::kRead:
      if (StepNow(turn) != nullptr) EndStepNow(turn, *LessonNow(turn), *StepNow(turn));
      break;
    case StepKind::kDemonstrate: {
      // The item has been named all the same. At a step that only shows, it is left with that.
      state.named.push_back(state.item);
      const Step* step = StepNow(turn);
      if (step != nullptr && step->kind == StepKind::kDemonstrate) {
        state.skipped.push_back(state.item);
      }
      break;
    }
    case StepKind::kTrace:
    case StepKind::kRecognise:
    case StepKind::kTest:
      // A test does not say what it was.
      Say(turn, Sentence::kSkipped, state.task == StepKind::kTest ? "" : state.item);
      if (!state.review) state.skipped.push_back(ItemOfStep(turn));
      Remove(state.queue, state.item);
      state.another = state.task != StepKind::kTrace;
      break;
  }
  GoOn(turn);
}

}  // namespace moontrace
