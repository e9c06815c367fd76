#include "lessons/course/likeness.h"

#include <gtest/gtest.h>

#include "lessons/course/course.h"

namespace moontrace {
namespace {

// The families of Moon's nine shapes as they are described, not as this program measures them.
TEST(Likeness, KnowsTheFamiliesOfMoon) {
  const ItemLikeness likeness(LoadCourse("learn-moon"));
  for (const char* pair : {"bj", "fg", "cd", "uw", "em", "ly", "kx", "av", "rs", "pq"}) {
    const std::string a(1, pair[0]), b(1, pair[1]);
    EXPECT_EQ(likeness.Of(a, b), Likeness::kMirrored) << pair;
    EXPECT_EQ(likeness.Of(b, a), Likeness::kMirrored) << pair;
  }
  EXPECT_EQ(likeness.Of("and", "z"), Likeness::kMirrored);
  for (const char* pair : {"it", "nz", "cu", "dw", "bg", "kv", "ax"}) {
    EXPECT_EQ(likeness.Of(std::string(1, pair[0]), std::string(1, pair[1])), Likeness::kTurned)
        << pair;
  }
}

TEST(Likeness, IsOfTheBeginningWhereNothingElseIsAlike) {
  const ItemLikeness likeness(LoadCourse("learn-moon"));
  EXPECT_EQ(likeness.Of("l", "i"), Likeness::kBeginsAlike);  // both go straight down
  EXPECT_EQ(likeness.Of("o", "t"), Likeness::kOther);
  EXPECT_EQ(likeness.Of("tall", "toil"), Likeness::kBeginsAlike);
  EXPECT_EQ(likeness.Of("sand", "flag"), Likeness::kOther);
  EXPECT_EQ(likeness.Of("a", "at"), Likeness::kOther);  // a sign and a word
}

TEST(Likeness, IsToldByTheTextsWhereTheScriptCannotBeHad) {
  Course course;
  course.script = "no-such-script";
  course.lessons.emplace_back();
  course.lessons.back().items = {"b", "j"};
  EXPECT_EQ(ItemLikeness(course).Of("b", "j"), Likeness::kOther);
}

}  // namespace
}  // namespace moontrace
