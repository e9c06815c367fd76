// The first lesson as it is told to a learner with a device: each line as it is said, what the
// learner types behind "> ", and what the hand does in brackets.
#include <gtest/gtest.h>

#include "sim/console/line_wrap.h"
#include "sim/learn/lesson_voice.h"
#include "tests/lessons/lesson_fixture.h"
#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"
#include "textures/base/resources.h"

namespace moontrace {
namespace {

using lesson_action::Await;

/// A learner who is right but for the second answer, and loses the first line once.
class Transcript {
 public:
  /// `held`: by a stick whose tip cannot be lifted.
  explicit Transcript(bool held = false)
      : run_(LoadCourse(ResourcePath("lessons/courses/learn-moon"))) {
    run_.state.held = held;
  }

  std::string Told() {
    run_.Begin();
    Tell();
    for (int events = 0; run_.state.progress.done.empty() && events < 200; ++events) {
      Answer();
      Tell();
    }
    return told_;
  }

 private:
  void Tell() {
    for (const Action& action : run_.actions) {
      const auto* say = std::get_if<lesson_action::Say>(&action);
      if (say == nullptr) continue;
      for (const std::string& line : Sentences(voice_.Words(run_.course, *say, false, false))) {
        told_ += Wrapped(line, 40);
      }
    }
  }
  void Answer() {
    switch (run_.state.await) {
      case Await::kTrace:
        told_ += run_.push.demonstrate ? "[is led]\n" : "[follows it]\n";
        return run_.Trace(run_.push.demonstrate || ++traces_ != 1);
      case Await::kAnswer: {
        const std::string answer = ++answers_ == 2 ? run_.WrongAnswer() : run_.RightAnswer();
        told_ += "> " + answer + "\n";
        return run_.Answer(answer);
      }
      case Await::kNext:
        told_ += "> next\n";
        return run_.Next();
      case Await::kEnd:
        return;
    }
  }

  LessonRun run_;
  LessonVoice voice_;
  std::string told_;
  int traces_ = 0, answers_ = 0;
};

TEST(LessonOne, IsToldAsItWasReadAndKept) {
  const std::string told = Transcript().Told();
  const std::string kept = ReadAll(SourcePath("tests/data/lesson-1.txt"));
  if (told != kept) WriteAll(testing::TempDir() + "lesson-1.txt", told);
  EXPECT_EQ(told, kept) << "what was told is in " << testing::TempDir() << "lesson-1.txt";
}

// A stick's learner heard "lower it until something firm holds it" and "lift when done".
TEST(LessonOne, OfATipThatCannotBeLiftedSaysDone) {
  const std::string told = Transcript(true).Told();
  const std::string kept = ReadAll(SourcePath("tests/data/lesson-1-held.txt"));
  if (told != kept) WriteAll(testing::TempDir() + "lesson-1-held.txt", told);
  EXPECT_EQ(told, kept) << "what was told is in " << testing::TempDir() << "lesson-1-held.txt";
  for (const char* word : {"lift", "ower it", "stylus", "pencil"}) {
    EXPECT_EQ(told.find(word), std::string::npos) << word;
  }
  EXPECT_NE(told.find("Trace t; say done"), std::string::npos) << told;
}

TEST(LessonOne, SaysHowToAnswerOnce) {
  std::string told = Transcript().Told();
  for (const char* once : {"Say its name.", "lift when done."}) {
    const std::size_t first = told.find(once);
    ASSERT_NE(first, std::string::npos) << once;
    EXPECT_EQ(told.find(once, first + 1), std::string::npos) << once;
  }
}

TEST(LessonOne, FitsFortyCells) {
  for (const std::string& line : Lines(Transcript().Told())) {
    EXPECT_LE(Characters(line), 40U) << line;
  }
}

}  // namespace
}  // namespace moontrace
