// Any event in any state: the machine always goes on, and what it keeps tells all that it knows.

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/learning.h"
#include "tests/lessons/lesson_fixture.h"

namespace moontrace {
namespace {

using lesson_action::Await;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class RandomEvents {
 public:
  RandomEvents(const Course& course, unsigned seed) : course_(course), random_(seed) {
    for (const std::string& item : AllItems(course)) items_.push_back(item);
  }

  /// Fitting events four times in five, else any at all, strange numbers and times among them.
  void Next(LessonRun& run) {
    if (Chance(200))
      run.time = AnyOf<std::int64_t>({0, -1, std::numeric_limits<std::int64_t>::min(),
                                      std::numeric_limits<std::int64_t>::max()});
    if (Chance(50)) run.time = 1'700'000'000 + Below(100) * 86'400;
    if (!Chance(5)) return run.Work(!Chance(6));
    switch (Below(6)) {
      case 0:
        return run.Do(lesson_event::Begin{});
      case 1:
        return run.Do(AnyTrace());
      case 2:
        return run.Answer(AnyOf(items_), AnyNumber());
      case 3:
        return run.Answer(AnyOf<std::string>({"", "same", "different", "letter b", "no such",
                                              "\xff\xfe", std::string(5000, 'x'), "capital T."}));
      case 4:
        return run.Do(lesson_event::Said{static_cast<lesson_event::Word>(Below(9)), Chance(2)});
      default:
        return Chance(2) ? run.Do(lesson_event::Tick{}) : run.Do(AnyOverrule());
    }
  }

 private:
  bool Chance(int one_in) { return Below(one_in) == 0; }
  int Below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  template <typename T>
  T AnyOf(const std::vector<T>& values) {
    return values.empty() ? T{} : values[random_() % values.size()];
  }
  double AnyNumber() {
    return AnyOf<double>({0, 1, 0.95, -1, 1e300, kNan, kInfinity, -kInfinity, 0.02});
  }
  lesson_event::Traced AnyTrace() {
    lesson_event::Traced traced;
    traced.measured.coverage = AnyNumber();
    traced.measured.error_widths = AnyNumber();
    traced.measured.scaled = Chance(4);
    traced.measured.lesson = "no such";
    traced.measured.size = AnyNumber();
    return traced;
  }
  lesson_event::Overrule AnyOverrule() {
    lesson_event::Overrule overrule;
    if (Chance(3)) overrule.size = AnyNumber();
    if (Chance(3)) overrule.help = AnyOf<int>({0, 5, 10, -3, 1000});
    if (Chance(3)) overrule.mode = static_cast<GuidanceMode>(Below(6));
    if (Chance(8))
      overrule.lesson = Chance(3) || course_.lessons.empty()
                            ? "no such"
                            : course_
                                  .lessons[static_cast<std::size_t>(
                                      Below(static_cast<int>(course_.lessons.size())))]
                                  .id;
    overrule.next_lesson = Chance(12);
    overrule.skip = Chance(6);
    return overrule;
  }

  const Course& course_;
  std::mt19937 random_;
  std::vector<std::string> items_;
};

/// What must hold after every event.
void ExpectSound(const LessonRun& run) {
  ASSERT_FALSE(run.actions.empty());
  const auto* await = std::get_if<Await>(&run.actions.back());
  ASSERT_NE(await, nullptr) << "the last action is what is awaited";
  ASSERT_EQ(*await, run.state.await);
  ASSERT_LT(run.actions.size(), 60u);
  const std::size_t items = AllItems(run.course).size();
  ASSERT_LE(run.state.queue.size(), items);
  ASSERT_LE(run.state.reviews.size(), items);
  ASSERT_LE(run.state.skipped.size(), items);
  ASSERT_LE(run.state.progress.items.size(), items);
  ASSERT_LE(run.state.progress.confusions.size(), items);
  ASSERT_LE(run.state.progress.here.size(), items);
  ASSERT_LE(run.state.progress.practise.size(), items);
  ASSERT_LE(run.state.progress.recent.size(), 20u);
  for (const auto& [text, item] : run.state.progress.items) {
    ASSERT_LT(item.size_step, std::max<std::size_t>(1, run.course.sizes.size()));
    ASSERT_LE(item.named.size(), 5u);
    ASSERT_GE(item.help, 0);
    ASSERT_LE(item.help, 10);
  }
  if (*await == Await::kTrace || *await == Await::kAnswer) {
    ASSERT_FALSE(run.state.item.empty());
  }
  for (const Trial& trial : run.kept) ASSERT_LT(trial.answer.size(), 100u);
}

/// Random events; after each, progress is what its kept trials tell.
void Batter(const Course& course, unsigned seed, int events) {
  LessonRun run(course, {}, seed);
  RandomEvents random(course, seed);
  Progress told;
  std::size_t learned = 0;
  for (int i = 0; i < events; ++i) {
    random.Next(run);
    if (run.actions.empty()) continue;  // work at the end of the course is no event
    ASSERT_NO_FATAL_FAILURE(ExpectSound(run)) << "seed " << seed << ", event " << i;
    for (; learned < run.kept.size(); ++learned) told = Learn(course, told, run.kept[learned]);
    ASSERT_EQ(told, run.state.progress) << "seed " << seed << ", event " << i;
  }
}

Course OddCourse() {
  Course course;
  course.title = "Odd";
  course.fade.rule = "no such rule";
  course.fade.probe_every = 0;
  course.mastery.attempts = 0;
  course.mastery.failures = 0;
  course.mastery.traces = -1;
  Step pick = MakeStep(StepKind::kRecognise, {"a", "b", "a", ""});
  pick.question = Question::kPick;
  Step same = MakeStep(StepKind::kTest, {"c"});
  same.question = Question::kSame;
  same.size = 0.03;
  course.mates = {{"a", "a"}, {"b", "no such"}};
  course.lessons = {
      MakeLesson("none", {}, {}),
      MakeLesson("empty", {}, {MakeStep(StepKind::kTest), MakeStep(StepKind::kTrace)}),
      MakeLesson("odd", {"a"}, {pick, same, MakeStep(StepKind::kTrace)}),
      MakeLesson("odd", {"z"}, {MakeStep(StepKind::kRecognise)})};
  course.lessons[2].needs = {"odd", "nowhere"};
  return course;
}

Course PairsCourse() {
  Course course = SmallCourse();
  Step pick = MakeStep(StepKind::kRecognise, {"i", "l"}), same = pick;
  pick.question = Question::kPick;
  same.question = Question::kSame;
  same.size = 0.025;
  Step sized = MakeStep(StepKind::kTrace);
  sized.size = 0.015;
  Step test = MakeStep(StepKind::kTest, {"i", "t", "l"});
  test.question = Question::kPick;
  course.lessons[0].steps.insert(course.lessons[0].steps.begin() + 1, {sized, same, pick, test});
  return course;
}

TEST(LessonMachine, GoesOnAfterAnyEventInAnyState) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    ASSERT_NO_FATAL_FAILURE(Batter(SmallCourse(), seed, 500));
    ASSERT_NO_FATAL_FAILURE(Batter(PairsCourse(), seed, 500));
    ASSERT_NO_FATAL_FAILURE(Batter(OddCourse(), seed, 300));
    ASSERT_NO_FATAL_FAILURE(Batter(Course{}, seed, 50));
  }
}

TEST(LessonMachine, GoesOnAfterAnyEventInTheShippedCourse) {
  const Course course = LoadCourse("learn-moon");
  for (unsigned seed = 1; seed <= 3; ++seed) {
    ASSERT_NO_FATAL_FAILURE(Batter(course, seed, 300));
  }
}

// Cut anywhere after a kept trial: whoever sits down again is where the learner was, and the first
// page is of a step that is still open.
TEST(LessonMachine, ResumesWhereItWasWhereverItIsCut) {
  const Course course = PairsCourse();
  LessonRun run(course, {}, 5);
  RandomEvents random(course, 5);
  for (int i = 0; i < 600; ++i) random.Next(run);
  Progress told;
  for (const Trial& trial : run.kept) {
    told = Learn(course, told, trial);
    LessonRun again(course, told, 9);
    again.time = trial.time;
    again.Begin();
    ASSERT_NO_FATAL_FAILURE(ExpectSound(again));
    if (!again.kept.empty()) continue;  // it had just ended a step, and goes on to the next
    ASSERT_EQ(again.state.progress, told);
    if (told.trials_in_step > 0) {
      ASSERT_EQ(again.state.progress.lesson, told.lesson);
      ASSERT_EQ(again.state.progress.step, told.step);
    }
  }
}

}  // namespace
}  // namespace moontrace
