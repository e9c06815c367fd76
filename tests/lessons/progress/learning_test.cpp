#include "lessons/progress/learning.h"

#include <gtest/gtest.h>

#include "lessons/progress/lesson_path.h"
#include "tests/lessons/lesson_fixture.h"

namespace moontrace {
namespace {

constexpr std::int64_t kDay = 86400;

Trial Of(std::string lesson, std::size_t step, StepKind kind, std::string item) {
  Trial trial;
  trial.time = 1'700'000'000;
  trial.lesson = std::move(lesson);
  trial.step = step;
  trial.kind = kind;
  trial.item = std::move(item);
  trial.size = 0.040;
  trial.latency = 8;
  return trial;
}

Trial Mark(std::string lesson, std::size_t step, bool ended) {
  Trial mark = Of(std::move(lesson), step, StepKind::kExplore, "");
  mark.right = ended;
  return mark;
}

TEST(Progress, IsWhereTheLastTrialWas) {
  const Course course = SmallCourse();
  Progress progress = LearnAll(course, {Mark("01", 0, false)});
  EXPECT_EQ(progress.lesson, "01");
  EXPECT_EQ(progress.step, 0u);
  progress = Learn(course, progress, Of("01", 1, StepKind::kTrace, "i"));
  EXPECT_EQ(progress.step, 1u);
  EXPECT_EQ(progress.trials_in_step, 1u);
  progress = Learn(course, progress, Of("no such", 0, StepKind::kTrace, "i"));
  EXPECT_EQ(progress.lesson, "01") << "a lesson that the course has not is nowhere to be";
}

TEST(Progress, AStepsEndLeadsToTheNextStepAndLesson) {
  const Course course = SmallCourse();
  Progress progress = LearnAll(course, {Mark("02", 0, false), Mark("02", 3, false)});
  progress = Learn(course, progress, Mark("02", 4, true));
  EXPECT_EQ(progress.done, std::vector<std::string>{"02"});
  EXPECT_EQ(progress.lesson, "01") << "which is not done yet";
  progress = Learn(course, progress, Mark("01", 0, true));
  EXPECT_EQ(progress.step, 1u);
}

TEST(Progress, ALessonWhoseItemsWereLeftIsNotDone) {
  const Course course = SmallCourse();
  const Progress progress = LearnAll(
      course, {Mark("01", 0, true), Mark("01", 1, true), Mark("01", 2, true), Mark("01", 3, true)});
  EXPECT_TRUE(progress.done.empty());
  EXPECT_EQ(progress.lesson, "02") << "but it moves on";
}

TEST(Progress, CountsWhatIsTakenForWhat) {
  const Course course = SmallCourse();
  Trial wrong = Of("01", 2, StepKind::kRecognise, "i");
  wrong.answer = "t";
  Trial strange = wrong;
  strange.answer = "x";
  Trial right = wrong;
  right.answer = "i";
  right.right = true;
  Progress progress = LearnAll(course, {wrong, wrong, strange, right});
  EXPECT_EQ(progress.confusions.size(), 1u);
  EXPECT_EQ(progress.confusions["i"]["t"], 2);
  Trial same = Of("01", 2, StepKind::kRecognise, "l\no");
  same.answer = "same";
  progress = Learn(course, progress, same);
  EXPECT_EQ(progress.confusions["l"]["o"], 1) << "two that differ were held to be the same";
}

TEST(Progress, GuessesBetweenTwoAreNoEvidence) {
  const Course course = SmallCourse();
  Trial pick = Of("01", 2, StepKind::kRecognise, "i\nt");
  pick.answer = "i";
  pick.right = true;
  Progress progress;
  for (int i = 0; i < 20; ++i) progress = Learn(course, progress, pick);
  EXPECT_TRUE(progress.items["i"].named.empty());
  EXPECT_EQ(progress.items["i"].stability, 0);
}

// FSRS-6's first stabilities of Again, Hard, Good and Easy are its first four default parameters.
TEST(Progress, AFirstAnswerSetsTheStabilityOfItsRating) {
  const Course course = SmallCourse();
  const auto stability = [&](bool right, double latency) {
    Trial trial = Of("01", 2, StepKind::kRecognise, "i");
    trial.right = right;
    trial.latency = latency;
    return Learn(course, {}, trial).items.at("i").stability;
  };
  EXPECT_NEAR(stability(false, 1), 0.212, 1e-9);
  EXPECT_NEAR(stability(true, 31), 1.2931, 1e-9);
  EXPECT_NEAR(stability(true, 8), 2.3065, 1e-9);
  EXPECT_NEAR(stability(true, 4), 8.2956, 1e-9);
}

TEST(Progress, AReviewDaysLaterPutsTheNextOneOff) {
  const Course course = SmallCourse();
  Trial trial = Of("01", 2, StepKind::kRecognise, "i");
  trial.right = true;
  Progress progress = LearnAll(course, {trial, trial});
  // G G at once: 2 days (reference 1.6: intervals 0, 2, 11, 46 days).
  EXPECT_EQ(progress.items["i"].due, trial.time + 2 * kDay);
  trial.time += 2 * kDay;
  progress = Learn(course, progress, trial);
  EXPECT_EQ(progress.items["i"].due, trial.time + 11 * kDay);
  trial.time += 11 * kDay;
  progress = Learn(course, progress, trial);
  EXPECT_EQ(progress.items["i"].due, trial.time + 46 * kDay);
}

TEST(Progress, QuickAnswersOfOneDayDoNotPutAReviewOffByYears) {
  const Course course = SmallCourse();
  Trial trial = Of("01", 2, StepKind::kRecognise, "i");
  trial.right = true;
  trial.latency = 1;
  Progress progress;
  for (int i = 0; i < 30; ++i, trial.time += 20) progress = Learn(course, progress, trial);
  EXPECT_LT(progress.items["i"].due - trial.time, 30 * kDay);
}

TEST(Progress, HelpFadesWithGuidedTraces) {
  const Course course = SmallCourse();
  Trial trace = Of("01", 1, StepKind::kTrace, "i");
  trace.help = 6;
  trace.guidance = GuidanceMode::kAttract;
  trace.coverage = 1;
  Progress progress = Learn(course, {}, trace);
  EXPECT_EQ(progress.items["i"].help, 6);
  EXPECT_EQ(progress.items["i"].guided_run, 1);
  progress = Learn(course, progress, trace);
  EXPECT_EQ(progress.items["i"].help, 5) << "gate: one less after two good ones";
  trace.coverage = 0.1;
  progress = Learn(course, progress, trace);
  EXPECT_EQ(progress.items["i"].help, 6) << "one more after a bad one";
  trace.help = 0;
  progress = Learn(course, progress, trace);
  EXPECT_EQ(progress.items["i"].guided_run, 0);
}

TEST(Progress, ATestThatFailsComesAgainOnceWhatWasWrongIsSure) {
  const Course course = SmallCourse();
  Progress progress = LearnAll(course, {Mark("01", 3, false)});
  for (const char* item : {"i", "t", "l"}) {
    Trial trial = Of("01", 3, StepKind::kTest, item);
    trial.right = item[0] != 'l';
    progress = Learn(course, progress, trial);
  }
  EXPECT_FALSE(TestPassed(course, progress)) << "2 of 3 are 0.67";
  progress = Learn(course, progress, Mark("01", 3, true));
  EXPECT_EQ(progress.lesson, "01");
  EXPECT_EQ(progress.step, 3u);
  EXPECT_EQ(progress.practise, std::vector<std::string>{"l"});
  EXPECT_TRUE(progress.done.empty());
  ItemProgress& item = progress.items["l"];
  item.size_step = 2;
  item.coverages = {1, 1};
  item.errors = {0, 0};
  Trial name = Of("01", 3, StepKind::kRecognise, "l");
  name.right = true;
  name.size = 0.010;
  for (int i = 0; i < 3; ++i) progress = Learn(course, progress, name);
  EXPECT_EQ(progress.practise.size(), 1u) << "3 of 4, with the test's own";
  EXPECT_FALSE(TestPassed(course, progress));
  progress = Learn(course, progress, name);
  EXPECT_TRUE(progress.practise.empty());
  EXPECT_EQ(Unfinished(course, progress).size(), 3u) << "all are asked again";
}

TEST(LessonWay, LeavesOutWhatLiesBesideTheCourseAndComesBackFromIt) {
  Course course;
  for (const char* id : {"a", "hands", "b"}) {
    course.lessons.push_back(MakeLesson(id, {}, {MakeStep(StepKind::kExplore)}));
  }
  course.lessons[1].optional = true;
  Progress progress;
  EXPECT_EQ(LessonAfter(course, progress, "a"), 2u);
  EXPECT_EQ(LessonAfter(course, progress, "hands"), 2u);
  progress.done = {"hands", "b"};
  EXPECT_EQ(LessonAfter(course, progress, "hands"), 0u) << "to what was left";
  progress.done = {"a", "b"};
  EXPECT_TRUE(CourseDone(course, progress));
  EXPECT_EQ(LessonAfter(course, progress, "b"), std::nullopt);
}

TEST(Progress, AStepEndsWhenItsItemsAreSureAtItsSizesOrTheRulesOrAllThereAre) {
  Course course = SmallCourse();
  Progress progress;
  progress.lesson = "01";
  progress.step = 2;
  progress.here["i"].trials = 1;
  const auto finished = [&](std::size_t size_step) {
    progress.items["i"].size_step = size_step;
    return ItemFinished(course, progress, course.lessons[0].steps[2], "i");
  };
  EXPECT_FALSE(finished(1));
  EXPECT_TRUE(finished(2)) << "sure at 40 and 20 mm";
  course.lessons[0].steps[2].sure_sizes = 1;
  EXPECT_TRUE(finished(1));
  course.lessons[0].steps[2].sure_sizes = 5;
  EXPECT_FALSE(finished(2)) << "there are three";
  progress.items["i"].sure = true;
  EXPECT_TRUE(finished(2));
}

TEST(Progress, AWordIsFinishedByTwoRightAnswersInARow) {
  const Course course = SmallCourse();
  Progress progress;
  progress.lesson = "02";
  progress.step = 3;
  StepItem& here = progress.here["lit"];
  const auto finished = [&](const std::vector<bool>& named) {
    here.trials = static_cast<int>(named.size());
    here.named = named;
    return ItemFinished(course, progress, course.lessons[1].steps[3], "lit");
  };
  EXPECT_FALSE(finished({true}));
  EXPECT_FALSE(finished({true, false, true}));
  EXPECT_TRUE(finished({false, true, true}));
}

TEST(LessonWay, GoesOnInOrderNeedsFirstAndThenToWhatWasLeft) {
  Course course;
  for (const char* id : {"a", "b", "c", "d"}) {
    course.lessons.push_back(MakeLesson(id, {}, {MakeStep(StepKind::kExplore)}));
  }
  course.lessons[1].needs = {"a"};
  Progress progress;
  EXPECT_EQ(LessonAfter(course, progress, ""), 0u);
  EXPECT_EQ(LessonAfter(course, progress, "a"), 2u) << "b needs a, which was left";
  progress.done = {"a"};
  EXPECT_EQ(LessonAfter(course, progress, "a"), 1u);
  progress.done = {"c", "d"};
  EXPECT_EQ(LessonAfter(course, progress, "d"), 0u);
  progress.done = {"a", "b", "c", "d"};
  EXPECT_EQ(LessonAfter(course, progress, "d"), std::nullopt);
  EXPECT_TRUE(CourseDone(course, progress));
}

}  // namespace
}  // namespace moontrace
