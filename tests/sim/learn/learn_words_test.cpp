#include "sim/learn/learn_words.h"

#include <gtest/gtest.h>

namespace moontrace {
namespace {

using Kind = LearnLine::Kind;

/// Teaches a, the word "go", 7 and the comma.
Course SmallCourse() {
  Course course;
  Lesson lesson;
  lesson.items = {"a", "go", "7", ",", "the"};
  course.lessons = {lesson};
  course.names = {{",", "comma"}, {"?", "question mark"}};
  return course;
}

LearnLine Read(std::string_view line, Asked asked = Asked::kNothing) {
  return ReadLearnLine(line, asked, SmallCourse());
}

void ExpectWord(const LearnLine& line, LearnWord word) {
  EXPECT_EQ(line.kind, Kind::kWord);
  EXPECT_EQ(line.word, word);
}

void ExpectAnswer(const LearnLine& line, const std::string& answer) {
  EXPECT_EQ(line.kind, Kind::kAnswer);
  EXPECT_EQ(line.answer, answer);
}

TEST(LearnWords, AreReadWholeBegunOrByNumber) {
  const std::vector<std::string>& words = LearnWords();
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (const std::string& given :
         {words[i], "/" + words[i], " " + words[i] + "\t", words[i] + "?", std::to_string(i + 1)}) {
      ExpectWord(Read(given), static_cast<LearnWord>(i));
    }
  }
  ExpectWord(Read("STOP"), LearnWord::kStop);
  ExpectWord(Read("ag"), LearnWord::kAgain);
  ExpectWord(Read("mo"), LearnWord::kMoreHelp);
  ExpectWord(Read("less"), LearnWord::kLessHelp);
  ExpectWord(Read("?"), LearnWord::kHelp);
  ExpectWord(Read("/"), LearnWord::kHelp);
}

TEST(LearnWords, ThatCameLaterTakeNobodysShortFormsAway) {
  ExpectWord(Read("les"), LearnWord::kLessHelp);
  ExpectWord(Read("p"), LearnWord::kPause);
  ExpectWord(Read("sk"), LearnWord::kSkip);
  ExpectWord(Read("lessons"), LearnWord::kLessons);
  ExpectWord(Read("how"), LearnWord::kHow);
  ExpectWord(Read("How am I doing?"), LearnWord::kHow);
}

TEST(LearnWords, MyTextTakesATextAsItWasTyped) {
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kSame}) {
    for (const char* line : {"my text The Cat", "/My text  The Cat ", " MY TEXT The Cat"}) {
      const LearnLine read = Read(line, asked);
      EXPECT_EQ(read.kind, Kind::kMyText) << line;
      EXPECT_EQ(read.answer, "The Cat") << line;
    }
    ExpectWord(Read("my text", asked), LearnWord::kMyText);
  }
  ExpectWord(Read("my"), LearnWord::kMyText);
  ExpectWord(Read("m"), LearnWord::kMoreHelp);
  ExpectWord(Read("b"), LearnWord::kBigger);
  ExpectWord(Read("f"), LearnWord::kFaster);
}

TEST(LearnWords, AnyLineIsTheTextThatWasAskedForButStopQuitAndSlashes) {
  for (const char* line : {"The Cat", "next", "7", "my"}) {
    const LearnLine read = Read(line, Asked::kText);
    EXPECT_EQ(read.kind, Kind::kMyText) << line;
    EXPECT_EQ(read.answer, line);
  }
  EXPECT_EQ(Read("", Asked::kText).kind, Kind::kMyText);
  EXPECT_EQ(Read("", Asked::kText).answer, "");
  ExpectWord(Read("stop", Asked::kText), LearnWord::kStop);
  ExpectWord(Read("quit", Asked::kText), LearnWord::kQuit);
  ExpectWord(Read("/next", Asked::kText), LearnWord::kNext);
  ExpectWord(Read("?", Asked::kText), LearnWord::kHelp);
}

TEST(LearnWords, FindTakesATextAndIsNoAnswer) {
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kSame}) {
    for (const char* line : {"find the Cat", "/Find the Cat", "48 the Cat"}) {
      if (line[0] == '4' && asked != Asked::kNothing) continue;  // nobody says so in answers
      const LearnLine read = Read(line, asked);
      EXPECT_EQ(read.kind, Kind::kPlace) << line;
      EXPECT_EQ(read.place.word, PlaceWord::kFind) << line;
      EXPECT_EQ(read.place.text, "the Cat") << line;
    }
    EXPECT_EQ(Read("find next", asked).place.word, PlaceWord::kFindNext);
    EXPECT_EQ(Read("next line", asked).place.word, PlaceWord::kNextLine);
    EXPECT_EQ(Read("return", asked).place.word, PlaceWord::kReturn);
  }
  EXPECT_EQ(Read("find n").place.text, "n");
  ExpectWord(Read("f"), LearnWord::kFaster);
}

TEST(LearnWords, PractiseTakesASign) {
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kSame}) {
    const LearnLine read = Read("practise B", asked);
    EXPECT_EQ(read.kind, Kind::kPractise);
    EXPECT_EQ(read.answer, "b");
  }
  EXPECT_EQ(Read("practise").kind, Kind::kPractise);
  EXPECT_EQ(Read("practise").answer, "");
}

TEST(LearnWords, TakeALessonByItsNumberOrName) {
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kSame}) {
    for (const char* line : {"lesson 5", "/Lesson 5", " lesson  5 "}) {
      const LearnLine read = Read(line, asked);
      EXPECT_EQ(read.kind, Kind::kLesson) << line;
      EXPECT_EQ(read.answer, "5") << line;
    }
  }
  EXPECT_EQ(Read("lesson 04-itlo").answer, "04-itlo");
  Course course = SmallCourse();
  course.lessons[0].items.push_back("lesson 5");
  ExpectAnswer(ReadLearnLine("lesson 5", Asked::kName, course), "lesson 5");
}

TEST(LearnWords, ThatAreNoneOrSeveralAreToldApart) {
  EXPECT_EQ(Read("").kind, Kind::kNothing);
  EXPECT_EQ(Read(" \t ").kind, Kind::kNothing);
  const auto refused = [](std::string_view line) {
    const LearnLine read = Read(line);
    return read.kind == Kind::kRefused ? read.answer : std::string();
  };
  EXPECT_EQ(refused("fly"), "Unknown: fly. Say ? for the words.");
  EXPECT_EQ(refused("0"), "Unknown: 0. Say ? for the words.");
  EXPECT_EQ(refused("28"), "28 is no word here. Say ? for the words.");
  EXPECT_EQ(refused("le"), "le could be letter or less help.");
  EXPECT_EQ(refused("/w"), "w could be where or word.");
  EXPECT_EQ(refused("pause now"), "Say pause alone, without now.");
}

// "what?" was taken for an answer while a sign is asked.
TEST(LearnWords, PutAsPeopleDoAreNoAnswers) {
  for (const Asked asked : {Asked::kName, Asked::kNumber, Asked::kSame}) {
    ExpectWord(Read("what?", asked), LearnWord::kAgain);
    ExpectWord(Read("pardon?", asked), LearnWord::kAgain);
    ExpectWord(Read("again please", asked), LearnWord::kAgain);
    ExpectWord(Read("slower", asked), LearnWord::kSlower);
    ExpectWord(Read("hint", asked), LearnWord::kHint);
    ExpectWord(Read("exit", asked), LearnWord::kQuit);
    ExpectWord(Read("wait", asked), LearnWord::kPause);
  }
  EXPECT_EQ(Read("exit", Asked::kText).kind, Kind::kMyText);
}

// Who answers too early is told what to do, not that a letter is no word.
TEST(LearnWords, ThatAreNoneAreAnswersEvenWhereNothingIsAsked) {
  for (const char* line : {",", "comma", "It is go.", "I don't know", "i think it is the"}) {
    EXPECT_EQ(Read(line).kind, Kind::kAnswer) << line;
  }
  EXPECT_EQ(Read("go").kind, Kind::kWord);
  EXPECT_EQ(Read("/comma").kind, Kind::kRefused);
  EXPECT_EQ(Read("letter ,").answer, "Say letter alone, without ,.");
  EXPECT_EQ(Read("l").kind, Kind::kRefused);  // could be letter or less help
  for (const char* line : {"fly", "t"}) {
    EXPECT_EQ(Read(line, Asked::kSame).kind, Kind::kAnswer) << "asked once more: " << line;
  }
}

TEST(LearnWords, HelpIsNoAnswerWhateverStandsBehindIt) {
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kNumber, Asked::kSame}) {
    ExpectWord(Read("help mouse", asked), LearnWord::kHelp);
    EXPECT_EQ(Read("help mouse", asked).answer, "mouse");
  }
  EXPECT_EQ(Read("help the old man", Asked::kText).kind, Kind::kMyText);
}

TEST(LearnWords, HelpTakesTheWordItIsAskedAbout) {
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kSame}) {
    ExpectWord(Read("help next", asked), LearnWord::kHelp);
    EXPECT_EQ(Read("help next", asked).answer, "next");
  }
  ExpectWord(Read("back"), LearnWord::kBack);
  EXPECT_EQ(Read("lesson").kind, Kind::kLesson);
  EXPECT_EQ(Read("lesson").answer, "");
}

TEST(LearnWords, GiveWayToAnswersWhereSomethingIsAsked) {
  ExpectAnswer(Read("a", Asked::kName), "a");      // not "again"
  ExpectAnswer(Read("B", Asked::kName), "b");      // a sign that is not taught yet
  ExpectAnswer(Read("7", Asked::kNumber), "7");    // not "bigger"
  ExpectAnswer(Read("12", Asked::kNumber), "12");  // not "faster"
  ExpectAnswer(Read("go", Asked::kName), "go");    // an item of the course
  ExpectAnswer(Read("the", Asked::kName), "the");
  ExpectAnswer(Read("Comma", Asked::kName), "comma");
  ExpectAnswer(Read("question mark", Asked::kName), "question mark");
  ExpectAnswer(Read("elephant", Asked::kName), "elephant");
}

TEST(LearnWords, HaveTheirNumbersWhereNoNumberIsAskedFor) {
  ExpectWord(Read("2", Asked::kName), LearnWord::kNext);
  ExpectWord(Read("7", Asked::kName), LearnWord::kBigger);  // though the course will teach it
  ExpectWord(Read("18", Asked::kName), LearnWord::kQuit);
  EXPECT_EQ(Read("0", Asked::kName).kind, Kind::kRefused);
}

TEST(LearnWords, AreNotWhatWhoDoesNotKnowSays) {
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kNumber, Asked::kSame}) {
    ExpectAnswer(Read("I don't know", asked), "i don't know");
  }
}

TEST(LearnWords, CanBeSaidWhileSomethingIsAsked) {
  ExpectWord(Read("again", Asked::kName), LearnWord::kAgain);
  ExpectWord(Read("ag", Asked::kName), LearnWord::kAgain);
  ExpectWord(Read("/a", Asked::kName), LearnWord::kAgain);
  ExpectWord(Read("/1", Asked::kName), LearnWord::kStop);
  ExpectWord(Read("/7", Asked::kName), LearnWord::kBigger);
  ExpectWord(Read("/go", Asked::kName), LearnWord::kGo);
  ExpectWord(Read("?", Asked::kName), LearnWord::kHelp);
  ExpectWord(Read("word?", Asked::kName), LearnWord::kWord);
  EXPECT_EQ(Read("le", Asked::kName).kind, Kind::kRefused);
}

TEST(LearnWords, StopAndQuitAreNeverAnswers) {
  Course course = SmallCourse();
  course.lessons[0].items = {"stop", "quit"};
  for (const Asked asked : {Asked::kNothing, Asked::kName, Asked::kSame}) {
    ExpectWord(ReadLearnLine("stop", asked, course), LearnWord::kStop);
    ExpectWord(ReadLearnLine("quit", asked, course), LearnWord::kQuit);
  }
}

TEST(LearnWords, StopStopsWhateverElseIsSaid) {
  for (const Asked asked :
       {Asked::kNothing, Asked::kName, Asked::kNumber, Asked::kSame, Asked::kText}) {
    for (const char* line : {"stop now", "Stop, please!", "stop stop stop", "/stop now"}) {
      ExpectWord(Read(line, asked), LearnWord::kStop);
    }
  }
  EXPECT_EQ(Read("Stop the car", Asked::kText).answer, "Stop the car") << "a text of one's own";
}

TEST(LearnWords, SameAndDifferentMayBeBegun) {
  ExpectAnswer(Read("same", Asked::kSame), "same");
  ExpectAnswer(Read("S", Asked::kSame), "s");
  ExpectAnswer(Read("dif", Asked::kSame), "different");
  ExpectWord(Read("smaller", Asked::kSame), LearnWord::kSmaller);
  ExpectWord(Read("7", Asked::kSame), LearnWord::kBigger);
  ExpectAnswer(Read("elephant", Asked::kSame), "elephant");  // which is asked once more
}

}  // namespace
}  // namespace moontrace
