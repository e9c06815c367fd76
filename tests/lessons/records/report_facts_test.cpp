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
  course.script = "moon";
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
  EXPECT_EQ(facts.alone.answers(), 4U);
  EXPECT_EQ(facts.alone.right(), 3U);
  EXPECT_EQ(facts.alone.words.answers, 1U);  // "the cat" is no sign of a lesson
  // b in 4 s and six letters in 8 s; wrong answers and unknown times tell no speed
  EXPECT_DOUBLE_EQ(facts.alone.LettersPerSecond(), 7.0 / 12);
}

TEST_F(ReportFactsTest, GiveConfusionsInWordsAndAllAnswers) {
  const ReportFacts facts = FactsOf(
      SmallCourse(),
      {Named("b", "b"), Named("b", "j"), Named("b", "j"), Named("j", "b"), Named("j", "no idea")});
  ASSERT_EQ(facts.confusions.size(), 1U);
  EXPECT_EQ(facts.confusions[0].shown, "b");
  EXPECT_EQ(facts.confusions[0].said, "j");
  EXPECT_EQ(facts.confusions[0].times, 2);
  EXPECT_EQ(facts.confusions[0].back, 1);
  EXPECT_EQ(facts.confusions[0].likeness, Likeness::kMirrored);
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
  EXPECT_DOUBLE_EQ(facts.days[0].alone.signs.Share(), 0.5);
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
  EXPECT_EQ(FactsOf(course, trials).met.at(0).size, 0);  // never named
  for (int i = 0; i < course.mastery.attempts; ++i) trials.push_back(Named("b", "b"));
  const ReportFacts facts = FactsOf(course, trials);
  ASSERT_EQ(facts.met.size(), 1U);
  EXPECT_EQ(facts.met[0].item, "b");
  EXPECT_EQ(facts.met[0].size, 0.02);
  EXPECT_EQ(facts.met[0].present, 0.01);
  EXPECT_EQ(facts.met[0].last, kNoon);
  EXPECT_EQ(facts.unmet, std::vector<std::string>{"j"});
  EXPECT_EQ(facts.size_reached, 0.02);
  EXPECT_EQ(facts.mastered, 0U);
  EXPECT_EQ(facts.items, 2U);
}

TEST_F(ReportFactsTest, CountADayOnceThoughTheClockWasSetBack) {
  const ReportFacts facts = FactsOf(SmallCourse(), {Named("b", "b", kNoon + kDay), Named("b", "b"),
                                                    Named("j", "j", kNoon + kDay)});
  ASSERT_EQ(facts.days.size(), 2U);
  EXPECT_EQ(facts.days[0].day, "2023-11-15");
  EXPECT_EQ(facts.days[0].alone.signs.answers, 2U);
  EXPECT_EQ(facts.days[1].alone.signs.answers, 1U);
}

// Before, every word that was sure at the smallest size and every shape of the lesson beside the
// course counted too: 58 of 52 signs.
TEST_F(ReportFactsTest, NeverHaveMoreSignsMasteredThanThereAre) {
  Course course = SmallCourse();
  course.sizes = {0.02};
  course.lessons[0].steps[1].items = {"b", "j", "bj"};
  Lesson beside = course.lessons[0];
  beside.id = "hands";
  beside.items = {"o"};
  beside.optional = true;
  beside.steps[1].items = {};
  course.lessons.push_back(beside);
  std::vector<Trial> trials;
  for (const char* item : {"b", "j", "bj", "o"}) {
    for (int i = 0; i < 4; ++i) trials.push_back(Traced(item, 1, false));
    for (int i = 0; i < 6; ++i) trials.push_back(Named(item, item));
  }
  const ReportFacts facts = FactsOf(course, trials);
  EXPECT_EQ(facts.met.size(), 4U);
  for (const ItemFact& fact : facts.met) EXPECT_TRUE(fact.mastered) << fact.item;
  EXPECT_EQ(facts.items, 2U);
  EXPECT_EQ(facts.mastered, 2U);
}

TEST_F(ReportFactsTest, CountEachKindOfQuestionByItself) {
  Course course = SmallCourse();
  Step pick = course.lessons[0].steps[1];
  pick.question = Question::kPick;
  Step same = pick;
  same.question = Question::kSame;
  course.lessons[0].steps.push_back(pick);
  course.lessons[0].steps.push_back(same);
  Trial picked = Named("b\nj", "j");
  picked.step = 2;
  Trial compared = Named("b\nj", "different");
  compared.step = 3;
  compared.right = true;
  Trial held_same = compared;
  held_same.answer = "same";
  held_same.right = false;
  const ReportFacts facts =
      FactsOf(course, {Named("b", "b"), Named("bj", "j"), picked, compared, held_same});
  EXPECT_EQ(facts.alone.signs.answers, 1U);
  EXPECT_EQ(facts.alone.words.answers, 1U);
  EXPECT_EQ(facts.alone.words.right, 0U);
  EXPECT_EQ(facts.alone.picked.answers, 1U);
  EXPECT_EQ(facts.alone.picked.right, 0U);
  EXPECT_EQ(facts.alone.compared.answers, 2U);
  EXPECT_EQ(facts.alone.compared.right, 1U);
  ASSERT_EQ(facts.confusions.size(), 1U);
  EXPECT_EQ(facts.confusions[0].all(), 2);  // picked for it, and held to be the same
  EXPECT_EQ(facts.matrix.size(), 1U);       // of single signs that were named
}

TEST_F(ReportFactsTest, PutDaysIntoWeeksThatBeginOnMonday) {
  // 2023-11-14 was a Tuesday, so six days later it is Monday the 20th.
  EXPECT_EQ(WeekOf(kNoon), "2023-11-13");
  EXPECT_EQ(WeekOf(kNoon - kDay), "2023-11-13");
  EXPECT_EQ(WeekOf(kNoon + 5 * kDay), "2023-11-13");
  EXPECT_EQ(WeekOf(kNoon + 6 * kDay), "2023-11-20");
  EXPECT_EQ(WeekOf(1'704'100'000), "2024-01-01");  // a Monday
  const ReportFacts facts = FactsOf(SmallCourse(), {Named("b", "b"), Named("b", "b", kNoon + kDay),
                                                    Named("b", "j", kNoon + 6 * kDay)});
  ASSERT_EQ(facts.weeks.size(), 2U);
  EXPECT_EQ(facts.weeks[0].alone.signs.answers, 2U);
  EXPECT_EQ(facts.weeks[1].day, "2023-11-20");
}

}  // namespace
}  // namespace moontrace
