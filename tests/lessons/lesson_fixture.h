#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lessons/progress/lesson_machine.h"

namespace moontrace {

inline Step MakeStep(StepKind kind, std::vector<std::string> items = {}) {
  Step step;
  step.kind = kind;
  step.items = std::move(items);
  return step;
}

inline Lesson MakeLesson(std::string id, std::vector<std::string> items, std::vector<Step> steps) {
  Lesson lesson;
  lesson.id = id;
  lesson.title = "Lesson " + id;
  lesson.items = std::move(items);
  lesson.steps = std::move(steps);
  return lesson;
}

/// Two lessons of letters on a ladder of three sizes, and a word.
inline Course SmallCourse() {
  Course course;
  course.id = "small";
  course.title = "Small course";
  course.script = "moon";
  course.sizes = {0.040, 0.020, 0.010};
  course.mates = {{"i", "t"}, {"t", "i"}, {"l", "o"}};
  course.names = {{",", "comma"}};
  Lesson first = MakeLesson("01", {"i", "t", "l"},
                            {MakeStep(StepKind::kExplore), MakeStep(StepKind::kTrace),
                             MakeStep(StepKind::kRecognise), MakeStep(StepKind::kTest)});
  first.steps[0].text = "itl";
  first.steps[0].say = "Feel these.";
  first.hints = {{"i", "an upright"}};
  Lesson second = MakeLesson(
      "02", {"o", ","},
      {MakeStep(StepKind::kDemonstrate), MakeStep(StepKind::kTrace), MakeStep(StepKind::kRecognise),
       MakeStep(StepKind::kRecognise, {"lit"}), MakeStep(StepKind::kRead)});
  second.steps[4].text = "lit oil";
  second.needs = {"01"};
  course.lessons = {first, second};
  return course;
}

/// A lesson that is worked through event by event, with what it said, showed and kept.
class LessonRun {
 public:
  explicit LessonRun(Course of, Progress progress = {}, std::uint64_t seed = 1)
      : course(std::move(of)), state(StartLesson(course, std::move(progress), seed)) {}

  template <typename What>
  void Do(What what) {
    Event event;
    event.time = time;
    event.what = std::move(what);
    LessonTurn turn = Advance(course, std::move(state), event);
    state = std::move(turn.state);
    actions = std::move(turn.actions);
    for (const Action& action : actions) {
      if (const auto* keep = std::get_if<lesson_action::Keep>(&action)) kept.push_back(keep->trial);
      if (const auto* page = std::get_if<lesson_action::Show>(&action)) show = *page;
      if (const auto* with = std::get_if<lesson_action::Push>(&action)) push = *with;
    }
    // a test may set the clock to its last second
    if (time < std::numeric_limits<std::int64_t>::max() - 10) time += 10;
  }
  void Begin() { Do(lesson_event::Begin{}); }
  void Say(lesson_event::Word word) { Do(lesson_event::Said{word, false}); }
  void Next() { Say(lesson_event::Word::kNext); }
  void Trace(bool good = true) {
    lesson_event::Traced traced;
    traced.measured.coverage = good ? 0.98 : 0.5;
    traced.measured.error_widths = good ? 0.1 : 2;
    Do(traced);
  }
  void Answer(std::string text, double latency = 8) {
    Do(lesson_event::Answered{std::move(text), latency, {}});
  }
  /// As a learner would who answers right or wrong and traces well or badly, as `good` says.
  void Work(bool good = true) {
    switch (state.await) {
      case lesson_action::Await::kTrace:
        return Trace(good);
      case lesson_action::Await::kAnswer:
        return Answer(good ? RightAnswer() : WrongAnswer());
      case lesson_action::Await::kNext:
        return Next();
      case lesson_action::Await::kEnd:
        return;
    }
  }
  /// What is right just now. (The machine's own state: a learner has only the page.)
  std::string RightAnswer() const {
    if (state.question == Question::kSame) return state.item == state.mate ? "same" : "different";
    return state.item;
  }
  std::string WrongAnswer() const {
    if (state.question == Question::kSame) return state.item == state.mate ? "different" : "same";
    if (!state.mate.empty()) return state.mate;
    return state.item == "i" ? "t" : "i";
  }

  bool Said(lesson_action::Sentence sentence) const { return Find(sentence) != nullptr; }
  const lesson_action::Say* Find(lesson_action::Sentence sentence) const {
    for (const Action& action : actions) {
      const auto* say = std::get_if<lesson_action::Say>(&action);
      if (say != nullptr && say->sentence == sentence) return say;
    }
    return nullptr;
  }
  const ItemProgress& Item(const std::string& item) { return state.progress.items[item]; }

  const Course course;
  LessonState state;
  std::vector<Action> actions;  ///< of the last event
  std::vector<Trial> kept;      ///< of all
  lesson_action::Show show;
  lesson_action::Push push;
  std::int64_t time = 1'700'000'000;  ///< of the next event [s]
};

}  // namespace moontrace
