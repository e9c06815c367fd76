// The shipped course, gone through by scripted learners.

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "lessons/course/lesson_items.h"
#include "tests/lessons/lesson_fixture.h"

namespace moontrace {
namespace {

using lesson_action::Await;

/// Gone through by a learner who is right so often, resting a day after each 200 events.
LessonRun GoThrough(double right, unsigned seed, int most, int* events) {
  LessonRun run(LoadCourse("learn-moon"), {}, seed);
  std::mt19937 random(seed);
  run.Begin();
  for (*events = 0; *events < most && run.state.await != Await::kEnd; ++*events) {
    run.Work(static_cast<double>(random()) < right * 4294967296.0);
    if (*events % 200 != 199 || run.state.await == Await::kEnd) continue;
    run.time += 86400;
    run.Begin();
  }
  return run;
}

TEST(LearnMoon, WhoIsNeverWrongFinishesItWithinTheTrialsThatTheReadmeNames) {
  int events = 0;
  const LessonRun run = GoThrough(1, 1, 20000, &events);
  EXPECT_EQ(run.state.await, Await::kEnd) << "at " << run.state.progress.lesson;
  EXPECT_EQ(run.state.progress.done.size(), run.course.lessons.size());
  // lessons/README.md: about 3700.
  EXPECT_NEAR(events, 3700, 400);
  std::set<std::string> letters;
  for (char c = 'a'; c <= 'z'; ++c) letters.insert(std::string(1, c));
  std::map<std::string, std::set<double>> sizes;
  for (const Trial& trial : run.kept) {
    if (trial.kind == StepKind::kRecognise && trial.right) sizes[trial.item].insert(trial.size);
  }
  for (const std::string& letter : letters) {
    EXPECT_TRUE(run.state.progress.items.at(letter).mastered) << letter;
    for (const double size : run.course.sizes)
      EXPECT_EQ(sizes[letter].count(size), 1u) << letter << size;
  }
}

TEST(SlowLearnMoon, WhoIsOftenWrongFinishesItToo) {
  for (const double right : {0.9, 0.8}) {
    int events = 0;
    const LessonRun run = GoThrough(right, 1, 60000, &events);
    EXPECT_EQ(run.state.await, Await::kEnd) << right << " at " << run.state.progress.lesson;
    EXPECT_LT(events, right > 0.85 ? 7000 : 15000) << right;
  }
}

TEST(LearnMoon, WhoOnlyGuessesGetsNowhere) {
  LessonRun run(LoadCourse("learn-moon"), {}, 1);
  std::mt19937 random(1);
  std::vector<std::string> lines = {"level", "upright", "rising", "falling"};
  run.Begin();
  // Traces well, so that the names alone hold it up: four lines, five of five right, each.
  for (int i = 0; i < 3000; ++i) {
    const bool named = run.state.await == Await::kAnswer;
    if (named) {
      run.Answer(lines[random() % 4]);
    } else {
      run.Work();
    }
  }
  EXPECT_EQ(run.state.progress.lesson, "01-lines");
}

}  // namespace
}  // namespace moontrace
