#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "lessons/course/course.h"
#include "tests/lessons/course_fixture.h"

namespace moontrace {
namespace {

class CourseCheck : public CourseFixture {};

TEST_F(CourseCheck, FindsNothingInASoundCourse) { EXPECT_EQ(Faults(0.010), ""); }

TEST_F(CourseCheck, RefusesAnUntaughtLetterInATextAndSaysWhereItIsTaught) {
  Write("one", Replaced(kOne, "text = \"it\"", "text = \"It at Q\""));
  EXPECT_EQ(Faults(),
            "one.toml:9:8: 'a' is used before it is taught, in two; do without it here\n"
            "one.toml:9:8: 'Q' is used, and no lesson teaches it; add it to the new of one\n");
}

TEST_F(CourseCheck, RefusesAnUntaughtLetterWithinAWord) {
  Write("two", Replaced(kTwo, "\"tait\"", "\"taint\""));
  EXPECT_EQ(Faults(),
            "two.toml:11:15: 'n' is used, and no lesson teaches it; add it to the new of one\n");
}

TEST_F(CourseCheck, RefusesAContractionWhoseSignIsNotTaught) {
  // All letters of "and" are, but a page of grade 1 writes the word as one sign.
  const std::string three =
      Replaced(Replaced(kTwo, "[\"a\"]", "[\"a\", \"n\", \"d\"]"), "[\"a\", \"tait\"]",
               "[\"a\", \"n\", \"d\", \"and\", \"tait\"]");
  Write("two", three);
  EXPECT_EQ(Faults(),
            "two.toml:11:25: 'and' is used, and no lesson teaches it; add it to the new of one\n");
  Write("two", Replaced(three, "needs =", "grade = 0.5\nneeds ="));
  EXPECT_EQ(Faults(), "") << "spelled out";
}

TEST_F(CourseCheck, RefusesANumberWhoseNumeralSignIsNotTaught) {
  Write("two", Replaced(kTwo, "\"tait\"", "\"1\""));
  EXPECT_EQ(Faults(),
            "two.toml:11:15: '1' is used, and no lesson teaches it; add it to the new of one\n");
}

TEST_F(CourseCheck, FindsWhatIsTaughtTwice) {
  Write("two", Replaced(Replaced(kTwo, "[\"a\"]", "[\"a\", \"T\"]"), "\"tait\"", "\"T\""));
  EXPECT_EQ(Faults(), "two.toml:3:13: 'T' is taught twice, first in one; leave it out here\n");
}

TEST_F(CourseCheck, FindsWhatIsTaughtButNeverShown) {
  Write("two", Replaced(kTwo, "new = [\"a\"]", "new = [\"a\", \"o\"]"));
  EXPECT_EQ(Faults(),
            "two.toml:3:13: 'o' is taught but no step shows it; add it to a step's items\n");
}

TEST_F(CourseCheck, FindsCharactersWithoutAForm) {
  Write("one", Replaced(kOne, "text = \"it\"", "text = \"it \u2603\""));
  const std::string faults = Faults();
  EXPECT_EQ(
      faults.rfind("one.toml:9:8: '\u2603' has no form in script moon; write it otherwise", 0), 0U)
      << faults;
}

TEST_F(CourseCheck, FindsNeedsInACircle) {
  Write("one", Replaced(kOne, "new =", "needs = [\"two\"]\nnew ="));
  EXPECT_EQ(Faults(),
            "one.toml:2:10: unreachable: needs go round in a circle: one needs two needs one; take "
            "out 'two', which does not come before\n");
}

// Each lesson of it told the circle.
TEST_F(CourseCheck, TellsACircleOnceByItsNeedOfALaterLesson) {
  Course course;
  const std::vector<std::pair<std::string, std::vector<std::string>>> needs = {
      {"a", {}}, {"b", {"a", "d"}}, {"c", {"b"}}, {"d", {"c"}}, {"e", {"d", "e"}}};
  for (const auto& [id, needed] : needs) {
    course.lessons.emplace_back();
    course.lessons.back().id = id;
    course.lessons.back().needs = needed;
  }
  std::vector<std::string> told;
  for (const CourseFault& fault : CheckReach(course)) told.push_back(fault.what);
  EXPECT_EQ(told, (std::vector<std::string>{
                      "unreachable: needs go round in a circle: b needs d needs c needs b; take "
                      "out 'd', which does not come before",
                      "unreachable: needs go round in a circle: e needs e; take out 'e', which "
                      "does not come before"}));
}

TEST_F(CourseCheck, SuchACourseIsNotBegun) {
  Write("one", Replaced(kOne, "new =", "needs = [\"two\"]\nnew ="));
  EXPECT_EQ(LoadError(), File("one") +
                             ":2:10: unreachable: needs go round in a circle: one needs two needs "
                             "one; take out 'two', which does not come before");
  Write("one", Replaced(kOne, "new =", "needs = [\"twoo\"]\nnew ="));
  EXPECT_NE(LoadError().find("unreachable: it needs 'twoo'"), std::string::npos) << LoadError();
}

TEST_F(CourseCheck, FindsLessonsThatCannotBeReached) {
  Write("one", Replaced(kOne, "new =", "needs = [\"twoo\"]\nnew ="));
  EXPECT_EQ(Faults(),
            "one.toml:2:10: unreachable: it needs 'twoo', no lesson of the course; did you mean "
            "'two'?\n"
            "two.toml:2:9: unreachable: what it needs is unreachable itself; mend that\n");
}

TEST_F(CourseCheck, HoldsToTheOrderOfNeedsNotOfTheList) {
  // two comes first in the list, but needs one: it may use what one teaches.
  Write("course", Replaced(kCourse, "[\"one\", \"two\"]", "[\"two\", \"one\"]"));
  EXPECT_EQ(Faults(), "");
}

// Smaller sizes were faults, though lessons end at the smallest one that is rendered.
TEST_F(CourseCheck, FindsACourseOfWhoseSizesADeviceRendersNone) {
  EXPECT_EQ(Faults(0.016), "");
  EXPECT_EQ(
      Faults(0.25),
      "course.toml:4:13: 20 mm is below the 250 mm that the device renders; make it larger\n");
  EXPECT_EQ(Faults(std::numeric_limits<double>::infinity()),
            "course.toml:4:13: the device renders letters of no size; choose another device\n");
}

TEST_F(CourseCheck, FindsALessonWithoutSteps) {
  Write("one", "title = \"I and T\"\nnew = [\"i\", \"t\"]\n");
  EXPECT_EQ(Faults(), "one.toml: the lesson has no steps; add [[steps]]\n");
}

TEST_F(CourseCheck, FindsMatesThatCannotBeAsked) {
  Write("two", Replaced(kTwo, "items = [\"t\"]", "items = [\"a\"]"));
  EXPECT_EQ(Faults(),
            "two.toml:7:10: 'a' has no mate to be asked against; name one under mates in the "
            "course\n");
  Write("two", kTwo);
  Write("one", Replaced(kOne, "kind = \"recognise\"",
                        "kind = \"recognise\"\nquestion = \"pick\"\nitems = [\"t\"]\n[[steps]]\n"
                        "kind = \"trace\""));
  Write("course", Replaced(kCourse, "t = \"i\"", "t = \"a\""));
  EXPECT_EQ(Faults(),
            "one.toml:8:10: the mate of 't' is 'a', which is not taught by now; ask it later\n");
}

TEST_F(CourseCheck, FindsNamesOfNothing) {
  Write("course", Replaced(kCourse, "t = \"i\"", "t = \"i\"\n[names]\ntaite = \"x\""));
  EXPECT_EQ(Faults(),
            "course.toml:9:9: names: 'taite' is no item of any lesson; did you mean 'tait'?\n");
}

TEST_F(CourseCheck, FindsAScriptOrGradeThatIsNotThere) {
  Write("two", Replaced(kTwo, "needs =", "grade = 3\nneeds ="));
  EXPECT_EQ(Faults(), "two.toml:2:9: script moon has no grade 3; give one of 0.5, 1, 2\n");
  Write("two", Replaced(kTwo, "needs =", "script = \"mooon\"\nneeds ="));
  EXPECT_EQ(Faults().rfind("two.toml:2:10: ", 0), 0U) << Faults();
}

TEST_F(CourseCheck, LetsSkillsComeBeforeLetters) {
  Write("one", std::string("script = \"shapes\"\ntitle = \"Lines\"\n[[steps]]\nkind = \"trace\"\n"
                           "items = [\"\u2500\", \"\u2502\"]\n"));
  Write("two", "title = \"A\"\nnew = [\"i\", \"t\"]\n[[steps]]\nkind = \"trace\"\n");
  EXPECT_EQ(Faults(), "");
}

}  // namespace
}  // namespace moontrace
