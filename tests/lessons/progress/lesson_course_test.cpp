// The shipped course, gone through by scripted learners.

#include <gtest/gtest.h>

#include <cstdio>
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
  EXPECT_EQ(run.state.progress.done.size(), LessonsInOrder(run.course));
  // lessons/README.md: about 1900.
  EXPECT_NEAR(events, 1900, 200);
  std::set<std::string> letters;
  for (char c = 'a'; c <= 'z'; ++c) letters.insert(std::string(1, c));
  std::map<std::string, std::set<double>> sizes;
  for (const Trial& trial : run.kept) {
    if (trial.kind == StepKind::kRecognise && trial.right) sizes[trial.item].insert(trial.size);
  }
  for (const std::string& letter : letters) {
    EXPECT_TRUE(run.state.progress.items.at(letter).mastered) << letter;
    // the first two by itself, smaller ones perhaps in words alone
    for (const double size : {run.course.sizes[0], run.course.sizes[1]}) {
      EXPECT_EQ(sizes[letter].count(size), 1u) << letter << size;
    }
  }
}

TEST(SlowLearnMoon, WhoIsOftenWrongFinishesItToo) {
  for (const double right : {0.9, 0.8}) {
    int events = 0;
    const LessonRun run = GoThrough(right, 1, 60000, &events);
    EXPECT_EQ(run.state.await, Await::kEnd) << right << " at " << run.state.progress.lesson;
    std::printf("%g right: %d trials\n", right, events);
    EXPECT_LT(events, right > 0.85 ? 2600 : 3600) << right;
  }
}

TEST(LearnMoon, WhoOnlyGuessesGetsNowhere) {
  LessonRun run(LoadCourse("learn-moon"), {}, 1);
  std::mt19937 random(1);
  run.Begin();
  // Traces well, so that the names alone hold it up: in the second lesson one of four letters, four
  // of five right, at two sizes.
  const std::vector<std::string> letters = {"t", "i", "l", "o"};
  for (int i = 0; i < 3000; ++i) {
    const bool named = run.state.await == Await::kAnswer;
    if (named) {
      run.Answer(letters[random() % 4]);
    } else {
      run.Work();
    }
  }
  EXPECT_LE(run.state.progress.done.size(), 1u) << run.state.progress.lesson;
}

}  // namespace
}  // namespace moontrace
