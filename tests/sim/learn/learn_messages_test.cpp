#include "sim/learn/learn_messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "sim/console/line_wrap.h"
#include "sim/learn/key_wording.h"
#include "sim/learn/learn_keys.h"
#include "sim/session/loop_messages.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

using lesson_action::Sentence;

/// The first 40 columns, what a Braille display shows, end a clause: with the sentence, a stop, a
/// comma or a colon.
void ExpectOutcomeFirst(const std::string& line) {
  EXPECT_FALSE(line.empty());
  const bool clause =
      Characters(line) <= 40 || line.substr(0, 40).find_first_of(".,;:?!") != std::string::npos;
  EXPECT_TRUE(clause) << line;
}

TEST(LearnMessages, EverySentenceOfTheLessonHasItsOutcomeInTheFirst40Columns) {
  const Course course;
  for (int i = 0; i <= static_cast<int>(Sentence::kSmallestSize); ++i) {
    lesson_action::Say say;
    say.sentence = static_cast<Sentence>(i);
    say.text = "apostrophe";
    say.other = "quotation";
    say.value = 0.012;
    say.number = 3;
    say.of = 10;
    ExpectOutcomeFirst(say::LessonSentence(course, say));
  }
}

TEST(LearnMessages, AnswersAndBeginningsHaveTheirsToo) {
  for (const std::string& line : {say::AlreadyStopped(),
                                  say::NotStopped(),
                                  say::Pausing(true),
                                  say::Pausing(false),
                                  say::AskConsent(),
                                  say::ConsentHelp(),
                                  say::ConsentGiven(true),
                                  say::ConsentGiven(false),
                                  say::NotWhileAsked(),
                                  say::NoLetterHere(),
                                  say::NothingTouched(false),
                                  say::NothingTouched(true),
                                  say::MousePresses(),
                                  say::MouseCannotPush(),
                                  say::NothingFollowed(),
                                  say::NextLeavesIt(),
                                  say::StillAsked(),
                                  say::LedNow(),
                                  say::ProgramTraces(),
                                  say::ByProgramsHand(),
                                  say::WhatProgramsHandDoes(true),
                                  say::NotFelt(),
                                  say::EndOfInput(),
                                  say::LostTrial(),
                                  say::NoRoomFor(0.04, 0.02),
                                  say::SizeHasNoRoom(0.04, 0.02),
                                  say::NoForceDevice(),
                                  say::WayInWords("question mark"),
                                  say::LearnScaled(),
                                  say::SessionEnded(12, 3),
                                  say::TipAt("apostrophe", 2, true),
                                  say::TipBetween(false),
                                  say::WhereInCourse("J, N and Z", 7, 22, 1, 6),
                                  say::Learner("somebody", 1000, false)}) {
    ExpectOutcomeFirst(line);
  }
  for (const auto await : {lesson_action::Await::kTrace, lesson_action::Await::kAnswer,
                           lesson_action::Await::kNext, lesson_action::Await::kEnd}) {
    ExpectOutcomeFirst(say::Awaited(await, Question::kName, "i or t", true));
  }
}

TEST(LearnMessages, ItemsAreCalledByTheirNames) {
  Course course;
  course.names[","] = "comma";
  EXPECT_EQ(say::Called(course, ","), "comma");
  EXPECT_EQ(say::Called(course, "b"), "b");
  EXPECT_EQ(say::Called(course, ",\nb"), "comma and b");
}

TEST(LearnMessages, HelpNamesEveryWordWithItsNumber) {
  const say::HelpLines help = say::LearnHelp(true, true);
  const std::string words = help.first.front() + help.more.front();
  for (std::size_t i = 0; i < LearnWords().size(); ++i) {
    EXPECT_NE(words.find(std::to_string(i + 1) + " " + LearnWords()[i]), std::string::npos);
  }
}

TEST(LearnMessages, HelpMarksWordsThatAFirstLessonDoesWithout) {
  const say::HelpLines both = say::LearnHelp(true, true);
  const std::string help[] = {both.first.front(), both.more.front()};
  EXPECT_EQ(help[1].rfind("For later, ", 0), 0U) << help[1];
  // what lesson 1 names in its own texts is not for later
  for (const char* word :
       {"1 stop", "2 next", "3 where", "7 bigger", "9 more help", "14 again", "15 go", "17 done"}) {
    EXPECT_NE(help[0].find(word), std::string::npos) << word;
  }
  for (const char* word : {"5 spell", "25 my text"}) {
    EXPECT_NE(help[1].find(word), std::string::npos) << word;
  }
}

TEST(LearnMessages, BriefSaysOutcomesAndQuestionsButNoExplanation) {
  const Course course;
  lesson_action::Say say;
  say.text = "b";
  say.other = "j";
  const auto brief = [&](Sentence sentence) {
    say.sentence = sentence;
    return say::BriefSentence(course, say);
  };
  EXPECT_EQ(brief(Sentence::kCourseText), "");
  EXPECT_EQ(brief(Sentence::kHint), "");
  EXPECT_EQ(brief(Sentence::kWrong), "Wrong: b.");
  EXPECT_EQ(brief(Sentence::kAskPick), "Is it b or j?");
  for (int i = 0; i <= static_cast<int>(Sentence::kSmallestSize); ++i) {
    say.sentence = static_cast<Sentence>(i);
    EXPECT_LE(say::BriefSentence(course, say).size(), say::LessonSentence(course, say).size()) << i;
  }
}

TEST(LearnMessages, SayWhatIsAskedAsItWasAsked) {
  const auto asked = [](Question question) {
    return say::Awaited(lesson_action::Await::kAnswer, question, "i or t", true);
  };
  EXPECT_EQ(asked(Question::kName), "Asked: what is it?");
  EXPECT_EQ(asked(Question::kPick), "Asked: is it i or t?");
  EXPECT_EQ(asked(Question::kSame), "Asked: same or different?");
}

TEST(LearnMessages, CallAWordAWord) {
  Course course;
  course.lessons.emplace_back().items = {"i", "the"};
  const auto wrong = [&course](const std::string& item) {
    lesson_action::Say say;
    say.sentence = Sentence::kWrong;
    say.text = item;
    say.other = "t";
    return say::LessonSentence(course, say);
  };
  EXPECT_EQ(wrong("i"), "Wrong: it is i, you said t.");
  EXPECT_EQ(wrong("the"), "Wrong: it is the, you said t.") << "a sign";
  EXPECT_EQ(wrong("it"), "Wrong: it is the word it, you said t.");
}

TEST(LearnMessages, SayInWordsHowMuchWasFollowed) {
  Course course;
  course.mastery.coverage = 0.9;
  const auto told = [&course](double coverage) {
    lesson_action::Say say;
    say.sentence = Sentence::kTraceBad;
    say.text = "t";
    say.value = coverage;
    return say::LessonSentence(course, say);
  };
  EXPECT_EQ(told(0), "Not yet: t, next to nothing of it.");
  EXPECT_EQ(told(std::numeric_limits<double>::quiet_NaN()), told(0));
  EXPECT_EQ(told(0.3), "Not yet: t, less than half of it.");
  EXPECT_EQ(told(0.5), "Not yet: t, about half of it.");
  EXPECT_EQ(told(0.85), "Not yet: t, most of it, not all.");
  EXPECT_EQ(told(0.95), "Not yet: t, stay closer to the line.") << "it was followed to its end";
}

// Words of who measures are for tutors and researchers.
TEST(LearnMessages, HaveNoJargon) {
  std::string all = say::SizesEndAt(0.01, 0.0084) + say::SizesEndAt(0.01, 0.02) + say::NotFelt() +
                    say::LearnScaled() + say::SofterThanUsual(0.8) + say::NotAName() +
                    say::SimulatedProves() + say::DemonstrationIsAlone();
  for (int i = 0; i <= static_cast<int>(Sentence::kSmallestSize); ++i) {
    lesson_action::Say say;
    say.sentence = static_cast<Sentence>(i);
    all += say::LessonSentence(Course(), say);
  }
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    all += say::Event(static_cast<SafetyEvent>(i), true);
    all += say::Event(static_cast<SafetyEvent>(i), false);
  }
  for (const char* word : {"covered", "greatest", "N/m", "renders", "MuJoCo", "mastery", "rial",
                           "pedagogy", "printable"}) {
    EXPECT_EQ(all.find(word), std::string::npos) << word << " in " << all;
  }
}

TEST(LearnMessages, HelpWithKeysNamesEveryKeyWithItsWord) {
  const say::HelpLines help = say::KeysHelp(UsualKeys(), true, true);
  const std::string words = help.first.front() + help.more.front();
  for (const auto& [key, word] : UsualKeys()) {
    EXPECT_NE(words.find(KeyCalled(key) + " " + word), std::string::npos) << key;
  }
}

// A Braille display of forty cells is read line by line: twelve lines are a page of it.
TEST(LearnMessages, EndWithOneFullStop) {
  const Course course;
  for (const Sentence sentence :
       {Sentence::kNotAnAnswer, Sentence::kNotAsked, Sentence::kCannotPractise}) {
    lesson_action::Say say;
    say.sentence = sentence;
    say.text = "t.";  // as it was typed
    EXPECT_EQ(say::LessonSentence(course, say).find(".."), std::string::npos)
        << static_cast<int>(sentence);
  }
  EXPECT_EQ(say::AskOwnText("The cat sat."),
            "Your text? Type it and Enter; Enter alone takes: The cat sat.");
  EXPECT_EQ(say::AskOwnText("Till it"),
            "Your text? Type it and Enter; Enter alone takes: Till it.");
}

TEST(LearnMessages, HelpSpeaksOfAButtonOnlyWhereThereIsOne) {
  const auto all = [](const say::HelpLines& help) {
    std::string lines;
    for (const auto& list : {help.first, help.more}) {
      for (const std::string& line : list) lines += line + '\n';
    }
    return lines;
  };
  EXPECT_NE(all(say::LearnHelp(true, true)).find("One press of the device's button"),
            std::string::npos);
  for (const std::string& without :
       {all(say::LearnHelp(false, false)), all(say::KeysHelp(UsualKeys(), false, false))}) {
    EXPECT_EQ(without.find("button"), std::string::npos) << without;
    EXPECT_EQ(without.find("One press"), std::string::npos) << without;
  }
}

// A blind learner is told of a mouse what there is to do, not what there is to see.
TEST(LearnMessages, OfAMouseSayHowItPresses) {
  EXPECT_EQ(say::NothingTouched(true), "Nothing touched: hold the mouse button while you move.");
  const std::string told = say::MousePresses() + " " + say::MouseCannotPush();
  EXPECT_EQ(told.rfind("Hold the mouse button down: that presses the tip on the paper.", 0), 0U);
  for (const char* word : {"seen", "see ", "picture", "handle"}) {
    EXPECT_EQ(told.find(word), std::string::npos) << word;
  }
}

TEST(LearnMessages, TellInWhichLessonASignComes) {
  lesson_action::Say say;
  say.sentence = Sentence::kCannotPractise;
  say.text = "b";
  say.number = 10;
  EXPECT_EQ(say::LessonSentence(Course(), say), "Not learnt yet: b comes in lesson 10.");
  say.number = 0;
  EXPECT_EQ(say::LessonSentence(Course(), say), "No sign learned so far: b.");
}

TEST(LearnMessages, HelpIsShortUntilItIsAskedForOnceMore) {
  for (const say::HelpLines& help :
       {say::LearnHelp(true, true), say::KeysHelp(UsualKeys(), true, true)}) {
    std::size_t lines = 0;
    for (const std::string& sentence : help.first) {
      const std::string wrapped = Wrapped(sentence, 40);
      lines += static_cast<std::size_t>(std::count(wrapped.begin(), wrapped.end(), '\n'));
    }
    EXPECT_LE(lines, 14U);
  }
}

}  // namespace
}  // namespace moontrace
