#include "lessons/progress/mastery.h"

#include <gtest/gtest.h>

#include <limits>

#include "lessons/progress/learning.h"
#include "lessons/progress/progress.h"
#include "tests/lessons/lesson_fixture.h"

namespace moontrace {
namespace {

/// One item with the evidence of a scripted history. Rule: 4 of 5 names right, at the first size 2
/// traces of mean coverage 0.9 and error 0.5 widths; sizes 40, 20 and 10 mm.
class History {
 public:
  ItemProgress& item() { return progress_.items["i"]; }
  History& Named(bool right, double size = 0.040) {
    Trial trial = At(StepKind::kRecognise, size);
    trial.right = right;
    trial.latency = 8;
    return Add(trial);
  }
  History& Names(int count, double size = 0.040) {
    for (int i = 0; i < count; ++i) Named(true, size);
    return *this;
  }
  History& Traced(double coverage = 1, double error = 0, double size = 0.040) {
    Trial trial = At(StepKind::kTrace, size);
    trial.coverage = coverage;
    trial.error_widths = error;
    return Add(trial);
  }
  History& Guided(StepKind kind) {
    Trial trial = At(kind, 0.040);
    trial.coverage = 1;
    trial.right = true;
    trial.help = 3;
    trial.guidance = GuidanceMode::kAttract;
    return Add(trial);
  }
  History& Scaled(StepKind kind) {
    Trial trial = At(kind, 0.040);
    trial.coverage = 1;
    trial.right = trial.scaled = true;
    return Add(trial);
  }

 private:
  static Trial At(StepKind kind, double size) {
    Trial trial;
    trial.lesson = "01";
    trial.step = kind == StepKind::kTrace ? 1 : 2;
    trial.kind = kind;
    trial.item = "i";
    trial.size = size;
    return trial;
  }
  History& Add(const Trial& trial) {
    progress_ = Learn(course_, progress_, trial);
    return *this;
  }
  Course course_ = SmallCourse();
  Progress progress_;
};

TEST(Mastery, ComesWithExactlyTheFifthNameOnceTracedTwice) {
  History history;
  history.Traced().Traced().Names(4);
  EXPECT_EQ(history.item().size_step, 0u);
  EXPECT_FALSE(history.item().sure);
  history.Names(1);
  EXPECT_EQ(history.item().size_step, 1u) << "sure at 40 mm: it is worked on at 20";
  EXPECT_TRUE(history.item().named.empty()) << "evidence of the new size begins anew";
}

TEST(Mastery, ComesWithTheSecondTraceOnceNamed) {
  History history;
  history.Names(9).Traced();
  EXPECT_EQ(history.item().size_step, 0u);
  history.Traced();
  EXPECT_EQ(history.item().size_step, 1u);
}

TEST(Mastery, GoesDownToStandardSizeAndIsKeptThere) {
  History history;
  for (const double size : {0.040, 0.020, 0.010}) {
    EXPECT_FALSE(history.item().mastered);
    history.Traced(1, 0, size).Traced(1, 0, size).Names(5, size);
  }
  EXPECT_TRUE(history.item().sure);
  EXPECT_TRUE(history.item().mastered);
  EXPECT_EQ(history.item().size_step, 2u);
}

TEST(Mastery, NeverComesByGuidedOrScaledTrials) {
  History history;
  for (int i = 0; i < 50; ++i) {
    history.Guided(StepKind::kTrace).Guided(StepKind::kRecognise);
    history.Scaled(StepKind::kTrace).Scaled(StepKind::kRecognise);
  }
  EXPECT_EQ(history.item().size_step, 0u);
  EXPECT_TRUE(history.item().named.empty());
  EXPECT_TRUE(history.item().coverages.empty());
  EXPECT_EQ(history.item().stability, 0) << "a guided answer is no review";
}

TEST(Mastery, NeverComesByTrialsOfAnotherSize) {
  History history;
  history.Traced(1, 0, 0.050).Traced(1, 0, 0.050).Names(5, 0.020);
  EXPECT_TRUE(history.item().named.empty());
  EXPECT_EQ(history.item().size_step, 0u);
}

TEST(Mastery, WantsFourOfTheLastFiveNamesRight) {
  History one, two;
  one.Traced().Traced().Names(3).Named(false);
  EXPECT_EQ(one.item().size_step, 0u) << "only four names";
  one.Names(1);
  EXPECT_EQ(one.item().size_step, 1u);
  two.Traced().Traced().Names(1).Named(false).Names(1).Named(false).Names(2);
  EXPECT_EQ(two.item().size_step, 0u) << "of the last five two were wrong";
  two.Names(1);
  EXPECT_EQ(two.item().size_step, 1u) << "now one";
}

TEST(Mastery, WantsTracesAtTheFirstSizeOnly) {
  History history;
  history.Traced().Traced().Names(5);
  ASSERT_EQ(history.item().size_step, 1u);
  history.Traced(0.2, 3, 0.020).Traced(0.2, 3, 0.020).Traced(0.2, 3, 0.020);
  EXPECT_EQ(history.item().failures, 0) << "a groove leads the hand there, well or badly";
  history.Names(5, 0.020);
  EXPECT_EQ(history.item().size_step, 2u);
}

TEST(Mastery, AWordThatIsNamedRightIsEvidenceOfItsLetters) {
  const Course course = SmallCourse();
  Progress progress;
  for (const char* letter : {"l", "i", "t", "o"}) {
    progress.items[letter].introduced = true;
    progress.items[letter].size_step = 1;
  }
  progress.items["o"].size_step = 2;
  Trial word;
  word.lesson = "02";
  word.step = 3;
  word.kind = StepKind::kRecognise;
  word.item = "lit";
  word.size = 0.020;
  word.right = true;
  for (int i = 0; i < 4; ++i) progress = Learn(course, progress, word);
  EXPECT_EQ(progress.items["l"].named.size(), 4u);
  EXPECT_TRUE(progress.items["o"].named.empty()) << "not in the word";
  word.right = false;
  progress = Learn(course, progress, word);
  EXPECT_EQ(progress.items["l"].named.size(), 4u) << "nobody knows which letter was wrong";
  word.right = true;
  progress = Learn(course, progress, word);
  for (const char* letter : {"l", "i", "t"}) EXPECT_EQ(progress.items[letter].size_step, 2u);
}

TEST(Mastery, TheLongestKnownSignsMakeAWord) {
  Progress progress;
  for (const char* item : {"t", "h", "e", "n", "the", "then"}) progress.items[item];
  EXPECT_EQ(PartsOf(Course{}, progress, "then"), (std::vector<std::string>{"the", "n"}));
  EXPECT_EQ(PartsOf(Course{}, progress, "Tent"), (std::vector<std::string>{"t", "e", "n"}));
  EXPECT_EQ(PartsOf(Course{}, progress, "box"), std::vector<std::string>{});
}

TEST(Mastery, WantsMeanCoverageAndErrorOfTheTraces) {
  History thin, far, mixed;
  thin.Names(5).Traced(0.89).Traced(0.9);
  EXPECT_EQ(thin.item().size_step, 0u);
  far.Names(5).Traced(1, 0.5).Traced(1, 0.51);
  EXPECT_EQ(far.item().size_step, 0u);
  mixed.Names(5).Traced(0.85, 0.8).Traced(0.96, 0.2);
  EXPECT_EQ(mixed.item().size_step, 1u) << "means 0.905 and 0.5 are within the rule";
}

TEST(Mastery, GoesBackASizeAfterThreeFailuresInARow) {
  History history;
  history.Traced().Traced().Names(5);
  ASSERT_EQ(history.item().size_step, 1u);
  history.Named(false, 0.020).Named(false, 0.020).Named(true, 0.020);
  EXPECT_EQ(history.item().failures, 0) << "a good one begins the count anew";
  history.Named(false, 0.020).Named(false, 0.020);
  EXPECT_EQ(history.item().size_step, 1u);
  history.Named(false, 0.020);
  EXPECT_EQ(history.item().size_step, 0u);
  history.Names(5);
  EXPECT_EQ(history.item().size_step, 0u) << "traces at the larger size are asked anew";
}

TEST(Mastery, AtTheLargestSizeFailuresBringTheIntroductionBack) {
  History history;
  history.Guided(StepKind::kTrace);
  history.item().help = 1;
  ASSERT_TRUE(history.item().introduced);
  for (int i = 0; i < 3; ++i) history.Named(false);
  EXPECT_FALSE(history.item().introduced);
  EXPECT_EQ(history.item().help, 6) << "and the help of the beginning";
}

TEST(Mastery, ANumberThatIsNoneIsABadTrace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  History history;
  history.Names(5).Traced(nan, 0).Traced(1, nan).Traced(1, -1);
  EXPECT_EQ(history.item().size_step, 0u);
  // Three bad ones in a row: as it was in the beginning.
  EXPECT_TRUE(history.item().coverages.empty());
}

TEST(Mastery, AsksOnlyForWhatTheCoursePractises) {
  Course course = SmallCourse();
  course.lessons = {MakeLesson("lines", {"-"}, {MakeStep(StepKind::kTrace)}),
                    MakeLesson("words", {"cat"}, {MakeStep(StepKind::kRecognise)})};
  Trial trace, name;
  trace.lesson = "lines";
  trace.item = "-";
  trace.size = name.size = 0.040;
  trace.coverage = 1;
  name.lesson = "words";
  name.kind = StepKind::kRecognise;
  name.item = "cat";
  name.right = true;
  Progress progress;
  for (int i = 0; i < 2; ++i) progress = Learn(course, progress, trace);
  EXPECT_EQ(progress.items["-"].size_step, 1u) << "never named in this course";
  for (int i = 0; i < 5; ++i) progress = Learn(course, progress, name);
  EXPECT_EQ(progress.items["cat"].size_step, 1u) << "never traced in this course";
}

TEST(Mastery, AWordBeginsAtTheSizeOfItsWeakestLetter) {
  const Course course = SmallCourse();
  Progress progress;
  EXPECT_EQ(FirstSizeOf(course, progress, "lit"), 0u) << "no letter of it is known";
  progress.items["l"].size_step = 2;
  progress.items["i"].size_step = 1;
  progress.items["t"].size_step = 2;
  EXPECT_EQ(FirstSizeOf(course, progress, "lit"), 1u);
  EXPECT_EQ(FirstSizeOf(course, progress, "Till"), 1u);
  EXPECT_EQ(FirstSizeOf(course, progress, "o"), 0u) << "taught: from the largest";
}

}  // namespace
}  // namespace moontrace
