#include "sim/learn/key_wording.h"

#include <gtest/gtest.h>

#include "lessons/course/course.h"
#include "sim/console/line_wrap.h"
#include "sim/learn/learn_keys.h"
#include "sim/learn/learn_messages.h"
#include "textures/base/resources.h"

namespace moontrace {
namespace {

std::string With(std::string_view sentence) { return WithKeys(sentence, UsualKeys()); }

TEST(KeyWording, TellsTheKeyOfAWordThatIsToBeSaid) {
  EXPECT_EQ(With("Feel the page; say next to go on."), "Feel the page; press n to go on.");
  EXPECT_EQ(With("Say stop, typed with Enter, and every push ends at once."),
            "Press Escape, and every push ends at once.");
  EXPECT_EQ(With("When your hand knows it, say next."), "When your hand knows it, press n.");
  EXPECT_EQ(With("The word go brings it back."), "The key g brings it back.");
  EXPECT_EQ(With("The word next leaves a sign for later."), "The key n leaves a sign for later.");
  EXPECT_EQ(With("Your turn: trace, then lift or say done; next leaves it."),
            "Your turn: trace, then lift or press d; n leaves it.");
  EXPECT_EQ(With("You talk to me with short words: again, where, more help."),
            "You talk to me with short words: again r, where w, more help right bracket.");
  EXPECT_EQ(With("Unknown: x. Say ? for the words."), "Unknown: x. ? tells the keys.");
}

TEST(KeyWording, LeavesAnswersAndWordsWithoutAKey) {
  for (const char* line :
       {"What is it? Say its name.", "Say which lesson: lesson 5.", "Feel it, then say the letter.",
        "Tutor says: hello, next time", "Wrong: it is the word it, you said t.",
        "Still asked: an answer, or the word next."}) {
    EXPECT_EQ(With(line), line);
  }
}

// Each word that a lesson's text tells the learner to say or type has become a key.
TEST(KeyWording, ReachesAllTextsOfTheCourse) {
  const Course course = LoadCourse(ResourcePath("lessons/courses/learn-moon"));
  for (const Lesson& lesson : course.lessons) {
    for (const Step& step : lesson.steps) {
      for (const std::string& text : {step.say, step.say_held}) {
        for (const std::string& line : Sentences(text)) {
          const std::string told = With(line);
          for (const char* word : {"next", "done", "stop", "go", "again", "hint", "where"}) {
            for (const char* begin : {"say ", "Say ", "type ", "Type ", "word "}) {
              EXPECT_EQ(told.find(std::string(begin) + word + " "), std::string::npos) << told;
              EXPECT_EQ(told.find(std::string(begin) + word + "."), std::string::npos) << told;
              EXPECT_EQ(told.find(std::string(begin) + word + ","), std::string::npos) << told;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace moontrace
