#include "lessons/progress/lesson_turn.h"

#include <algorithm>
#include <utility>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/learning.h"

namespace moontrace {

namespace {

void KeepMark(Turn& turn, std::string_view lesson, std::size_t step, StepKind kind, bool ended) {
  Trial mark;
  mark.lesson = lesson;
  mark.step = step;
  mark.kind = kind;
  mark.right = ended;
  Keep(turn, std::move(mark));
}

}  // namespace

void Say(Turn& turn, lesson_action::Sentence sentence, std::string_view text,
         std::string_view other, double value) {
  lesson_action::Say say;
  say.sentence = sentence;
  say.text = text;
  say.other = other;
  say.value = value;
  turn.actions.emplace_back(std::move(say));
}

void SayCount(Turn& turn, lesson_action::Sentence sentence, std::string_view text, int number,
              int of) {
  lesson_action::Say say;
  say.sentence = sentence;
  say.text = text;
  say.number = number;
  say.of = of;
  turn.actions.emplace_back(std::move(say));
}

void AwaitNow(Turn& turn, lesson_action::Await await) {
  turn.state.await = await;
  turn.actions.emplace_back(await);
}

void Keep(Turn& turn, Trial trial) {
  trial.time = turn.time;
  trial.simulated = trial.simulated || turn.state.simulated;
  trial.scaled = trial.scaled || turn.state.scaled;
  turn.state.progress = Learn(turn.course, std::move(turn.state.progress), trial);
  // what was only named, and goes wrong, is shown after all
  if (!trial.right) std::erase(turn.state.named, trial.item);
  turn.actions.emplace_back(lesson_action::Keep{std::move(trial)});
}

void KeepStepEnd(Turn& turn) {
  const Step* step = StepNow(turn);
  KeepMark(turn, turn.state.progress.lesson, turn.state.progress.step,
           step != nullptr ? step->kind : StepKind::kExplore, true);
}

void KeepArrival(Turn& turn, const Lesson& lesson, std::size_t step) {
  const bool there = step < lesson.steps.size();
  KeepMark(turn, lesson.id, step, there ? lesson.steps[step].kind : StepKind::kExplore, false);
}

const Lesson* LessonNow(const Turn& turn) {
  const auto index = LessonIndex(turn.course, turn.state.progress.lesson);
  return index ? &turn.course.lessons[*index] : nullptr;
}

const Step* StepNow(const Turn& turn) {
  return StepAt(turn.course, turn.state.progress.lesson, turn.state.progress.step);
}

bool IsIntroduced(const Turn& turn, const std::string& item) {
  const auto found = turn.state.progress.items.find(item);
  const std::vector<std::string>& named = turn.state.named;
  return (found != turn.state.progress.items.end() && found->second.introduced) ||
         std::find(named.begin(), named.end(), item) != named.end();
}

std::string Shortened(std::string_view text) {
  constexpr std::size_t kMost = 60;
  if (text.size() <= kMost) return std::string(text);
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end));
}

}  // namespace moontrace
