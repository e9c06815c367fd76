#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <tuple>

#include "devices/catalogue/catalogue.h"
#include "lessons/records/records.h"
#include "sim/view/view_window.h"
#include "tests/devices/fake_hid.h"
#include "tests/sim/learn_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

class LearnCommand : public LearnTest {};

bool Holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(LearnCommand, WithoutADeviceSaysSoFirstAndWhatWorks) {
  const Outcome outcome = RunLine({"learn", "--course", In("course"), "--learner", "ann"});
  EXPECT_EQ(outcome.code, 4);
  const std::vector<std::string> lines = Lines(outcome.out);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines[0], "No force device is here: nothing can be felt.");
  EXPECT_TRUE(Holds(outcome.out, "--device simulated"));
  EXPECT_TRUE(Holds(outcome.out, "--print"));
  EXPECT_TRUE(Holds(outcome.out, "--tutor --device simulated --learner NAME"));
  EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
  EXPECT_FALSE(Holds(outcome.err, "orce device")) << "said already: " << outcome.err;
  ExpectTextFace(outcome.out);
}

TEST_F(LearnCommand, RefusesADeviceThatIsNotThereBeforeItAsksWhoLearns) {
  for (const char* device : {"nosuch", "polhem", "plugin:/none"}) {
    const Outcome outcome = RunLine(
        {"learn", "--course", In("course"), "--records", In("records.sqlite"), "--device", device},
        "ann\nquit\n");
    EXPECT_EQ(outcome.code, 4) << device;
    EXPECT_EQ(outcome.out, "") << device;
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
    ExpectOnly({"course"});
  }
}

TEST_F(LearnCommand, OffersNoMouseWithoutADisplayAndRefusesItBeforeItAsksWhoLearns) {
  const char* display = std::getenv("DISPLAY");
  const std::string kept = display == nullptr ? "" : display;
  unsetenv("WAYLAND_DISPLAY");
  setenv("DISPLAY", ":0", 1);
  bool opens = true;  // not where the program was built without windows
  try {
    ViewWindow::RequireDisplayNamed();
  } catch (const LackError&) {
    opens = false;
  }
  const Outcome with = RunLine({"learn", "--course", In("course"), "--learner", "ann"});
  unsetenv("DISPLAY");
  const Outcome without = RunLine({"learn", "--course", In("course"), "--learner", "ann"});
  const Outcome mouse = RunLine({"learn", "--course", In("course"), "--records",
                                 In("records.sqlite"), "--device", "mouse", "--view"},
                                "ann\nquit\n");
  if (display != nullptr) setenv("DISPLAY", kept.c_str(), 1);
  const std::string way = "with a window and sound: moontrace learn --device mouse";  // a line
  EXPECT_EQ(Holds(with.out, "Mouse or pen works, " + way), opens) << with.out;
  EXPECT_TRUE(Holds(without.out, "Mouse or pen works from the desktop, with")) << without.out;
  EXPECT_TRUE(Holds(without.out, "moontrace learn --print lesson.pdf ")) << without.out;
  EXPECT_EQ(mouse.code, 4);
  EXPECT_EQ(mouse.out, "");
  EXPECT_EQ(mouse.err,
            "no window can open here: start it from the desktop, or print a lesson: moontrace "
            "learn --print lesson.pdf\n");
  ExpectOnly({"course"});
}

// It was told once a name had been asked for and kept, in a programmer's words.
TEST_F(LearnCommand, TellsThatNoWindowOpensBeforeItAsksAnything) {
  const char* display = std::getenv("DISPLAY");
  const std::string kept = display == nullptr ? "" : display;
  unsetenv("WAYLAND_DISPLAY");
  unsetenv("DISPLAY");
  std::istringstream in("ann\nquit\n");
  std::ostringstream all;
  Console console(in, all, all);
  const Outcome outcome =
      RunLine({"learn", "--device", "simulated", "--view", "--contrast"}, "quit\n");
  LearnOptions options;
  options.course = In("course");
  options.records = In("records.sqlite");
  options.live.device = "simulated";
  options.view.window = true;
  const int code = moontrace::Run(options, console);
  if (display != nullptr) setenv("DISPLAY", kept.c_str(), 1);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "No window can open here: it goes on without --view.\n");
  EXPECT_EQ(code, 0);
  const std::string first = all.str().substr(0, all.str().find('\n'));
  EXPECT_EQ(first, "No window can open here: it goes on without --view.") << all.str();
  EXPECT_FALSE(Holds(all.str(), "DISPLAY")) << all.str();
}

TEST_F(LearnCommand, SaysThatASimulatedLearnerIsNotKeptWithoutRecords) {
  const std::vector<std::string> args = {"learn",     "--course", In("course"), "--simulate",
                                         "--learner", "sam",      "--days",     "1"};
  const Outcome lost = RunLine(args);
  EXPECT_TRUE(Holds(lost.err, "Nothing is kept: --records FILE keeps it.")) << lost.err;
  const Outcome kept = RunLine(With(args, {"--records", In("r.sqlite")}));
  EXPECT_FALSE(Holds(kept.err, "Nothing is kept")) << kept.err;
}

TEST_F(LearnCommand, LeavesNobodyBehindWhereItCannotStart) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  const Outcome outcome = RunLine({"learn", "--course", In("course"), "--learner", "ann",
                                   "--records", In("records.sqlite"), "--device", "plugin:/none"});
  EXPECT_NE(outcome.code, 0);
  EXPECT_TRUE(Records::Open(In("records.sqlite")).Learners().empty());
}

TEST_F(LearnCommand, TakesSoundsOfOnesOwnWithSoundOnly) {
  const Outcome alone = RunLine(Learn({"--sounds", In("own.toml")}));
  EXPECT_EQ(alone.code, 2);
  EXPECT_EQ(Lines(alone.err).size(), 1U) << alone.err;
  const Outcome missing = RunLine(Learn({"--sound", "--sounds", In("none.toml")}));
  EXPECT_EQ(missing.code, 3);
  EXPECT_EQ(Lines(missing.err).size(), 1U) << missing.err;
  WriteAll(folder_ / "own.toml", "[wrong]\non = false\n");
  EXPECT_EQ(RunLine(Learn({"--sound", "--sounds", In("own.toml")}), "quit\n").code, 0);
}

TEST_F(LearnCommand, RefusesACourseThatGoesRoundInACircle) {
  WriteAll(folder_ / "course" / "one.toml", R"(
title = "First lesson"
needs = ["two"]
new = ["i"]
[[steps]]
kind = "trace"
)");
  const Outcome outcome = RunLine(Learn());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(Holds(outcome.err, "needs go round in a circle")) << outcome.err;
  EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
}

TEST_F(LearnCommand, TakesTheFirstDeviceWithMotors) {
  const FakeHid fake("moontrace-raw");
  const Outcome outcome = RunLine(
      {"learn", "--course", In("course"), "--learner", "ann", "--records", In("records.sqlite")},
      "where\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(Holds(outcome.out, "Device: ")) << outcome.out;
  EXPECT_FALSE(Holds(outcome.out, "nothing is felt")) << outcome.out;
}

// Of this joystick's force and stiffness follow 13.4 mm (SmallestLetter); the course has 16 and 10.
TEST_F(LearnCommand, EndsAtTheSmallestSizeThatTheDeviceRenders) {
  const auto learn = [this](const char* kind) {
    const FakeHid fake(kind);
    return RunLine({"learn", "--course", In("course"), "--learner", "ann", "--records",
                    In("records.sqlite")},
                   "smaller\nquit\n")
        .out;
  };
  const std::string joystick = learn("pid");
  EXPECT_TRUE(
      Holds(joystick, "Letters end at 16 mm here: smaller ones are not clear on this device."))
      << joystick;
  EXPECT_TRUE(Holds(joystick, "No smaller: these are the smallest.")) << joystick;
  EXPECT_FALSE(Holds(learn("moontrace-raw"), "Letters end at"));
}

// A stick that always presses has no height; an arm has one.
TEST_F(LearnCommand, TellsWhoCannotLiftTheTipToSayDone) {
  const auto learn = [this](const char* kind) {
    const FakeHid fake(kind);
    return RunLine({"learn", "--course", In("course"), "--learner", "ann", "--records",
                    In("records.sqlite")},
                   "? all\nquit\n")
        .out;
  };
  const std::string lifts = "followed it all and lift";
  EXPECT_FALSE(Holds(learn("pid"), lifts));
  EXPECT_TRUE(Holds(learn("moontrace-raw"), lifts));
}

TEST_F(LearnCommand, SaysThatADeviceWithoutMotorsIsNotFelt) {
  const FakeHid fake("spacemouse");
  const std::string name = ListDevices(ProfilesFolder()).at(0).name;
  const Outcome outcome = RunLine({"learn", "--course", In("course"), "--learner", "ann",
                                   "--records", In("records.sqlite"), "--device", name},
                                  "next\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(Holds(outcome.out, "Nothing is felt: this device has no motors.")) << outcome.out;
  EXPECT_TRUE(Holds(outcome.out, "The way of i, in words:\nOne stroke: from ")) << outcome.out;
  EXPECT_FALSE(Holds(outcome.out, "be led")) << "by what? " << outcome.out;
  EXPECT_FALSE(Holds(outcome.out, "leads")) << outcome.out;
}

TEST_F(LearnCommand, PrintsALessonInTrueSizeBlackOnWhite) {
  const Outcome outcome =
      RunLine({"learn", "--course", In("course"), "--print", In("page.svg"), "--size-mm", "20"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(Holds(outcome.out, "Printed: First lesson, 1 page, letters of 20 mm."))
      << outcome.out;
  const std::string svg = ReadAll(In("page.svg"));
  EXPECT_TRUE(Holds(svg, "width=\"210mm\"")) << svg.substr(0, 300);
  EXPECT_TRUE(Holds(svg, "#000000") || Holds(svg, "rgb(0,0,0)") || Holds(svg, "\"#000\""));
}

TEST_F(LearnCommand, PrintingEndsWithWhatToTypeNext) {
  const auto last = [this](const std::vector<std::string>& more) {
    std::string out = RunLine(With({"learn", "--print", In("l.pdf")}, more)).out;
    std::replace(out.begin(), out.end(), '\n', ' ');  // long ones are wrapped
    const auto next = out.find("Next: ");
    out.erase(0, next == std::string::npos ? out.find("This is the last") : next);
    return out.substr(0, out.size() - 1);
  };
  EXPECT_EQ(last({}), "Next: moontrace learn --print lesson2.pdf --lesson 2");
  EXPECT_EQ(last({"--lesson", "2"}), "Next: moontrace learn --print lesson3.pdf --lesson 3");
  const std::string course = In("course");
  EXPECT_EQ(last({"--course", course}),
            "Next: moontrace learn --course \"" + course + "\" --print lesson2.pdf --lesson 2");
  EXPECT_EQ(last({"--course", course, "--lesson", "two"}),
            "This is the last lesson. To feel letters with a device: moontrace learn");
}

// "toil" at 40 mm was printed as "toi" and "l".
TEST_F(LearnCommand, PrintsNoBrokenWordButTurnsTheSheetOrTakesSmallerLetters) {
  const auto print = [this](const std::string& size) {
    return RunLine({"learn", "--print", In("l.svg"), "--lesson", "2", "--size-mm", size}).out;
  };
  const std::string turned = print("40");
  EXPECT_TRUE(Holds(turned, "letters of 40 mm.")) << turned;
  EXPECT_TRUE(Holds(turned, "\nLandscape: ")) << turned;
  EXPECT_FALSE(Holds(turned, "Smaller than")) << turned;
  std::string sheets;
  for (const auto& file : std::filesystem::directory_iterator(folder_)) {
    if (file.path().extension() == ".svg") sheets += ReadAll(file.path());
  }
  EXPECT_TRUE(Holds(sheets, "width=\"297mm\""));
  EXPECT_TRUE(Holds(sheets, "toil")) << "the print says what the lines are";
  const std::string smaller = print("80");
  EXPECT_TRUE(Holds(smaller, "letters of 40 mm.")) << smaller;
  EXPECT_TRUE(Holds(smaller, "\nSmaller than 80 mm: ")) << smaller;
  const std::string upright = print("16");
  EXPECT_FALSE(Holds(upright, "Landscape")) << upright;
  ExpectTextFace(turned + smaller);
}

TEST_F(LearnCommand, PrintsTitleNumberMarkAndWhatToDoOnEachSheet) {
  ASSERT_EQ(RunLine({"learn", "--print", In("l.svg"), "--lesson", "2"}).code, 0);
  // Print breaks into lines where it has to.
  const auto print = [this](const std::string& sheet) {
    const std::string svg = ReadAll(In(sheet));
    std::string text;
    for (std::size_t at = svg.find("<text"); at != std::string::npos;
         at = svg.find("<text", at + 1)) {
      const std::size_t from = svg.find('>', at) + 1;
      text += svg.substr(from, svg.find('<', from) - from) + " ";
    }
    return text;
  };
  const std::string second = print("l-2.svg");
  EXPECT_TRUE(Holds(second, "L and O: a corner and a ring, page 2 of ")) << second;
  EXPECT_TRUE(Holds(second, "letters of 40 mm. The slanting line is at the upper right."))
      << second;
  EXPECT_TRUE(Holds(print("l-1.svg"), "Lines: l; o.")) << print("l-1.svg");
  // A line aslant across the corner, 297 - 7 and 7 + 16 mm from the sides; y runs down in SVG.
  const std::string svg = ReadAll(In("l-1.svg"));
  EXPECT_TRUE(Holds(svg, "274,7") && Holds(svg, "290,23")) << svg;
}

TEST_F(LearnCommand, RefusesWhatItCannotDo) {
  const auto refused = [this](const std::vector<std::string>& more, int code) {
    const Outcome outcome = RunLine(With({"learn", "--course", In("course")}, more));
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  };
  refused({"--print", In("page.txt")}, 2);
  EXPECT_TRUE(Holds(RunLine({"learn", "--print", "page.txt"}).err, "--print needs an ending"));
  refused({"--print", In("page.svg"), "--lesson", "oen"}, 2);
  refused({"--print", In("page.svg"), "--simulate"}, 2);
  refused({"--lesson", "one"}, 2);
  refused({"--size-mm", "20"}, 2);

  refused({"--course", In("none")}, 3);
}

TEST_F(LearnCommand, RefusesNamesAndDevicesThatCannotBe) {
  for (const auto& [device, learner, code] :
       {std::tuple{"simulated", "a/b", 3}, std::tuple{"no-such-device", "ann", 4}}) {
    const Outcome outcome = RunLine({"learn", "--course", In("course"), "--records", In("r"),
                                     "--device", device, "--learner", learner});
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_FALSE(outcome.err.empty());
  }
}

TEST_F(LearnCommand, RecordsThatAnotherProgramHasAreOneLine) {
  const Records taken = Records::Open(In("records.sqlite"));
  const Outcome outcome = RunLine(Learn(), "quit\n");
  EXPECT_EQ(outcome.code, 4) << outcome.out;
  EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
}

}  // namespace
}  // namespace moontrace
