#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>
#include <thread>

#include "tests/devices/fake_hid.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DevicesCommand, SaysPlainlyThatThereIsNoneAndWhatWorksWithout) {
  const FakeHid fake("");
  const Outcome outcome = RunLine({"devices"});
  EXPECT_EQ(outcome.code, exit_code::kGood);
  EXPECT_EQ(outcome.out.rfind("no device found", 0), 0u);
  EXPECT_TRUE(Has(outcome.out, "simulated stylus"));
  EXPECT_TRUE(Has(outcome.out, "moontrace learn --device simulated"));
  EXPECT_EQ(RunLine({"devices", "list"}).out, outcome.out);
  ExpectTextFace(outcome.out);
  EXPECT_EQ(RunLine({"devices", "--json"}).Json()["devices"].size(), 0u);
}

TEST(DevicesCommand, TheProgramsOwnHandHasNothingToTest) {
  const Outcome outcome = RunLine({"devices", "test", "simulated"});
  EXPECT_EQ(outcome.code, exit_code::kUsage);
  EXPECT_TRUE(Has(outcome.err, "the program's own hand")) << outcome.err;
}

// The files of devices/profiles, whatever is plugged in.
TEST(DevicesCommand, ListsTheKnownProfilesApartFromWhatIsPluggedIn) {
  for (const char* plugged : {"", "pid"}) {
    const FakeHid fake(plugged);
    const Outcome outcome = RunLine({"devices"});
    EXPECT_TRUE(Has(outcome.out, "9 kinds are known, plugged in or not:\n")) << outcome.out;
    EXPECT_TRUE(Has(outcome.out, "\nwoodenhaptics: WoodenHaptics arm, letters read from 4 mm.\n"));
    EXPECT_TRUE(Has(outcome.out,
                    "\nsidewinder-ff2: Microsoft SideWinder Force Feedback 2, letters read from "
                    "14 mm.\n"));
    EXPECT_TRUE(Has(outcome.out, "\nspacemouse: 3Dconnexion puck.\n"));  // it gives no force
    ExpectTextFace(outcome.out);
    const auto json = RunLine({"devices", "--json"}).Json();
    EXPECT_EQ(json["devices"].size(), *plugged == 0 ? 0u : 1u);
    ASSERT_EQ(json["profiles"].size(), 9u);
    EXPECT_EQ(json["profiles"][2]["name"], "openffboard");
    EXPECT_EQ(json["profiles"][2]["title"], "OpenFFBoard joystick");
    EXPECT_NEAR(json["profiles"][2]["read_letter_mm"], 12, 1e-9);
  }
}

TEST(DevicesCommand, TellsWhatADeviceCanDo) {
  const FakeHid fake("pid,spacemouse");
  const Outcome outcome = RunLine({"devices"});
  EXPECT_EQ(outcome.code, exit_code::kGood);
  EXPECT_EQ(outcome.out.rfind("2 devices found, all can be opened", 0), 0u) << outcome.out;
  // The figures of openffboard.toml.
  EXPECT_TRUE(Has(outcome.out, "pushes along x and y: up to 5 N for a moment, 2 N for ever"));
  EXPECT_TRUE(Has(outcome.out, "workspace of 140 by 140 mm"));
  EXPECT_TRUE(Has(outcome.out, "lets go by itself 50 ms"));
  EXPECT_TRUE(Has(outcome.out, "It pushes nothing"));
  ExpectTextFace(outcome.out);
}

TEST(DevicesCommand, GivesTheSameAsJson) {
  const FakeHid fake("pid");
  const auto json = RunLine({"devices", "--json"}).Json();
  ASSERT_EQ(json["devices"].size(), 1u);
  const auto& device = json["devices"][0];
  EXPECT_EQ(device["name"], "openffboard");
  EXPECT_TRUE(device["problem"].is_null());
  EXPECT_EQ(device["pushes"], "xy");
  EXPECT_EQ(device["peak_force_n"], 5);
  EXPECT_EQ(device["dead_man_ms"], 50);
  // openffboard.toml: 2 b / T with b = 3 N s/m, T = 2 ms + 2 x 2 ms is 1000 N/m; the maker's 500
  // N/m is the least.
  EXPECT_EQ(device["stable_stiffness_n_per_m"], 500);
  EXPECT_GT(device["smallest_letter_mm"], 0);
  EXPECT_GE(device["read_letter_mm"], 10);
  EXPECT_LE(device["read_letter_mm"], 22);
  EXPECT_NE(
      RunLine({"devices"}).out.find("The smallest letters that a simulated reader reads on it"),
      std::string::npos);
  // fine steps: as stiff as it holds, damped to 0.7 of critical for a proxy of 50 g
  EXPECT_EQ(device["coupling_stiffness_n_per_m"], 500);
  EXPECT_NEAR(device["coupling_damping_ns_per_m"], 1.4 * std::sqrt(0.05 * 500), 1e-9);
  EXPECT_NEAR(device["position_step_um"], 18, 1e-9);
  EXPECT_NE(RunLine({"devices"}).out.find("felt through a spring of 500 N/m"), std::string::npos);
}

TEST(DevicesCommand, TellsWhichDevicesAreGuardedAndWhyOneIsNot) {
  {
    const FakeHid fake("pid,spacemouse,woodenhaptics");
    const Outcome outcome = RunLine({"devices"});
    EXPECT_TRUE(Has(outcome.out, "Guarded: when Moontrace dies or hangs")) << outcome.out;
    EXPECT_TRUE(Has(outcome.out, "Not guarded: it has no force.")) << outcome.out;
    for (const auto& device : RunLine({"devices", "--json"}).Json()["devices"]) {
      EXPECT_EQ(device["guarded"], device["name"] != "spacemouse") << device;
      EXPECT_EQ(device["not_guarded_because"].is_null(), device["guarded"].get<bool>());
    }
  }
  const FakeHid fake("pid", "refused");
  EXPECT_TRUE(Has(RunLine({"devices"}).out, "Not guarded: it cannot be opened."));
}

TEST(DevicesCommand, TellsTheUdevLineUnbroken) {
  const FakeHid fake("pid", "refused");
  const Outcome outcome = RunLine({"devices"});
  EXPECT_EQ(outcome.out.rfind("1 device found, 0 can be opened", 0), 0u) << outcome.out;
  EXPECT_TRUE(Has(outcome.out,
                  "cannot be opened: no permission (OpenFFBoard joystick)\n"
                  "To mend that, put this line\n"
                  "KERNEL==\"hidraw*\",SUBSYSTEM==\"hidraw\",KERNELS==\"*:1209:FFB0.*\","
                  "TAG+=\"uaccess\"\n"
                  "into the file\n"
                  "/etc/udev/rules.d/70-moontrace-hid.rules\n"
                  "then, as root, say\n"
                  "udevadm control --reload-rules\n"
                  "and plug the device in again.\n"))
      << outcome.out;
  const Outcome loop = RunLine({"loop", "a", "--device", "openffboard"});
  EXPECT_EQ(loop.code, exit_code::kLack);
  EXPECT_EQ(loop.err,
            "openffboard: /dev/hidraw-fake0: no permission: \"moontrace devices\" tells how to "
            "give it\n");
  ExpectTextFace(outcome.out);
}

TEST(DevicesCommand, TellsWhoseWordTheFiguresAre) {
  {
    const FakeHid fake("moontrace-raw,pid");
    const Outcome outcome = RunLine({"devices"});
    EXPECT_TRUE(Has(outcome.out, "It says of itself:")) << outcome.out;
    EXPECT_TRUE(Has(outcome.out, "Its profile says, and nothing was measured:")) << outcome.out;
    const auto json = RunLine({"devices", "--json"}).Json();
    EXPECT_EQ(json["devices"][0]["figures_from"], "device");
    EXPECT_EQ(json["devices"][1]["figures_from"], "profile");
  }
  const FakeHid fake("moontrace-raw", "refused");
  const Outcome outcome = RunLine({"devices"});
  EXPECT_TRUE(Has(outcome.out, "Its profile says, and it was not asked:")) << outcome.out;
  EXPECT_EQ(RunLine({"devices", "--json"}).Json()["devices"][0]["figures_from"], "profile");
}

TEST(DevicesCommand, TestOfWhatIsNotThereLacksIt) {
  const FakeHid fake("pid");
  const Outcome outcome = RunLine({"devices", "test", "openfboard"});
  EXPECT_EQ(outcome.code, exit_code::kLack);
  EXPECT_TRUE(Has(outcome.err, "did you mean openffboard?")) << outcome.err;
  EXPECT_EQ(Lines(outcome.err).size(), 1u);
}

TEST(DevicesCommand, WrongWordsAreAUsageError) {
  const FakeHid fake("");
  EXPECT_EQ(RunLine({"devices", "tset", "x"}).code, exit_code::kUsage);
  EXPECT_EQ(RunLine({"devices", "test"}).code, exit_code::kUsage);
  EXPECT_EQ(RunLine({"devices", "test", "a", "b"}).code, exit_code::kUsage);
  EXPECT_EQ(RunLine({"devices", "test", "plugin:"}).code, exit_code::kLack);
}

TEST(DevicesCommand, PluginThatOthersMayWriteIsRefusedWithTheCure) {
  const FakeHid fake("");
  std::string folder = "/tmp/moontrace-XXXXXX";
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::string file = folder + "/arm.so";
  WriteAll(file, "nothing");
  std::filesystem::permissions(file, std::filesystem::perms(0666));
  const Outcome outcome = RunLine({"devices", "test", "plugin:" + file});
  EXPECT_EQ(outcome.code, exit_code::kLack);
  EXPECT_TRUE(Has(outcome.err, "chmod go-w " + file)) << outcome.err;
  std::filesystem::remove_all(folder);
}

TEST(SlowDevicesCommand, TestInAPipeLooksAndPushesNothing) {
  const FakeHid fake("pid");
  const Outcome outcome = RunLine({"devices", "test", "openffboard"});
  EXPECT_EQ(outcome.code, exit_code::kGood) << outcome.err;
  EXPECT_TRUE(Has(outcome.out, "Position: x from"));
  EXPECT_TRUE(Has(outcome.out, "No fault found, but not all was tried: 1 step good, 3 left out."));
  ExpectTextFace(outcome.out);
  for (const FakeHid::Line& line : fake.Log("force")) {
    for (const double force : line.force) EXPECT_EQ(force, 0);
  }
}

TEST(SlowDevicesCommand, TestPushesGentlyWhereSomebodyAnswers) {
  const FakeHid fake("pid");
  // Agreement, four directions, agreement to the dead-man, gone.
  const Outcome outcome =
      RunLine({"devices", "test", "openffboard"}, "yes\nyes\nyes\nyes\nyes\nyes\nyes\n");
  EXPECT_EQ(outcome.code, exit_code::kGood) << outcome.err;
  EXPECT_TRUE(Has(outcome.out, "Passed: 4 steps good.")) << outcome.out;
  bool pushed = false;
  for (const FakeHid::Line& line : fake.Log("force")) {
    for (const double force : line.force) {
      EXPECT_LE(std::abs(force), 0.5 + 1e-3);  // a step on the wire is 10 N / 32767
      pushed = pushed || std::abs(force) > 0.4;
    }
  }
  EXPECT_TRUE(pushed);
}

TEST(SlowDevicesCommand, TestOfADeviceThatIsUnpluggedFails) {
  const FakeHid fake("pid", "unplug@1000");
  const Outcome outcome = RunLine({"devices", "test", "openffboard"});
  EXPECT_EQ(outcome.code, exit_code::kFailed);
  EXPECT_TRUE(Has(outcome.out, "the device was lost")) << outcome.out;
}

TEST(SlowDevicesCommand, TestHomesAnArmByWords) {
  const FakeHid fake("woodenhaptics");
  const Outcome outcome = RunLine({"devices", "test", "woodenhaptics"}, "yes\nno\n");
  EXPECT_EQ(outcome.code, exit_code::kGood) << outcome.err;
  EXPECT_TRUE(Has(outcome.out, "Step 1: homing."));
  EXPECT_TRUE(Has(outcome.out, "No fault found, but not all was tried: 2 steps good, 3 left out."))
      << outcome.out;
}

}  // namespace
}  // namespace moontrace
