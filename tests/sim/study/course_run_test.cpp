// A simulated learner goes through a course by the real lesson machine, each trial through the real
// scene.
#include "sim/study/course_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace moontrace {
namespace {

Course SmallCourse() {
  Course course;
  course.id = "small";
  course.title = "Small";
  course.script = "moon";
  course.sizes = {0.040, 0.016, 0.006};
  course.mastery.sure_sizes = 3;
  Lesson lesson;
  lesson.id = "01-lo";
  lesson.title = "L and O";
  lesson.script = "moon";
  lesson.items = {"l", "o"};
  for (const StepKind kind : {StepKind::kDemonstrate, StepKind::kTrace, StepKind::kRecognise}) {
    Step step;
    step.kind = kind;
    lesson.steps.push_back(step);
  }
  course.lessons.push_back(lesson);
  return course;
}

CourseRunSetup SetupFor(const Course& course) {
  CourseRunSetup setup;
  setup.course = &course;
  setup.learner = ShippedLearner();
  return setup;
}

TEST(CourseRun, IsDoneFromNothingThroughAllSizes) {
  const Course course = SmallCourse();
  CourseRunSetup setup = SetupFor(course);
  std::vector<Trial> trials;
  setup.keep = [&trials](const Trial& trial) { trials.push_back(trial); };
  const CourseRunResult result = RunCourse(setup);
  EXPECT_TRUE(result.done);
  EXPECT_EQ(result.trials, trials.size());
  std::set<double> sizes;
  for (const Trial& trial : trials) {
    EXPECT_TRUE(trial.simulated);
    if (trial.kind == StepKind::kRecognise && !trial.item.empty()) sizes.insert(trial.size);
  }
  EXPECT_EQ(sizes, std::set<double>(course.sizes.begin(), course.sizes.end()));
  for (const auto& item : result.progress.items) EXPECT_TRUE(item.second.mastered) << item.first;
}

TEST(CourseRun, OneThatIsGoodOnlyWhenGuidedNeverPasses) {
  const Course course = SmallCourse();
  CourseRunSetup setup = SetupFor(course);
  setup.learner.tracing.dependence = 1;
  setup.step_limit = 100;
  int guided = 0, guided_well = 0, alone = 0, alone_well = 0;
  setup.keep = [&](const Trial& trial) {
    if (trial.kind != StepKind::kTrace || trial.item.empty()) return;
    const bool well = trial.coverage >= 0.9;
    (trial.guided() ? guided : alone) += 1;
    (trial.guided() ? guided_well : alone_well) += well ? 1 : 0;
  };
  const CourseRunResult result = RunCourse(setup);
  EXPECT_FALSE(result.done);
  EXPECT_TRUE(result.stuck);
  for (const auto& item : result.progress.items) EXPECT_FALSE(item.second.mastered) << item.first;
  std::printf("guided %d of %d well, alone %d of %d\n", guided_well, guided, alone_well, alone);
  EXPECT_GT(guided_well * 2, guided);
  EXPECT_LT(alone_well * 2, alone);
}

TEST(CourseRun, TheSameSeedGivesTheSameTrials) {
  const Course course = SmallCourse();
  std::vector<std::vector<double>> errors(2);
  for (std::vector<double>& run : errors) {
    CourseRunSetup setup = SetupFor(course);
    setup.days = 1;
    setup.keep = [&run](const Trial& trial) { run.push_back(trial.mean_error); };
    RunCourse(setup);
  }
  EXPECT_FALSE(errors[0].empty());
  EXPECT_EQ(errors[0], errors[1]);
}

TEST(CourseRun, EndsAfterTheDaysAndGoesOnFromItsRecords) {
  const Course course = SmallCourse();
  CourseRunSetup setup = SetupFor(course);
  setup.days = 1;
  std::vector<Trial> trials;
  setup.keep = [&trials](const Trial& trial) { trials.push_back(trial); };
  const CourseRunResult first = RunCourse(setup);
  EXPECT_EQ(first.days, 1);
  setup.history = trials;
  setup.days = 0;
  EXPECT_TRUE(RunCourse(setup).done);
}

/// The course's own lessons from the first to `last`.
Course MoonTo(const std::string& last) {
  Course course = LoadCourse("learn-moon");
  const auto end = std::find_if(course.lessons.begin(), course.lessons.end(),
                                [&last](const Lesson& lesson) { return lesson.id == last; });
  course.lessons.erase(std::next(end), course.lessons.end());
  return course;
}

// What the first hour is to be: hand time is what the simulated learner needed, with the seconds to
// listen and to answer.
TEST(SlowCourseRun, NamesALetterInTenMinutesAndReadsAWordOnTheFirstDay) {
  const Course course = MoonTo("03-n-a");
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    CourseRunSetup setup = SetupFor(course);
    setup.seed = seed;
    std::int64_t letter = 0, word = 0;
    setup.keep = [&](const Trial& trial) {
      if (trial.kind != StepKind::kRecognise || !trial.right || trial.guided()) return;
      const bool named = trial.item.find('\n') == std::string::npos;  // not one of two
      if (letter == 0 && named) letter = trial.time - setup.begin;
      if (word == 0 && trial.item == "it") word = trial.time - setup.begin;
    };
    const CourseRunResult result = RunCourse(setup);
    std::printf(
        "seed %d: a letter after %.1f minutes, a word after %.1f, three lessons in %d days\n",
        static_cast<int>(seed), static_cast<double>(letter) / 60, static_cast<double>(word) / 60,
        result.days);
    EXPECT_TRUE(result.done);
    EXPECT_GT(letter, 0);
    EXPECT_LE(letter, 600) << seed;
    EXPECT_GT(word, 0);
    EXPECT_LT(word, 6 * 3600) << "on the first day, seed " << seed;
  }
}

/// Goes on from `trials` for a day, as a program that was started anew, and adds to them.
CourseRunResult AnotherDay(const Course& course, std::uint64_t seed, std::vector<Trial>& trials) {
  CourseRunSetup setup = SetupFor(course);
  setup.seed = seed;
  setup.days = 1;
  setup.history = trials;
  setup.keep = [&trials](const Trial& trial) { trials.push_back(trial); };
  return RunCourse(setup);
}

// It was stuck at once, for ever, with any seed: it remembered nothing, and was asked what it felt.
TEST(CourseRun, RemembersFromItsRecordsWhatItHadFelt) {
  const Course course = MoonTo("02-l-o");
  std::vector<Trial> trials;
  AnotherDay(course, 1, trials);
  const std::size_t first = trials.size();
  // a run of another seed is another hand, with the same past
  const CourseRunResult second = AnotherDay(course, 2, trials);
  EXPECT_FALSE(second.stuck);
  EXPECT_GT(trials.size(), first + 20);
}

TEST(SlowCourseRun, StartedAnewEachDayIsDoneAsSoonAsInOneRun) {
  const Course course = MoonTo("02-l-o");
  CourseRunSetup whole = SetupFor(course);
  const int days = RunCourse(whole).days;
  for (std::uint64_t seed = 1; seed <= 7; ++seed) {
    std::vector<Trial> trials;
    CourseRunResult result;
    int needed = 0;
    while (!result.done && !result.stuck && needed < 100) {
      result = AnotherDay(course, seed, trials);
      ++needed;
    }
    EXPECT_TRUE(result.done) << "seed " << seed;
    std::printf("seed %d: %d days, in one run %d\n", static_cast<int>(seed), needed, days);
    EXPECT_LE(needed, 2 * days) << "seed " << seed;  // another hand is not just as quick
  }
}

// From the device to the first letters and words; all of the course takes minutes, and is run where
// MOONTRACE_WHOLE_COURSE is set.
TEST(SlowCourseRun, LearnsMoonFromTheDeviceToAStory) {
  const bool whole = std::getenv("MOONTRACE_WHOLE_COURSE") != nullptr;
  const Course course = whole ? LoadCourse("learn-moon") : MoonTo("02-l-o");
  CourseRunSetup setup = SetupFor(course);
  std::set<double> sizes;
  setup.keep = [&sizes](const Trial& trial) {
    if (trial.right && !trial.guided() && !trial.item.empty()) sizes.insert(trial.size);
  };
  const CourseRunResult result = RunCourse(setup);
  std::printf("%d days, %zu trials, %.0f s of work, at %s\n", result.days, result.trials,
              result.seconds, result.progress.lesson.c_str());
  EXPECT_TRUE(result.done);
  const std::size_t reached = whole ? course.sizes.size() : 2;
  for (std::size_t i = 0; i < reached; ++i) EXPECT_EQ(sizes.count(course.sizes[i]), 1U) << i;
  for (const char* letter : {"i", "t", "l", "o"}) {
    EXPECT_GE(result.progress.items.at(letter).size_step, whole ? 4U : 2U) << letter;
  }
}

}  // namespace
}  // namespace moontrace
