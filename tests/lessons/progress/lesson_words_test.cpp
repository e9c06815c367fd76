// Words of the learner and the tutor, at every state.

#include <gtest/gtest.h>

#include "lessons/progress/learning.h"
#include "tests/lessons/lesson_fixture.h"

namespace moontrace {
namespace {

using lesson_action::Await;
using lesson_action::Sentence;
using lesson_event::Overrule;
using lesson_event::Word;

class LessonWords : public testing::Test {
 protected:
  LessonWords() : run_(SmallCourse()) { run_.Begin(); }
  /// To the first trace with help, of i.
  void GoToTrace() {
    run_.Next();
    run_.Trace();
    ASSERT_EQ(run_.state.await, Await::kTrace);
    ASSERT_EQ(run_.push.help, 6);
  }
  void GoToQuestion() {
    while (run_.state.progress.step < 2) run_.Work();
    ASSERT_EQ(run_.state.await, Await::kAnswer);
  }
  static int Sentences(const LessonRun& run) {
    int count = 0;
    for (const Action& action : run.actions) {
      count += std::holds_alternative<lesson_action::Say>(action) ? 1 : 0;
    }
    return count;
  }
  /// What the last event put before the learner anew.
  template <typename T>
  bool Did() const {
    for (const Action& action : run_.actions) {
      if (std::holds_alternative<T>(action)) return true;
    }
    return false;
  }
  LessonRun run_;
};

TEST_F(LessonWords, ATextOfOnesOwnIsReadAndTheQuestionComesAgainBehindIt) {
  GoToQuestion();
  const std::size_t kept = run_.kept.size();
  const Progress before = run_.state.progress;
  run_.Do(lesson_event::OwnText{"Lit: go"});
  EXPECT_EQ(run_.show.text, "Lit: go");
  EXPECT_TRUE(run_.show.told);
  EXPECT_EQ(run_.state.await, Await::kNext);
  EXPECT_TRUE(run_.Said(Sentence::kReadIt));
  const auto* unmet = run_.Find(Sentence::kNotLearnt);
  ASSERT_NE(unmet, nullptr);
  EXPECT_EQ(unmet->text, ":, g, o");
  run_.Say(Word::kBigger);  // of the page that lies there
  EXPECT_EQ(run_.show.text, "Lit: go");
  run_.Next();
  EXPECT_EQ(run_.state.await, Await::kAnswer);
  EXPECT_FALSE(run_.show.told);
  EXPECT_EQ(run_.kept.size(), kept);  // nothing of it counts
  EXPECT_EQ(run_.state.progress, before);
}

TEST_F(LessonWords, AReviewThatIsLeftForATextComesAgain) {
  GoToQuestion();
  run_.state.reviews = {"i", "t"};
  run_.Answer(run_.state.item);  // right, whatever is asked
  ASSERT_TRUE(run_.state.review);
  ASSERT_EQ(run_.state.item, "i");
  run_.Do(lesson_event::OwnText{"lit"});
  run_.Do(lesson_event::OwnText{"till"});
  run_.Next();
  EXPECT_TRUE(run_.state.review);
  EXPECT_EQ(run_.state.item, "i");
  EXPECT_EQ(run_.state.reviews, (std::vector<std::string>{"t"}));
}

TEST_F(LessonWords, EveryWordIsAnsweredAtEveryState) {
  int states = 0;
  for (int i = 0; i < 400; ++i) {
    for (const Word word :
         {Word::kAgain, Word::kNext, Word::kBack, Word::kBigger, Word::kSmaller, Word::kMoreHelp,
          Word::kLessHelp, Word::kSlower, Word::kFaster, Word::kHint}) {
      LessonRun aside = run_;
      aside.Say(word);
      ASSERT_TRUE(Sentences(aside) > 0) << "word " << static_cast<int>(word) << " at event " << i;
      ASSERT_TRUE(std::holds_alternative<Await>(aside.actions.back()));
      ++states;
    }
    if (run_.state.await == Await::kEnd) break;
    run_.Work();
  }
  EXPECT_EQ(run_.state.await, Await::kEnd);
  EXPECT_GT(states, 9 * 100);
}

TEST_F(LessonWords, ThereIsNoWayBackFromAQuestion) {
  GoToQuestion();
  const std::string item = run_.state.item;
  const std::size_t step = run_.state.progress.step;
  run_.Say(Word::kBack);
  EXPECT_TRUE(run_.Said(Sentence::kNoWayBack));
  EXPECT_EQ(run_.state.item, item);
  EXPECT_EQ(run_.state.progress.step, step);
  EXPECT_EQ(run_.state.await, Await::kAnswer);
}

TEST_F(LessonWords, BackShowsTheTextBeforeAndKeepsWhatIsKnown) {
  run_.Say(Word::kBack);
  EXPECT_TRUE(run_.Said(Sentence::kNoTextBefore)) << "the lesson begins with its first text";
  GoToTrace();
  const std::size_t step = run_.state.progress.step;
  const auto items = run_.state.progress.items;
  run_.Say(Word::kBack);
  EXPECT_EQ(run_.show.text, "itl");
  EXPECT_EQ(run_.state.progress.step, 0U);
  EXPECT_EQ(run_.state.progress.items, items);
  EXPECT_EQ(LearnAll(run_.course, run_.kept), run_.state.progress) << "a new start knows it too";
  while (run_.state.progress.step != step) run_.Work();
  EXPECT_EQ(run_.state.await, Await::kTrace);
}

// Whatever is asked, a sign that is known is traced once more; then the question comes again.
TEST_F(LessonWords, PractiseTracesAKnownSignAndComesBack) {
  while (run_.state.await != Await::kAnswer) run_.Work();
  const std::size_t step = run_.state.progress.step;
  Overrule practise;
  practise.practise = "i";
  run_.Do(practise);
  ASSERT_NE(run_.Find(Sentence::kTraceIt), nullptr);
  EXPECT_EQ(run_.Find(Sentence::kTraceIt)->text, "i");
  EXPECT_TRUE(run_.show.told);
  run_.Trace();
  EXPECT_EQ(run_.kept.back().kind, StepKind::kTrace);
  EXPECT_EQ(run_.state.progress.step, step);
  EXPECT_EQ(run_.state.await, Await::kAnswer);
  practise.practise = "o";  // of the second lesson
  run_.Do(practise);
  ASSERT_TRUE(run_.Said(Sentence::kCannotPractise));
  EXPECT_EQ(run_.Find(Sentence::kCannotPractise)->text, "o");
  EXPECT_EQ(run_.Find(Sentence::kCannotPractise)->number, 2);
  EXPECT_EQ(run_.state.await, Await::kAnswer);
}

TEST_F(LessonWords, AgainShowsAndAsksTheSame) {
  GoToQuestion();
  const lesson_action::Show before = run_.show;
  const std::size_t kept = run_.kept.size();
  run_.Say(Word::kAgain);
  EXPECT_TRUE(run_.Said(Sentence::kAskName));
  EXPECT_TRUE(Did<lesson_action::Show>());
  EXPECT_EQ(run_.show.text, before.text);
  EXPECT_EQ(run_.show.size, before.size);
  EXPECT_EQ(run_.kept.size(), kept);
}

TEST_F(LessonWords, NextSkipsWithoutMakingAnythingSure) {
  for (int i = 0; i < 100 && run_.state.progress.lesson == "01"; ++i) run_.Next();
  EXPECT_EQ(run_.state.progress.lesson, "02") << "the lesson moves on";
  EXPECT_TRUE(run_.state.progress.done.empty());
  for (const auto& [text, item] : run_.state.progress.items) EXPECT_FALSE(item.sure) << text;
  for (int i = 0; i < 100 && run_.state.progress.lesson == "02"; ++i) run_.Next();
  EXPECT_EQ(run_.state.progress.lesson, "01") << "what was left over comes again";
}

TEST_F(LessonWords, NextTellsWhatWasSkipped) {
  GoToQuestion();
  const std::string item = run_.state.item;
  run_.Next();
  EXPECT_EQ(run_.Find(Sentence::kSkipped)->text, item);
  EXPECT_TRUE(run_.Said(Sentence::kAnother));
  EXPECT_NE(run_.state.item, item);
  for (int i = 0; i < 30 && run_.state.progress.step == 2; ++i) {
    EXPECT_NE(run_.state.item, item);
    run_.Work();
  }
}

TEST_F(LessonWords, NextAtADemonstrationGoesOnToTheTrace) {
  run_.Next();
  ASSERT_TRUE(run_.push.demonstrate);
  run_.Next();
  EXPECT_EQ(run_.Find(Sentence::kTraceIt)->text, "i");
}

// Three words of nobody's hand were told as an exercise, and kept as one.
TEST_F(LessonWords, WhatIsLeftUntouchedIsNoTrial) {
  for (int i = 0; i < 100 && run_.state.progress.lesson == "01"; ++i) run_.Next();
  for (const Trial& trial : run_.kept) EXPECT_EQ(trial.item, "") << NameOf(trial.kind);
}

TEST_F(LessonWords, ANewSignThatWasLeftIsShownTheNextTime) {
  run_.Next();
  ASSERT_TRUE(run_.push.demonstrate);
  run_.Next();
  ASSERT_FALSE(run_.push.demonstrate);
  LessonRun later(SmallCourse(), LearnAll(run_.course, run_.kept));
  later.Begin();
  EXPECT_TRUE(later.push.demonstrate);
  EXPECT_EQ(later.Find(Sentence::kNewItem)->text, "i");
}

TEST_F(LessonWords, ASignThatWasLeftAndNamedWrongIsShownAfterAll) {
  Course course = SmallCourse();
  course.lessons = {
      MakeLesson("01", {"i", "t"}, {MakeStep(StepKind::kDemonstrate), MakeStep(StepKind::kTest)})};
  LessonRun run(course);
  run.Begin();
  for (int i = 0; i < 2; ++i) run.Next();
  ASSERT_EQ(run.state.task, StepKind::kTest);
  ASSERT_EQ(run.kept.back().item, "");
  for (int i = 0; i < 2; ++i) run.Answer(run.WrongAnswer());
  EXPECT_TRUE(run.push.demonstrate) << run.state.item;
}

TEST_F(LessonWords, SizesGoAlongTheLadderAndBackToTheRules) {
  GoToTrace();
  run_.Say(Word::kBigger);
  EXPECT_TRUE(run_.Said(Sentence::kCannotLarger));
  run_.Say(Word::kSmaller);
  EXPECT_EQ(run_.Find(Sentence::kSizeNow)->value, 0.020);
  EXPECT_EQ(run_.show.size, 0.020);
  run_.Trace();
  EXPECT_EQ(run_.show.size, 0.020) << "it stays";
  EXPECT_EQ(run_.kept.back().size, 0.020);
  run_.Say(Word::kSmaller);
  run_.Say(Word::kSmaller);
  EXPECT_TRUE(run_.Said(Sentence::kCannotSmaller));
  run_.Say(Word::kBigger);
  run_.Say(Word::kBigger);
  EXPECT_EQ(run_.show.size, 0.040);
  EXPECT_FALSE(run_.state.overrule.size.has_value()) << "where the rules are, they choose again";
}

TEST_F(LessonWords, HelpChangesAtOnceAndWhatHelpedIsKept) {
  GoToTrace();
  run_.Say(Word::kLessHelp);
  EXPECT_EQ(run_.Find(Sentence::kHelpNow)->value, 5);
  EXPECT_EQ(run_.push.help, 5);
  EXPECT_FALSE(Did<lesson_action::Show>()) << "the page goes on";
  for (int i = 0; i < 5; ++i) run_.Say(Word::kLessHelp);
  EXPECT_EQ(run_.push.help, 0);
  EXPECT_EQ(run_.push.mode, GuidanceMode::kOff);
  run_.Say(Word::kLessHelp);
  EXPECT_TRUE(run_.Said(Sentence::kNoLessHelp));
  run_.Trace();
  EXPECT_EQ(run_.kept.back().help, 6) << "a push that was on for a while has helped";
  EXPECT_TRUE(run_.kept.back().guided());
  run_.Trace();
  EXPECT_FALSE(run_.kept.back().guided());
}

TEST_F(LessonWords, HelpInAProbeMakesItATrialWithHelp) {
  GoToTrace();
  for (int i = 0; i < 3; ++i) run_.Trace();
  ASSERT_TRUE(run_.state.probe);
  run_.Say(Word::kMoreHelp);
  EXPECT_GT(run_.push.help, 0);
  run_.Trace();
  EXPECT_TRUE(run_.kept.back().guided());
  EXPECT_FALSE(run_.kept.back().probe);
  EXPECT_TRUE(run_.state.probe) << "the probe is still to come";
}

TEST_F(LessonWords, NoHelpWhileSomethingIsRecognised) {
  GoToQuestion();
  run_.Say(Word::kMoreHelp);
  EXPECT_TRUE(run_.Said(Sentence::kNoHelpHere));
  run_.Do(Overrule{{}, 10, GuidanceMode::kBead, {}, false, false, {}});
  EXPECT_TRUE(run_.Said(Sentence::kNoHelpHere));
  for (int i = 0; i < 10; ++i) {
    const bool asked = run_.state.await == Await::kAnswer;
    EXPECT_EQ(asked, run_.push.mode == GuidanceMode::kOff) << "the tutor's help is for traces";
    run_.Work();
    EXPECT_NE(asked, run_.kept.back().guided());
  }
}

TEST_F(LessonWords, SpeedHasItsBounds) {
  GoToTrace();
  run_.Say(Word::kFaster);
  EXPECT_DOUBLE_EQ(run_.push.speed, 1.25);
  for (int i = 0; i < 20; ++i) run_.Say(Word::kFaster);
  EXPECT_DOUBLE_EQ(run_.push.speed, 4);
  for (int i = 0; i < 40; ++i) run_.Say(Word::kSlower);
  EXPECT_DOUBLE_EQ(run_.push.speed, 0.25);
}

TEST_F(LessonWords, AHintDoesNotGiveAnAnswerAway) {
  GoToTrace();
  run_.Say(Word::kHint);
  EXPECT_EQ(run_.Find(Sentence::kHint)->text, "an upright");
  GoToQuestion();
  run_.Say(Word::kHint);
  EXPECT_EQ(run_.Find(Sentence::kNoHint)->number, 1) << "it is asked";
}

TEST_F(LessonWords, WhatDoesNotFitIsAnswered) {
  run_.Trace();
  EXPECT_TRUE(run_.Said(Sentence::kNotNow));
  run_.Answer("b");
  EXPECT_EQ(run_.Find(Sentence::kNotAsked)->text, "b");
  EXPECT_EQ(run_.state.await, Await::kNext);
}

TEST_F(LessonWords, TheTutorOverrulesUntilTheRulesAreAskedAgain) {
  GoToTrace();
  run_.Do(Overrule{0.033, 9, GuidanceMode::kRail, {}, false, false, {}});
  EXPECT_EQ(run_.Find(Sentence::kSizeNow)->value, 0.033);
  EXPECT_EQ(run_.Find(Sentence::kHelpNow)->value, 9);
  EXPECT_EQ(run_.Find(Sentence::kModeNow)->text, "rail");
  EXPECT_EQ(run_.show.size, 0.033);
  EXPECT_EQ(run_.push.mode, GuidanceMode::kRail);
  EXPECT_EQ(run_.push.help, 9);
  run_.Do(Overrule{{}, 4, {}, {}, false, false, {}});
  EXPECT_EQ(run_.push.mode, GuidanceMode::kRail) << "what is not set stays";
  EXPECT_EQ(run_.push.help, 4);
  EXPECT_FALSE(Did<lesson_action::Show>());
  run_.Trace();
  EXPECT_EQ(run_.show.size, 0.033);
  EXPECT_EQ(run_.push.help, 4);
  run_.Do(Overrule{});
  EXPECT_TRUE(run_.Said(Sentence::kByRules));
  EXPECT_EQ(run_.show.size, 0.040);
  EXPECT_EQ(run_.push.mode, GuidanceMode::kAttract);
  EXPECT_EQ(run_.push.help, 6);
}

TEST_F(LessonWords, ProbesGoOnUnderATutorsHelp) {
  GoToTrace();
  run_.Do(Overrule{{}, 9, {}, {}, false, false, {}});
  int probes = 0;
  for (int i = 0; i < 4; ++i) {
    probes += run_.push.help == 0 ? 1 : 0;
    run_.Trace();
  }
  EXPECT_EQ(probes, 1);
}

TEST_F(LessonWords, TheTutorLeadsToOtherLessons) {
  Overrule to;
  to.lesson = "02";
  run_.Do(to);
  ASSERT_NE(run_.Find(Sentence::kLessonLeft), nullptr);
  EXPECT_EQ(run_.Find(Sentence::kLessonLeft)->text, "Lesson 01");
  EXPECT_EQ(run_.Find(Sentence::kLesson)->text, "Lesson 02");
  EXPECT_EQ(run_.state.progress.lesson, "02");
  to.lesson = "no such";
  run_.Do(to);
  EXPECT_EQ(run_.Find(Sentence::kNoSuchLesson)->text, "no such");
  EXPECT_EQ(run_.state.progress.lesson, "02");
  Overrule next;
  next.next_lesson = true;
  run_.Do(next);
  EXPECT_TRUE(run_.Said(Sentence::kLastLesson));
  Overrule skip;
  skip.skip = true;
  run_.Do(skip);
  EXPECT_EQ(run_.state.item, ",");
}

// Before, the lesson beside the course was the next of the last one.
TEST_F(LessonWords, TheNextLessonIsNoneBesideTheCourse) {
  Course course = SmallCourse();
  course.lessons.push_back(MakeLesson("hands", {"o"}, {MakeStep(StepKind::kTrace)}));
  course.lessons.back().optional = true;
  LessonRun run(course);
  run.Begin();
  Overrule to;
  to.lesson = "02";
  run.Do(to);
  Overrule next;
  next.next_lesson = true;
  run.Do(next);
  EXPECT_TRUE(run.Said(Sentence::kLastLesson));
  EXPECT_EQ(run.state.progress.lesson, "02");
  to.lesson = "hands";
  run.Do(to);
  run.Do(next);
  EXPECT_NE(run.state.progress.lesson, "hands") << "the course goes on behind it";
}

TEST_F(LessonWords, ALimitOfSizesIsSaid) {
  Overrule size;
  size.size = 0.5;
  run_.Do(size);
  ASSERT_TRUE(run_.Said(Sentence::kLargestSize));
  EXPECT_EQ(run_.Find(Sentence::kLargestSize)->value, 0.2);
  EXPECT_FALSE(run_.Said(Sentence::kSizeNow)) << "one line";
  EXPECT_EQ(run_.show.size, 0.2);
  size.size = 0.2;
  run_.Do(size);
  EXPECT_FALSE(run_.Said(Sentence::kLargestSize)) << "just the largest";
}

TEST_F(LessonWords, AtTheEndALessonCanBeginAgain) {
  for (int i = 0; i < 400 && run_.state.await != Await::kEnd; ++i) run_.Work();
  ASSERT_EQ(run_.state.await, Await::kEnd);
  run_.Next();
  EXPECT_TRUE(run_.Said(Sentence::kCourseDone));
  Overrule to;
  to.lesson = "02";
  run_.Do(to);
  EXPECT_EQ(run_.state.await, Await::kTrace);
  for (int i = 0; i < 400 && run_.state.await != Await::kEnd; ++i) run_.Work();
  EXPECT_EQ(run_.state.await, Await::kEnd);
}

}  // namespace
}  // namespace moontrace
