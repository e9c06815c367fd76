#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <tuple>

#include "devices/catalogue/catalogue.h"
#include "lessons/records/records.h"
#include "tests/devices/fake_hid.h"
#include "tests/sim/learn_fixture.h"

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
  EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
  ExpectTextFace(outcome.out);
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

TEST_F(LearnCommand, SaysThatADeviceWithoutMotorsIsNotFelt) {
  const FakeHid fake("spacemouse");
  const std::string name = ListDevices(ProfilesFolder()).at(0).name;
  const Outcome outcome = RunLine({"learn", "--course", In("course"), "--learner", "ann",
                                   "--records", In("records.sqlite"), "--device", name},
                                  "next\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(Holds(outcome.out, "Nothing is felt: this device has no motors.")) << outcome.out;
  EXPECT_TRUE(Holds(outcome.out, "One stroke: from ")) << outcome.out;  // the way, in words
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
