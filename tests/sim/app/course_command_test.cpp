#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class CourseCommand : public CliTest {
 protected:
  CourseCommand() {
    WriteAll(In("course.toml"), kCourse);
    WriteAll(In("one.toml"), kOne);
    WriteAll(In("two.toml"), kTwo);
  }
  static constexpr const char* kCourse =
      "title = \"Little\"\nlanguage = \"en\"\nscript = \"moon\"\nsizes_mm = [20, 10]\n"
      "lessons = [\"one\", \"two\"]\n[names]\na = \"ay\"\n";
  static constexpr const char* kOne =
      "title = \"I and T\"\nnew = [\"i\", \"t\"]\n[hints]\ni = \"upright\"\n"
      "[[steps]]\nkind = \"recognise\"\n[[steps]]\nkind = \"read\"\nsay = \"Read.\"\n"
      "text = \"it\"\nsize_mm = 12\n";
  static constexpr const char* kTwo =
      "title = \"A\"\nneeds = [\"one\"]\nnew = [\"a\"]\n[[steps]]\nkind = \"trace\"\n";
};

TEST_F(CourseCommand, SaysThatASoundCourseIsSound) {
  const Outcome outcome = RunLine({"course", "check", folder_.string()});
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out.rfind("Sound: ", 0), 0U) << outcome.out;
  const nlohmann::json counts =
      RunLine({"course", "check", folder_.string(), "--json"}).Json()["courses"][0];
  EXPECT_EQ(counts["lessons"], 2);
  EXPECT_EQ(counts["items"], 3);
  EXPECT_EQ(counts["steps"], 3);
  const Outcome shipped = RunLine({"course", "check", "learn-moon"});
  EXPECT_EQ(shipped.code, 0) << shipped.out;
  EXPECT_EQ(shipped.out.rfind("Sound: learn-moon, ", 0), 0U) << shipped.out;
  ExpectTextFace(shipped.out);
}

TEST_F(CourseCommand, TellsAllFaultsOfAllPathsOneALine) {
  WriteAll(In("one.toml"), std::string(kOne) + "[[steps]]\nkind = \"read\"\ntext = \"a z\"\n");
  const Outcome outcome = RunLine({"course", "check", "learn-moon", In("course.toml")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "");
  const std::vector<std::string> lines = Lines(outcome.out);
  EXPECT_EQ(std::count(lines.begin(), lines.end(),
                       In("one.toml") +
                           ":14:8: 'a' is used before it is taught, in two; do without it here"),
            1)
      << outcome.out;
  EXPECT_EQ(
      std::count(lines.begin(), lines.end(),
                 In("one.toml") +
                     ":14:8: 'z' is used, and no lesson teaches it; add it to the new of one"),
      1)
      << outcome.out;
  EXPECT_EQ(lines.front().rfind("Sound: learn-moon", 0), 0U);
  EXPECT_NE(outcome.out.find("2 faults in"), std::string::npos);
}

TEST_F(CourseCommand, ChecksASingleLessonWithinItsCourse) {
  WriteAll(In("one.toml"), std::string(kOne) + "[[steps]]\nkind = \"read\"\ntext = \"z\"\n");
  EXPECT_EQ(RunLine({"course", "check", In("two.toml")}).out,
            "Sound: lesson two, 1 item taught, 1 step.\n");
  EXPECT_EQ(RunLine({"course", "check", In("one.toml")}).code, 3);
  WriteAll(In("three.toml"), kTwo);
  const Outcome unlisted = RunLine({"course", "check", In("three.toml")});
  EXPECT_EQ(unlisted.code, 3);
  EXPECT_NE(unlisted.out.find(In("three.toml") +
                              ": unreachable: the course does not list 'three'; add it to its "
                              "lessons"),
            std::string::npos)
      << unlisted.out;
}

TEST_F(CourseCommand, ReadsLessonsThatTheCourseDoesNotListYet) {
  WriteAll(In("three.toml"), std::string(kTwo) + "itms = []\n");
  for (const std::string& named : {folder_.string(), In("three.toml")}) {
    const Outcome outcome = RunLine({"course", "check", named});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("2 faults in"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(In("three.toml") + ":6:1: unknown key 'itms'"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(outcome.out.find("Mend these first"), std::string::npos)
        << "letters and order of the listed lessons were looked at";
  }
}

TEST_F(CourseCommand, SaysWhatToMendFirstWhereAFileCannotBeRead) {
  WriteAll(In("one.toml"), "title = \"I and T\n");
  const Outcome outcome = RunLine({"course", "check", folder_.string()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.out.find(In("one.toml") + ":1:"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Mend these first"), std::string::npos);
  EXPECT_EQ(outcome.out.find("'a' is used"), std::string::npos)
      << "what follows from the broken file is no fault of its own";
}

TEST_F(CourseCommand, KnowsWhatSizesADeviceRenders) {
  const Outcome outcome =
      RunLine({"course", "check", folder_.string(), "--device", "sidewinder-ff2"});
  EXPECT_EQ(outcome.code, 3) << outcome.out;
  EXPECT_NE(outcome.out.find("device renders"), std::string::npos) << outcome.out;
  // 13.4 mm: lessons end at 20 of 20 and 10 mm, and that is no fault of theirs.
  const Outcome ends = RunLine({"course", "check", folder_.string(), "--device", "openffboard"});
  EXPECT_EQ(ends.code, 0) << ends.out;
  EXPECT_NE(ends.out.find("Letters end at 20 mm on this device: "), std::string::npos) << ends.out;
  const Outcome unknown = RunLine({"course", "check", "learn-moon", "--device", "openfboard"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.err, "--device: no profile 'openfboard'; did you mean openffboard?\n");
}

TEST_F(CourseCommand, GivesFaultsAsJson) {
  WriteAll(In("two.toml"), std::string(kTwo) + "itms = []\n");
  const Outcome outcome = RunLine({"course", "check", folder_.string(), "--json"});
  EXPECT_EQ(outcome.code, 3);
  const nlohmann::json json = outcome.Json();
  EXPECT_EQ(json["sound"], false);
  const nlohmann::json fault = json["courses"][0]["faults"][0];
  EXPECT_EQ(fault["file"], In("two.toml"));
  EXPECT_EQ(fault["line"], 6);
  EXPECT_EQ(fault["column"], 1);
  EXPECT_EQ(fault["what"], "unknown key 'itms'; did you mean 'items'?");
}

TEST_F(CourseCommand, ShowsWhatACourseTeaches) {
  const Outcome outcome = RunLine({"course", "show", folder_.string()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "Little: 2 lessons, 3 items taught.\n"
            "Letters of 20 and 10 mm, in script moon.\n"
            "one: I and T. 2 steps. Teaches i, t.\n"
            "two: A. 1 step. Teaches ay.\n");
  const Outcome shipped = RunLine({"course", "show"});
  EXPECT_EQ(shipped.code, 0);
  EXPECT_EQ(shipped.out.rfind("Learn Moon: ", 0), 0U) << shipped.out;
  ExpectTextFace(shipped.out);
  EXPECT_EQ(RunLine({"course", "show", "--json"}).Json()["lessons"][1]["new"],
            nlohmann::json::parse(R"(["l", "o"])"));
}

TEST_F(CourseCommand, ShowsALessonStepByStep) {
  const Outcome outcome = RunLine({"course", "show", In("one.toml")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "one: I and T. 2 steps. Teaches i, t.\n"
            "Hint for i: upright\n"
            "Step 1, name: what is new.\n"
            "Step 2, read: it. At 12 mm.\n"
            "Says: Read.\n");
}

TEST_F(CourseCommand, ShowsALessonByItsNumberOrName) {
  for (const char* lesson : {"4", "04-e-s", "e-s", "04"}) {
    const Outcome outcome = RunLine({"course", "show", lesson});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.rfind("04-e-s: E and S. ", 0), 0U) << outcome.out;
    EXPECT_EQ(RunLine({"course", "show", "learn-moon", lesson}).out, outcome.out);
  }
  EXPECT_EQ(RunLine({"course", "show", folder_.string(), "2"}).out.rfind("two: A. ", 0), 0U);
  EXPECT_EQ(RunLine({"course", "show", "5", "--json"}).Json()["lessons"].size(), 1U);
  // a text keeps its own full stop
  EXPECT_EQ(RunLine({"course", "show", "15"}).out.find(".."), std::string::npos);
  const Outcome none = RunLine({"course", "show", "99"});
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.err, "no such lesson: 99; moontrace course show lists them\n");
  EXPECT_EQ(RunLine({"course", "show", "04-e-z"}).err,
            "no such lesson: 04-e-z; did you mean 04-e-s?\n");
}

TEST_F(CourseCommand, RefusesWhatItCannotDoInOneLine) {
  const auto error = [](const std::vector<std::string>& args, int code) {
    const Outcome outcome = RunLine(args);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    return outcome.err;
  };
  EXPECT_EQ(error({"course"}, 2), "course: say what to do: check or show\n");
  EXPECT_EQ(error({"course", "chek", "x"}, 2),
            "course: unknown action \"chek\": did you mean check? write check or show\n");
  EXPECT_EQ(error({"course", "check"}, 2),
            "course check: name a course, as in: moontrace course check learn-moon\n");
  error({"course", "show", "learn-moon", "learn-moon"}, 2);
  error({"course", "show", "--device", "openffboard"}, 2);
  error({"course", "check", ""}, 2);
  EXPECT_EQ(error({"course", "check", "lern-moon"}, 3),
            "unknown course 'lern-moon'; did you mean learn-moon?\n");
  error({"course", "check", In("none.toml")}, 3);
}

}  // namespace
}  // namespace moontrace
