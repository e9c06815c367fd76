#include "lessons/course/course_reader.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/lessons/course_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

TEST(LoadCourse, TakesAShippedNameAFolderAndAFile) {
  const std::string folder = SourcePath("lessons/courses/learn-moon");
  for (const std::string& name : {std::string("learn-moon"), folder, folder + "/course.toml"}) {
    const Course course = LoadCourse(name);
    EXPECT_EQ(course.id, "learn-moon");
    EXPECT_EQ(course.title, "Learn Moon");
    EXPECT_DOUBLE_EQ(course.break_after, 1500);
    ASSERT_FALSE(course.lessons.empty());
    EXPECT_EQ(course.lessons.front().id, "01-t-i");
  }
}

TEST(LoadCourse, NamesTheNearestShippedCourse) {
  try {
    LoadCourse("lern-moon");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown course 'lern-moon'; did you mean learn-moon?");
  }
}

class CourseReader : public CourseFixture {
 protected:
  /// The one line for a course, or a first lesson, in which `what` stands as `by`.
  std::string CourseWith(const std::string& what, const std::string& by) const {
    Write("course", Replaced(kCourse, what, by));
    const std::string faults = Faults();
    Write("course", kCourse);
    return faults;
  }
  std::string LessonWith(const std::string& what, const std::string& by) const {
    Write("one", Replaced(kOne, what, by));
    const std::string faults = Faults();
    Write("one", kOne);
    return faults;
  }
};

TEST_F(CourseReader, ReadsWhatIsThere) {
  Write("course", std::string(kCourse) +
                      "[names]\nt = \"tee\"\n[mastery]\nattempts = 7\n[fade]\nrule = \"linear\"\n");
  const Course course = LoadCourse(folder_.string());
  EXPECT_EQ(course.title, "Little");
  EXPECT_EQ(course.sizes, (std::vector<double>{0.020, 0.010}));
  EXPECT_EQ(course.mastery.attempts, 7);
  EXPECT_EQ(course.mastery.failures, 3) << "what is not said stays as it is";
  EXPECT_EQ(course.fade.rule, "linear");
  EXPECT_EQ(NameOf(course, "t"), "tee");
  EXPECT_EQ(NameOf(course, "i"), "i");
  ASSERT_EQ(course.lessons.size(), 2U);
  const Lesson& two = course.lessons[1];
  EXPECT_EQ(two.id, "two");
  EXPECT_EQ(two.script, "moon") << "the course's";
  EXPECT_EQ(two.items, (std::vector<std::string>{"a"}));
  EXPECT_EQ(two.needs, (std::vector<std::string>{"one"}));
  ASSERT_EQ(two.steps.size(), 2U);
  EXPECT_EQ(two.steps[0].kind, StepKind::kRecognise);
  EXPECT_EQ(two.steps[0].question, Question::kPick);
  EXPECT_DOUBLE_EQ(two.steps[0].size.value(), 0.015);
  EXPECT_FALSE(two.steps[1].size.has_value());
  EXPECT_EQ(two.steps[1].line, 9U);
  EXPECT_EQ(two.places.at("steps[1].items[1]").line, 11U);
  EXPECT_EQ(two.places.at("steps[1].items[1]").column, 15U);
  EXPECT_EQ(course.lessons[0].hints.at("i"), "upright");
}

TEST_F(CourseReader, ReadsALessonBesideTheCourseAndAtHowManySizesAStepIsSure) {
  Write("two",
        "title = \"A\"\noptional = true\nnew = [\"a\"]\n[[steps]]\nkind = \"recognise\"\n"
        "sure_sizes = 3\n");
  Course course = LoadCourse(folder_.string());
  EXPECT_FALSE(course.lessons[0].optional);
  EXPECT_TRUE(course.lessons[1].optional);
  EXPECT_EQ(course.lessons[1].steps[0].sure_sizes, 3);
  EXPECT_EQ(course.mastery.sure_sizes, 2);
  Write("two", "title = \"A\"\nnew = [\"a\"]\n[[steps]]\nkind = \"trace\"\nsure_sizes = 3\n");
  EXPECT_EQ(Faults(),
            "two.toml:5:14: sure_sizes: only of recognise without size_mm; leave it out\n");
  Write("two", "title = \"A\"\nnew = [\"a\"]\n[[steps]]\nkind = \"recognise\"\nsure_sizes = 0\n");
  EXPECT_EQ(Faults(), "two.toml:5:14: sure_sizes: not from 1 to 100; correct it\n");
  Write("two", "title = \"A\"\nnew = [\"a\"]\n[[steps]]\nkind = \"trace\"\nown_name = true\n");
  EXPECT_EQ(Faults(), "two.toml:5:12: own_name: only of recognise by name; leave it out\n");
  Write("two",
        "title = \"A\"\nnew = [\"a\"]\n[[steps]]\nkind = \"trace\"\n"
        "[[steps]]\nkind = \"read\"\ntext = \"a\"\none_page = true\n");
  EXPECT_EQ(Faults(),
            "two.toml:8:12: one_page: only of explore and read with size_mm; leave it out\n");
}

TEST_F(CourseReader, EachBrokenCourseGivesOneLineWithPlaceCauseAndNearestKey) {
  EXPECT_EQ(CourseWith("language =", "lenguage ="),
            "course.toml:1:1: no key 'language'; add it (a string)\n"
            "course.toml:2:1: unknown key 'lenguage'; did you mean 'language'?\n");
  EXPECT_EQ(CourseWith("[20, 10]", "[10, 20]"),
            "course.toml:4:12: sizes_mm: not descending; order them from the largest to the "
            "smallest\n");
  EXPECT_EQ(CourseWith("[20, 10]", "[20, 0.5]"),
            "course.toml:4:12: sizes_mm: not from 1 to 300 mm; correct it\n");
  EXPECT_EQ(CourseWith("\"two\"]", "\"too\"]"),
            "course.toml:5:19: no lesson 'too' beside the course; did you mean 'two'?\n");
  EXPECT_EQ(CourseWith("\"two\"]", "\"one\", \"two\"]"),
            "course.toml:5:19: lesson 'one' is listed twice; leave one out\n");
  EXPECT_EQ(CourseWith("[mates]", "[mastery]\nattemps = 5\n[mates]"),
            "course.toml:7:1: unknown key 'attemps'; did you mean 'attempts'?\n");
  EXPECT_EQ(CourseWith("[mates]", "[mastery]\nrecognised = 85\n[mates]"),
            "course.toml:7:14: recognised: not from 0 to 1; correct it\n");
  EXPECT_EQ(CourseWith("[mates]", "[fade]\nrule = \"gates\"\n[mates]"),
            "course.toml:7:8: rule: unknown 'gates'; did you mean 'gate'? one of manual, linear, "
            "gate, as-needed\n");
  EXPECT_EQ(CourseWith("[mates]", "break_after_min = 0\n[mates]"),
            "course.toml:6:19: break_after_min: not from 1 to 1440; correct it\n");
}

TEST_F(CourseReader, EachBrokenLessonGivesOneLineWithPlaceCauseAndNearestKey) {
  EXPECT_EQ(LessonWith("[hints]", "hint = 1\n[hints]"),
            "one.toml:3:1: unknown key 'hint'; did you mean 'hints'?\n");
  EXPECT_EQ(LessonWith("kind = \"read\"", "kind = \"reed\""),
            "one.toml:8:8: kind: unknown 'reed'; did you mean 'read'? one of explore, demonstrate, "
            "trace, recognise, read, test\n");
  EXPECT_EQ(LessonWith("text = \"it\"", "txt = \"it\""),
            "one.toml:7:1: no key 'text'; add it (a string)\n"
            "one.toml:9:1: unknown key 'txt'; did you mean 'text'?\n");
  EXPECT_EQ(LessonWith("text = \"it\"", "text = \"it\"\nitems = [\"i\"]"),
            "one.toml:10:9: items: not of explore and read; give a text instead\n");
  EXPECT_EQ(LessonWith("text = \"it\"", "text = \"it\"\nsize_mm = -3"),
            "one.toml:10:11: size_mm: not from 1 to 300 mm; correct it\n");
  EXPECT_EQ(LessonWith("text = \"it\"", "text = \"it\"\nsay_held = \"Now.\""),
            "one.toml:10:12: say_held: only beside say; add what is said elsewhere\n");
  EXPECT_EQ(LessonWith("i = \"upright\"", "j = \"upright\""),
            "one.toml:4:5: j: a hint for an item that is not in new; add it there\n");
  EXPECT_EQ(LessonWith("\"i\", \"t\"", "\"i\", \"t t\""),
            "one.toml:2:13: new: 't t' is not one word of 1 to 64 bytes; correct it\n");
  EXPECT_EQ(LessonWith("title = ", "titel = "),
            "one.toml:1:1: no key 'title'; add it (a string)\n"
            "one.toml:1:1: unknown key 'titel'; did you mean 'title'?\n");
  const std::string broken = LessonWith("[hints]", "[hints");
  EXPECT_EQ(broken.substr(0, 27), "one.toml:3:7: broken TOML: ") << broken;
}

TEST_F(CourseReader, GoesOnBehindAFaultAndTellsTheFirstWhenLoading) {
  Write("one", Replaced(Replaced(kOne, "kind = \"read\"", "kind = \"reed\""), "title =", "titl ="));
  Write("two", Replaced(kTwo, "size_mm = 15", "size = 15"));
  EXPECT_EQ(Faults(),
            "one.toml:1:1: no key 'title'; add it (a string)\n"
            "one.toml:8:8: kind: unknown 'reed'; did you mean 'read'? one of explore, demonstrate, "
            "trace, recognise, read, test\n"
            "one.toml:1:1: unknown key 'titl'; did you mean 'title'?\n"
            "two.toml:8:1: unknown key 'size'; did you mean 'size_mm'?\n");
  EXPECT_EQ(LoadError(), File("one") + ":1:1: no key 'title'; add it (a string)");
}

TEST_F(CourseReader, FindsLessonsThatNobodyLists) {
  Write("three", kOne);
  const CourseReading reading = ReadCourse(folder_.string());
  EXPECT_EQ(reading.unlisted, (std::vector<std::string>{File("three")}));
  EXPECT_EQ(LoadError(), "no error") << "a draft beside a course does no harm";
}

TEST_F(CourseReader, RefusesAFolderWithoutACourse) {
  std::filesystem::remove(File("course"));
  EXPECT_NE(LoadError().find("course.toml"), std::string::npos) << LoadError();
}

}  // namespace
}  // namespace moontrace
