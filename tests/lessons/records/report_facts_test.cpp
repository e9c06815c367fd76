#include "lessons/records/report_facts.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

constexpr std::int64_t kDay = 86'400;
constexpr std::int64_t kNoon = 1'700'000'000 / kDay * kDay + kDay / 2;  // of 2023-11-14, UTC

/// Two letters that take each other's place, at two sizes.
Course SmallCourse() {
  Course course;
  course.id = "small";
  course.title = "Small";
  course.sizes = {0.02, 0.01};
  Lesson lesson;
  lesson.id = "1";
  lesson.items = {"b", "j"};
  Step trace;
  trace.kind = StepKind::kTrace;
  Step name;
  name.kind = StepKind::kRecognise;
  lesson.steps = {trace, name};
  course.lessons = {lesson};
  return course;
}

Trial Named(const std::string& item, const std::string& answer, std::int64_t time = kNoon) {
  Trial trial;
  trial.time = time;
  trial.lesson = "1";
  trial.step = 1;
  trial.kind = StepKind::kRecognise;
  trial.item = item;
  trial.size = 0.02;
  trial.answer = answer;
  trial.right = item == answer;
  trial.latency = 4;
  return trial;
}

Trial Traced(const std::string& item, double coverage, bool guided) {
  Trial trial;
  trial.time = kNoon;
  trial.lesson = "1";
  trial.kind = StepKind::kTrace;
  trial.item = item;
  trial.size = 0.02;
  trial.coverage = coverage;
  trial.error_widths = 0.25;
  trial.duration = 8;
  trial.right = coverage >= 0.9;
  if (guided) {
    trial.guidance = GuidanceMode::kAttract;
    trial.help = 6;
  }
  return trial;
}

class ReportFactsTest : public testing::Test {
 protected:
  ReportFactsTest() {
    setenv("TZ", "UTC", 1);
    tzset();
  }
};

TEST_F(ReportFactsTest, TellGuidedFromUnguidedTrials) {
  const ReportFacts facts =
      FactsOf(SmallCourse(), {Traced("b", 1.0, true), Traced("b", 0.5, false),
                              Traced("b", 0.9, false), Traced("b", 0.8, true)});
  EXPECT_EQ(facts.alone.trials, 2U);
  EXPECT_EQ(facts.guided.trials, 2U);
  EXPECT_DOUBLE_EQ(facts.alone.MeanCoverage(), 0.7);
  EXPECT_DOUBLE_EQ(facts.guided.MeanCoverage(), 0.9);
  EXPECT_EQ(facts.alone.good, 1U);
  EXPECT_DOUBLE_EQ(facts.alone.TracedPerSecond(), 2.0 / 16);
}

TEST_F(ReportFactsTest, CountLettersOfWhatWasNamedRight) {
  Trial word = Named("the cat", "the cat");
  word.latency = 8;
  Trial unknown_time = Named("b", "b");
  unknown_time.latency = 0;
  const ReportFacts facts =
      FactsOf(SmallCourse(), {Named("b", "b"), Named("b", "j"), word, unknown_time});
  EXPECT_EQ(facts.alone.answers, 4U);
  EXPECT_EQ(facts.alone.right, 3U);
  // b in 4 s and six letters in 8 s; wrong answers and unknown times tell no speed
  EXPECT_DOUBLE_EQ(facts.alone.LettersPerSecond(), 7.0 / 12);
}

TEST_F(ReportFactsTest, GiveConfusionsInWordsAndAllAnswers) {
  const ReportFacts facts = FactsOf(
      SmallCourse(),
      {Named("b", "b"), Named("b", "j"), Named("b", "j"), Named("j", "b"), Named("j", "no idea")});
  ASSERT_EQ(facts.confusions.size(), 2U);
  EXPECT_EQ(facts.confusions[0].shown, "b");
  EXPECT_EQ(facts.confusions[0].said, "j");
  EXPECT_EQ(facts.confusions[0].times, 2);
  EXPECT_EQ(facts.matrix.at("b").at("b"), 1);
  EXPECT_EQ(facts.matrix.at("b").at("j"), 2);
  EXPECT_EQ(facts.matrix.at("j").at("no idea"), 1);
}

TEST_F(ReportFactsTest, CountNothingOfMarksAndScaledTrials) {
  Trial mark = Named("", "");
  Trial scaled = Named("b", "b");
  scaled.scaled = true;
  const ReportFacts facts = FactsOf(SmallCourse(), {mark, scaled});
  EXPECT_EQ(facts.alone.trials + facts.guided.trials, 0U);
  EXPECT_EQ(facts.scaled, 1U);
  EXPECT_TRUE(facts.days.empty());
}

TEST_F(ReportFactsTest, PutTrialsIntoTheirDays) {
  Trial small = Named("b", "b", kNoon + kDay);
  small.size = 0.01;
  const ReportFacts facts = FactsOf(SmallCourse(), {Named("b", "b"), Named("b", "j"), small});
  ASSERT_EQ(facts.days.size(), 2U);
  EXPECT_EQ(facts.days[0].day, "2023-11-14");
  EXPECT_DOUBLE_EQ(facts.days[0].alone.NamedRight(), 0.5);
  EXPECT_EQ(facts.days[0].smallest, 0.02);
  EXPECT_EQ(facts.days[1].day, "2023-11-15");
  EXPECT_EQ(facts.days[1].smallest, 0.01);
}

TEST_F(ReportFactsTest, SendTheWeakestToPractice) {
  std::vector<Trial> trials;
  for (int i = 0; i < 8; ++i) trials.push_back(Named("j", "j"));
  for (int i = 0; i < 6; ++i) trials.push_back(Named("b", i % 2 == 0 ? "b" : "j"));
  const ReportFacts facts = FactsOf(SmallCourse(), trials);
  ASSERT_EQ(facts.practise.size(), 1U);
  EXPECT_EQ(facts.practise[0].item, "b");
  EXPECT_EQ(facts.practise[0].answers, 6U);
  EXPECT_EQ(facts.practise[0].right, 3U);
  EXPECT_EQ(facts.practise[0].taken_for, "j");
  EXPECT_EQ(facts.practise[0].taken, 3);
}

TEST_F(ReportFactsTest, CallSureWhatTheCourseCallsSure) {
  const Course course = SmallCourse();
  std::vector<Trial> trials;
  for (int i = 0; i < 20; ++i) trials.push_back(Traced("b", 1, false));
  EXPECT_TRUE(FactsOf(course, trials).sure.empty());  // never named
  for (int i = 0; i < course.mastery.attempts; ++i) trials.push_back(Named("b", "b"));
  const ReportFacts facts = FactsOf(course, trials);
  ASSERT_EQ(facts.sure.size(), 1U);
  EXPECT_EQ(facts.sure[0].item, "b");
  EXPECT_EQ(facts.sure[0].size, 0.02);
  EXPECT_EQ(facts.size_reached, 0.02);
  EXPECT_EQ(facts.mastered, 0U);
  EXPECT_EQ(facts.items, 2U);
}

TEST_F(ReportFactsTest, CountADayOnceThoughTheClockWasSetBack) {
  const ReportFacts facts = FactsOf(SmallCourse(), {Named("b", "b", kNoon + kDay), Named("b", "b"),
                                                    Named("j", "j", kNoon + kDay)});
  ASSERT_EQ(facts.days.size(), 2U);
  EXPECT_EQ(facts.days[0].day, "2023-11-15");
  EXPECT_EQ(facts.days[0].alone.answers, 2U);
  EXPECT_EQ(facts.days[1].alone.answers, 1U);
}

}  // namespace
}  // namespace moontrace
