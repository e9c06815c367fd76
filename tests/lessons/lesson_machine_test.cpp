#include "lessons/lesson_machine.h"

#include <gtest/gtest.h>

#include "lesson_fixture.h"

namespace moontrace {
namespace {

using lesson_action::Await;
using lesson_action::Sentence;

TEST(LessonMachine, APerfectLearnerFinishesTheCourse) {
  LessonRun run(SmallCourse());
  run.Begin();
  int events = 0;
  while (run.state.await != Await::kEnd && events < 2000) {
    run.Work();
    ++events;
  }
  ASSERT_EQ(run.state.await, Await::kEnd) << "after " << events << " events";
  EXPECT_EQ(run.state.progress.done, (std::vector<std::string>{"01", "02"}));
  EXPECT_TRUE(run.Said(Sentence::kCourseDone));
  // Three and two letters, each led along once and traced eight times (two probes, one in four),
  // then named 5 times and at two more sizes traced twice and named 5 times: 28 x 5; a page to
  // explore, one to read, a test of 3, a word named 5 times: 150 in all. The rest, questions about
  // known ones, is a quarter of about 85 namings and what keeps one from coming twice.
  EXPECT_GE(events, 150);
  EXPECT_LT(events, 220);
}

}  // namespace
}  // namespace moontrace
