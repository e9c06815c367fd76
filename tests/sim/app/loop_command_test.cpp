#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include "sim/session/loop_messages.h"
#include "tests/devices/fake_hid.h"
#include "tests/devices/plugin_fixture.h"
#include "tests/sim/cli_fixture.h"
#include "tests/sim/eventually.h"
#include "tests/sim/pty_fixture.h"

namespace moontrace {
namespace {

class LoopCommand : public CliTest {};
class LoopTerminal : public CliTest {};  // nothing of it depends on real time

bool Holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(LoopCommand, TellsItsFigures) {
  const Outcome outcome = RunLine({"loop", "LO", "--seconds", "1", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = outcome.Json();
  EXPECT_GT(json["ticks"], 100);
  EXPECT_GE(json["lost_ticks"], 0);
  for (const char* what : {"lateness_us", "cost_us"}) {
    EXPECT_LE(json[what]["p50"], json[what]["p99"]);
    EXPECT_LE(json[what]["p99"], json[what]["p999"]);
    EXPECT_LE(json[what]["p999"], json[what]["max"]);
  }
  EXPECT_TRUE(json["realtime"] == true || json["realtime"].is_string());
  EXPECT_EQ(json["device"]["name"], "simulated");
  EXPECT_GT(json["touching"], 0.0);
  EXPECT_EQ(json["safety"].size(), 13U);
  EXPECT_EQ(json["safety"]["jump"], 0);
  EXPECT_EQ(json["samples_dropped"], 0);
}

TEST_F(LoopCommand, SaysThemInPlainLines) {
  const Outcome outcome = RunLine({"loop", "--seconds", "0.3"});
  EXPECT_EQ(outcome.code, 0);
  ExpectTextFace(outcome.out);
  ExpectTextFace(outcome.err);
  // nobody chose the text: its first line says what is felt, and how to choose
  EXPECT_EQ(outcome.out.rfind("On the page: the moon is bright. No text was given;", 0), 0U)
      << outcome.out;
  EXPECT_TRUE(Holds(outcome.out, "Running: simulated stylus."));
  EXPECT_TRUE(Holds(outcome.out, "Ran "));
  // nobody feels it: no force, no figures of it, no ticks
  for (const char* not_here : {"orce", "tick", " late", "second", "priority"}) {
    EXPECT_FALSE(Holds(outcome.out + outcome.err, not_here)) << outcome.out << outcome.err;
  }
}

TEST_F(LoopCommand, SaysWhatIsOnThePage) {
  const Outcome outcome = RunLine({"loop", "full moon", "--seconds", "0.1"});
  EXPECT_EQ(outcome.out.rfind("On the page: full moon\n", 0), 0U) << outcome.out;
  EXPECT_TRUE(Holds(RunLine({"loop", "--help"}).out, "Default the model's, else \"the moon"));
}

TEST_F(LoopCommand, QuietLeavesOutWhatGoesOnButNoAnswerAndNoLossOfForce) {
  const Outcome outcome = RunLine({"loop", "MOON", "--page", "60x40", "--size-mm", "20", "--quiet"},
                                  "stop\ngo\nwhere\nquit\n");
  EXPECT_EQ(outcome.err, "");
  for (const char* left_out : {"On the page", "Running", "Going on"}) {
    EXPECT_FALSE(Holds(outcome.out, left_out)) << outcome.out;
  }
  EXPECT_TRUE(Holds(outcome.out, ", page 1 of")) << outcome.out;  // where
  EXPECT_TRUE(Holds(outcome.out, "Stopped. Say go")) << outcome.out;
  EXPECT_TRUE(Holds(outcome.out, "Ran ")) << outcome.out;
}

TEST_F(LoopCommand, WhereTellsThatItIsStopped) {
  const say::Feeling stopped{false, true, true, 0};
  EXPECT_EQ(say::Where("m", 0, 0, 1, stopped), "At m, line 1, page 1 of 1, in the air; stopped.");
}

TEST_F(LoopCommand, ObeysWordsUntilQuit) {
  const Outcome outcome = RunLine({"loop", "MOON", "--page", "60x40", "--size-mm", "20"},
                                  "?\nwhere\nnext\nback\nback\nbigger\nsmaller\ns\nfly\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  ExpectTextFace(outcome.out);
  EXPECT_TRUE(Holds(outcome.out, "1 stop, 2 next, 3 where, 7 bigger"));
  EXPECT_TRUE(Holds(outcome.out, "Page 2 of")) << outcome.out;
  EXPECT_TRUE(Holds(outcome.out, "This is the first page."));
  EXPECT_TRUE(Holds(outcome.out, "s could be stop, smaller, size or spacing."));
  EXPECT_TRUE(Holds(outcome.out, "Unknown: fly."));
  // 40 mm less two margins of 10 hold letters of 20 mm and none that are a quarter larger
  EXPECT_TRUE(Holds(outcome.out, "The size stays:")) << outcome.out;
  EXPECT_TRUE(Holds(outcome.out, "Letters of 16 mm")) << outcome.out;
}

TEST_F(LoopCommand, ChangesThePageWhileItIsFelt) {
  const Outcome outcome =
      RunLine({"loop", "OH", "--page", "120x90", "--size-mm", "20"},
              "size 10 mm\ndepth 50 %\nwidth 120 %\nspacing 120 %\npitch 150 %\ntilt 10\nembossed\n"
              "engraved\nform arc\nform star\npaper sine\npaper smooth\nsize 900\ndepth 9\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  ExpectTextFace(outcome.out);
  for (const char* told :
       {"Letters of 10 mm, page 1 of 1", "Depth 50 percent of", "Width 120 percent", "Spaces 120",
        "Lines apart 150 percent", "Page tilted by 10 degrees.", "Embossed,", "Engraved,",
        "H has the form arc.", "Stays as it was: script moon has no h 'star'", "Paper sine.",
        "Paper smooth.", "Stays as it was: ", "No depth 9, out of range: it wants 20 to 200 %."}) {
    EXPECT_TRUE(Holds(outcome.out, told)) << told << "\n" << outcome.out;
  }
}

TEST_F(LoopCommand, TellsTheChangedPageInItsFigures) {
  const Outcome outcome =
      RunLine({"loop", "OH", "--page", "120x90", "--size-mm", "20", "--json"},
              "size 10 mm\ndepth 50 %\nwidth 120 %\ntilt 10\nform arc\npaper sine\nquit\n");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = outcome.Json();
  EXPECT_EQ(json["size_mm"], 10);
  // 0.1165 em wide and half as deep, times 1.2, and the depth times 0.5
  EXPECT_NEAR(json["width_mm"], 1.2 * 1.165, 1e-9);
  EXPECT_NEAR(json["depth_mm"], 0.5 * 1.2 * 1.165 / 2, 1e-9);
  EXPECT_NEAR(json["tilt_deg"], 10, 1e-9);
  EXPECT_EQ(json["h_form"], "arc");
  EXPECT_EQ(json["texture"]["kind"], "sine");
}

TEST_F(LoopCommand, StopsWhenAskedAndTellsIt) {
  const Outcome outcome = RunLine({"loop", "--seconds", "0.5"}, "stop\n");
  EXPECT_TRUE(Holds(outcome.out, "Stopped. Say go to go on.")) << outcome.out;
}

TEST_F(LoopCommand, EndsInOrderWhenInterrupted) {
  const std::atomic<bool> stop{true};
  const Outcome outcome = RunLine({"loop"}, "", &stop);
  EXPECT_EQ(outcome.code, 130);
}

TEST_F(LoopCommand, RefusesWhatItCannotDo) {
  EXPECT_EQ(RunLine({"loop", "--rate-hz", "100"}).code, 2);
  EXPECT_EQ(RunLine({"loop", "--scale", "2"}).code, 2);
  const Outcome none = RunLine({"loop", "--device", "no-such-device"});
  EXPECT_EQ(none.code, 4);
  EXPECT_EQ(Lines(none.err).size(), 1U) << none.err;
}

TEST_F(LoopCommand, TraceRefusesOptionsOfTheOtherKind) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--seed", "2"}, {"--speed-mm-s", "20"}, {"--record", In("r")}}) {
    const Outcome outcome = RunLine(With({"trace", "LO", "--device", "x"}, options));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(Holds(outcome.err, options[0] + " is for the simulated stylus")) << outcome.err;
  }
  EXPECT_EQ(RunLine({"trace", "LO", "--seconds", "2"}).code, 2);
}

std::string NameOfFake() {
  const Outcome outcome = RunLine({"devices", "--json"});
  return outcome.Json()["devices"][0]["name"];
}

/// What the device was last commanded.
std::vector<double> LastForce(const FakeHid& fake) {
  const std::vector<FakeHid::Line> forces = fake.Log("force");
  return forces.empty() ? std::vector<double>{} : forces.back().force;
}

TEST_F(LoopCommand, LetsEmulatedDevicesFeelThePage) {
  for (const char* kind : {"moontrace-raw", "pid", "spacemouse"}) {
    const FakeHid fake(kind);
    const std::string name = NameOfFake();
    const Outcome outcome =
        RunLine({"loop", "MOON", "--device", name, "--seconds", "1.5", "--json", "--size-mm", "6"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json json = outcome.Json();
    EXPECT_EQ(json["device"]["name"], name);
    EXPECT_EQ(json["safety"]["device_lost"], 0) << kind;
    EXPECT_EQ(json["size_mm"], 6);  // true size, whatever the device reaches
    const nlohmann::json& reach = json["device"]["workspace_mm"][0];
    if (reach.is_number()) {
      EXPECT_LE(json["paper"]["width_mm"], reach);
    }
    for (const double force : LastForce(fake)) EXPECT_EQ(force, 0) << kind;
  }
}

TEST_F(LoopCommand, SaysThatADeviceWithoutMotorsIsNotFelt) {
  const FakeHid fake("spacemouse");
  const Outcome outcome = RunLine({"loop", "MOON", "--device", NameOfFake(), "--seconds", "0.3"});
  EXPECT_TRUE(Holds(outcome.out, "This device has no motors: forces are told, not felt."))
      << outcome.out;
}

TEST_F(LoopCommand, GoesOnAfterReplugging) {
  const FakeHid fake("moontrace-raw", "replug@500");
  const Outcome outcome =
      RunLine({"loop", "MOON", "--device", NameOfFake(), "--seconds", "4", "--size-mm", "6"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(Holds(outcome.out, "Device lost: no force.")) << outcome.out;
  EXPECT_TRUE(Holds(outcome.out, "Device back: force comes slowly.")) << outcome.out;
}

TEST_F(LoopCommand, EndsWithItsInputUnlessItHasATime) {
  const Outcome outcome = RunLine({"loop", "MOON"}, "where\n");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(Holds(outcome.err, "End of input")) << outcome.err;
  EXPECT_TRUE(Holds(outcome.out, "Ran ")) << outcome.out;
  const Outcome timed = RunLine({"loop", "MOON", "--seconds", "0.3", "--json"}, "");
  EXPECT_GE(timed.Json()["seconds"], 0.25);
}

TEST_F(LoopCommand, EndsQuietlyOnceNobodyTakesWhatItSays) {
  std::istringstream in("where\n");
  std::ostringstream out, err;
  Console console(in, out, err);
  out.setstate(std::ios::badbit);
  EXPECT_EQ(RunCli({"loop", "MOON", "--seconds", "60"}, console), 4);  // a stream without a reader
}

TEST_F(LoopCommand, BringsALineBackAtATerminalAndPrintsNoArrow) {
  SKIP_WITHOUT_TERMINALS();
  PtySession session({"loop", "MOON", "--page", "60x40", "--size-mm", "20"});
  ASSERT_TRUE(session.WaitFor("? tells the words.")) << session.all();
  ASSERT_TRUE(session.Ask("back")) << session.all();
  session.Send("\x1b[C\x1b[A\n");
  EXPECT_TRUE(session.WaitFor("This is the first page.")) << session.all();
  session.Send("quit\n");
  EXPECT_EQ(session.Wait(), 0);
  EXPECT_TRUE(session.terminal_is_usual());
  ExpectStream(session.all());
  EXPECT_EQ(session.all().find("[A"), std::string::npos) << session.all();
}

TEST_F(LoopTerminal, IsGivenBackEvenWhereTheProgramIsKilled) {
  SKIP_WITHOUT_TERMINALS();
  PtySession session({"loop", "MOON"});
  ASSERT_TRUE(session.WaitFor("? tells the words.")) << session.all();
  EXPECT_TRUE(Eventually([&] { return !session.echoes(); }));
  session.Kill(SIGKILL);
  EXPECT_TRUE(Eventually([&] { return session.terminal_is_usual(); }));
}

TEST_F(LoopCommand, SaysOnceWhatHappensAgainAndAgainAndSumsItUp) {
  EXPECT_TRUE(say::MayRepeat(SafetyEvent::kLateLoop));
  EXPECT_TRUE(say::MayRepeat(SafetyEvent::kRateCap));
  EXPECT_FALSE(say::MayRepeat(SafetyEvent::kDeviceLost));
  EXPECT_EQ(say::Event(SafetyEvent::kLateLoop, true),
            "No force for a moment: the computer was late. From now on this is counted.");
  std::array<std::uint64_t, kSafetyEvents> counts{};
  counts[static_cast<std::size_t>(SafetyEvent::kRateCap)] = 1;
  EXPECT_EQ(say::Repeated(counts), "");  // has been said
  counts[static_cast<std::size_t>(SafetyEvent::kLateLoop)] = 6;
  counts[static_cast<std::size_t>(SafetyEvent::kStopped)] = 2;  // asked for, and said each time
  EXPECT_EQ(say::Repeated(counts), "In all: the computer was late 6 times.");
}

TEST_F(LoopCommand, SaysNothingOfForceWhereNothingIsFelt) {
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    const auto event = static_cast<SafetyEvent>(i);
    if (event == SafetyEvent::kDeviceLost) continue;  // said of what pushes only
    EXPECT_FALSE(Holds(say::Event(event, false), "orce")) << say::Event(event, false);
  }
  EXPECT_EQ(say::Event(SafetyEvent::kLateLoop, false), "");
  EXPECT_EQ(say::Event({LoopEventKind::kWentOn}, false), "Going on.");
}

class LoopWithPlugin : public PluginTest {};

TEST_F(LoopWithPlugin, TellsWhyItWasLost) {
  const Outcome outcome =
      RunLine({"loop", "MOON", "--device", "plugin:" + Plugin("nan_position"), "--seconds", "2"});
  EXPECT_TRUE(Holds(outcome.out,
                    "Device lost: no force: the plug-in gave a position or velocity that is no\n"
                    "number. It is looked for twice a second.\n"))
      << outcome.out;
}

// From the words to the tip's place: a hand without a will of its own ends where it was led.
TEST_F(LoopWithPlugin, LeadsAHandToWhatIsFoundAndBack) {
  SKIP_WITHOUT_TERMINALS();
  PtySession session(
      {"loop", "I\nT\nLTNOT\nI\nI", "--size-mm", "20", "--device", "plugin:" + Plugin("loose")});
  const auto comes_to = [&session](const std::string& letter) {
    for (int i = 0; i < 50; ++i) {
      session.ReadFor(100);
      session.Send("where\n");
      if (!session.WaitFor("line 3")) return false;
      if (session.all().rfind("At " + letter + ", line 3") != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(comes_to("N")) << session.all();  // it begins in the page's middle
  session.Send("find o\n");
  EXPECT_TRUE(session.WaitFor("o, 1 of 1: ")) << session.all();
  EXPECT_TRUE(comes_to("O")) << session.all();
  session.ReadFor(1000);  // nothing draws it back
  session.Send("return\n");
  EXPECT_TRUE(session.WaitFor("Back at N: ")) << session.all();
  session.ReadFor(2500);
  session.Send("return\n");
  EXPECT_TRUE(session.WaitFor("You are back already.")) << session.all();
  session.Send("where\n");
  EXPECT_TRUE(session.WaitFor("At N, line 3")) << session.all();
  session.Send("quit\n");
  EXPECT_EQ(session.Wait(), 0);
}

TEST_F(LoopCommand, ATraceWithADeviceIsScored) {
  const FakeHid fake("moontrace-raw");
  const Outcome outcome = RunLine(
      {"trace", "MOON", "--device", NameOfFake(), "--seconds", "1", "--json", "--scale", "2"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = outcome.Json();
  EXPECT_EQ(json["scale"], 2);
  EXPECT_EQ(json["letters"].size(), 4U);
  EXPECT_GE(json["total"]["coverage"], 0.0);
  EXPECT_GT(json["total"]["duration_s"], 0.0);
}

}  // namespace
}  // namespace moontrace
