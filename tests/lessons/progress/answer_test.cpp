#include "lessons/progress/answer.h"

#include <gtest/gtest.h>

#include "tests/lessons/lesson_fixture.h"

namespace moontrace {
namespace {

Course Answerable() {
  Course course = SmallCourse();
  course.lessons[1].items = {"b", "a", "the", ",", ".", "o?", "number", "7"};
  course.names = {{",", "comma"}, {".", "full stop"}, {"o?", "question mark"}, {"7", "Seven"}};
  return course;
}

TEST(Answer, CapitalsBlanksAndWordsBeforeDoNotCount) {
  const Course course = Answerable();
  for (const char* said : {"b", "B", "  b ", "capital b", "letter b", "The letter  B.", "it is b",
                           "b!", "It is the capital letter b?"}) {
    EXPECT_TRUE(Names(course, "b", said)) << said;
    EXPECT_EQ(ItemSaid(course, said, "t"), "b") << said;
  }
  for (const char* said : {"", " ", "c", "bb", "b b", "letter", "not b"}) {
    EXPECT_FALSE(Names(course, "b", said)) << said;
  }
}

TEST(Answer, NamesOfTheCourseAreAnswersBesideTheTexts) {
  const Course course = Answerable();
  EXPECT_TRUE(Names(course, ",", "Comma"));
  EXPECT_TRUE(Names(course, ",", ","));
  EXPECT_TRUE(Names(course, ".", "the full  stop"));
  EXPECT_TRUE(Names(course, ".", "."));
  EXPECT_TRUE(Names(course, "o?", "question mark"));
  EXPECT_TRUE(Names(course, "7", "number seven"));
  EXPECT_FALSE(Names(course, ",", "full stop"));
}

TEST(Answer, ALetterMayBeWrittenAsItIsSpoken) {
  const Course course = Answerable();
  EXPECT_EQ(ItemSaid(course, "bee", {}), "b");
  EXPECT_EQ(ItemSaid(course, "is it the letter Bee?", {}), "b");
  EXPECT_TRUE(Names(course, "t", "tee"));
  EXPECT_TRUE(Names(course, "w", "double u"));
  EXPECT_FALSE(Names(course, "t", "tea")) << "a word";
  Course words = course;
  words.lessons[1].items.emplace_back("bee");
  EXPECT_EQ(ItemSaid(words, "bee", "b"), "bee") << "the item that is called so itself";
  EXPECT_FALSE(Names(words, "b", "bee"));
}

TEST(Answer, WhoIsNotSureIsUnderstoodToo) {
  const Course course = Answerable();
  EXPECT_TRUE(Names(course, "7", "I think it is number 7."));
  EXPECT_TRUE(Names(course, ",", "Maybe a comma"));
  EXPECT_TRUE(Names(course, ",", "I think that comma"));
  EXPECT_FALSE(Names(course, ",", "I know comma"));
}

TEST(Answer, ItemsThatAreWordsOfThemselvesStayWhatTheyAre) {
  const Course course = Answerable();
  EXPECT_EQ(ItemSaid(course, "a", "b"), "a");
  EXPECT_EQ(ItemSaid(course, "the", "b"), "the");
  EXPECT_EQ(ItemSaid(course, "the word the", "b"), "the");
  EXPECT_EQ(ItemSaid(course, "number", "7"), "number");
  EXPECT_EQ(ItemSaid(course, "q", "b"), std::nullopt);
  EXPECT_EQ(ItemSaid(course, std::string(100000, ' '), "b"), std::nullopt);
}

TEST(Answer, WhoDoesNotKnowSaysSoInManyWays) {
  for (const char* said : {"I don't know", "i dont know", "I do not know.", "don\u2019t know",
                           "no idea", "Sorry, I don't know!", "I am not sure", "i give up"}) {
    EXPECT_TRUE(DoesNotKnow(said)) << said;
  }
  for (const char* said : {"", "i", "no", "know", "not", "I know it is t"}) {
    EXPECT_FALSE(DoesNotKnow(said)) << said;
  }
}

TEST(Answer, WhoKnowsMayForgetTheName) {
  for (const char* said : {"I know", "i know.", "Yes, I know it!", "I know that"}) {
    EXPECT_TRUE(KnowsWithoutName(said)) << said;
  }
  for (const char* said : {"", "i", "know", "I don't know", "I know it is t", "I know t"}) {
    EXPECT_FALSE(KnowsWithoutName(said)) << said;
  }
}

TEST(Answer, SameAndDifferentAreToldApart) {
  EXPECT_EQ(SameSaid("Same"), true);
  EXPECT_EQ(SameSaid("the same."), true);
  EXPECT_EQ(SameSaid("s"), true);
  EXPECT_EQ(SameSaid("different"), false);
  EXPECT_EQ(SameSaid("not the same"), false);
  EXPECT_EQ(SameSaid("b"), std::nullopt);
}

}  // namespace
}  // namespace moontrace
