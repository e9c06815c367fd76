#include "lessons/course/spelling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lessons/progress/learning.h"

namespace moontrace {
namespace {

using Items = std::vector<std::string>;

Lesson LessonOf(const std::string& id, Items taught, Items words, double grade) {
  Lesson lesson;
  lesson.id = id;
  lesson.script = "moon";
  lesson.grade = grade;
  lesson.items = std::move(taught);
  Step step;
  step.kind = StepKind::kRecognise;
  step.items = std::move(words);
  Step letters;
  letters.kind = StepKind::kRecognise;
  lesson.steps = {step, letters};
  return lesson;
}

/// Letters and THE of Moon. "bath" is spelled out in the first lesson, and has the sign TH in the
/// second: moon-script's grades 0.5 and 1.
Course Moon() {
  Course course;
  course.script = "moon";
  course.sizes = {0.040, 0.020};
  course.lessons = {LessonOf("out", {"b", "a", "t", "h", "e", "n"}, {"bath"}, 0.5),
                    LessonOf("the", {"the"}, {"bath", "then", "the ant"}, 1),
                    LessonOf("digits", {"1", "2", ","}, {"12,"}, 1)};
  course.names[","] = "comma";
  AddSpellings(course);
  return course;
}

TEST(AddSpellings, TakesTheSignsThatAPageIsWrittenWith) {
  const Course course = Moon();
  EXPECT_EQ(course.lessons[0].spellings.at("bath"), (Items{"b", "a", "t", "h"}));
  EXPECT_EQ(course.lessons[1].spellings.at("bath"), (Items{"b", "a", "the"}));
  EXPECT_EQ(course.lessons[1].spellings.at("then"), (Items{"the", "e", "n"}));
  EXPECT_EQ(course.lessons[1].spellings.at("the ant"), (Items{"the", "a", "n", "t"}));
  EXPECT_EQ(course.lessons[2].spellings.at("12,"), (Items{"1", "2", ","}));
}

TEST(AddSpellings, LeavesACourseWhoseScriptCannotBeHad) {
  Course course;
  course.script = "no-such-script";
  course.lessons = {LessonOf("one", {"a"}, {"aa"}, 1)};
  AddSpellings(course);
  EXPECT_TRUE(course.lessons[0].spellings.empty());
}

Trial Named(const std::string& lesson, const std::string& word) {
  Trial trial;
  trial.lesson = lesson;
  trial.kind = StepKind::kRecognise;
  trial.item = word;
  trial.size = 0.040;
  trial.answer = word;
  trial.right = true;
  return trial;
}

// It gave evidence of T and H, which were not on the page.
TEST(AddSpellings, AWordIsEvidenceOfTheSignsThatWereShown) {
  const Course course = Moon();
  Progress known;
  for (const char* item : {"b", "a", "t", "h", "e", "n", "the"})
    known.items[item].introduced = true;
  const Progress with_sign = Learn(course, known, Named("the", "bath"));
  EXPECT_EQ(with_sign.items.at("the").named.size(), 1U);
  EXPECT_EQ(with_sign.items.at("b").named.size(), 1U);
  EXPECT_TRUE(with_sign.items.at("t").named.empty());
  EXPECT_TRUE(with_sign.items.at("h").named.empty());
  const Progress spelled = Learn(course, known, Named("out", "bath"));
  EXPECT_TRUE(spelled.items.at("the").named.empty());
  EXPECT_EQ(spelled.items.at("t").named.size(), 1U);
  EXPECT_EQ(spelled.items.at("h").named.size(), 1U);
}

// "it" is an item too, but the letters are what a page of "bit" shows.
TEST(AddSpellings, AWordWithinAWordIsNoSign) {
  Course course;
  course.script = "moon";
  course.sizes = {0.040};
  course.lessons = {LessonOf("one", {"b", "i", "t"}, {"it", "bit"}, 1)};
  AddSpellings(course);
  Progress known;
  for (const char* item : {"b", "i", "t", "it"}) known.items[item].introduced = true;
  const Progress progress = Learn(course, known, Named("one", "bit"));
  for (const char* letter : {"b", "i", "t"}) {
    EXPECT_EQ(progress.items.at(letter).named.size(), 1U) << letter;
  }
}

Items ItemsWithName(const std::string& name) {
  Course course = LoadCourse("learn-moon");
  AddOwnName(course, name);
  for (const Lesson& lesson : course.lessons) {
    for (const Step& step : lesson.steps) {
      if (step.own_name) return step.items;
    }
  }
  ADD_FAILURE() << "no step asks for it";
  return {};
}

TEST(AddOwnName, AsksForANameThatTheSignsTaughtCanSpell) {
  const Items without = ItemsWithName("");
  EXPECT_EQ(without, (Items{"rain", "sun", "our", "true"}));
  for (const char* name : {"Tina", "nelli", "ROSA", "Ren\xc3\xa9"}) {  // t i l o n a e s r u
    Items with = without;
    with.emplace_back(name);
    EXPECT_EQ(ItemsWithName(name), with);
  }
  // D and K are not taught yet, two words, too long, an item already, a digit
  for (const char* name : {"Ada", "Kurt", "anna lisa", "annarosalie", "Sun", "r2"}) {
    EXPECT_EQ(ItemsWithName(name), without) << name;
  }
}

TEST(AddOwnName, IsEvidenceOfItsLetters) {
  Course course = LoadCourse("learn-moon");
  AddOwnName(course, "Tina");
  const auto lesson =
      std::find_if(course.lessons.begin(), course.lessons.end(),
                   [](const Lesson& one) { return one.spellings.count("Tina") > 0; });
  ASSERT_NE(lesson, course.lessons.end());
  EXPECT_EQ(lesson->spellings.at("Tina"), (Items{"t", "i", "n", "a"}));
}

}  // namespace
}  // namespace moontrace
