#include "sim/app/commands.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "sim/page_view/gl_headless.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_messages.h"
#include "sim/view/view_words.h"
#include "sim/view/viewer.h"
#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

/// Without a display, and with EGL.
class ViewCommand : public CliTest {
 protected:
  ViewCommand() {
    const char* display = std::getenv("DISPLAY");
    if (display != nullptr) display_ = display;
    unsetenv("DISPLAY");
  }
  ~ViewCommand() override {
    if (!display_.empty()) setenv("DISPLAY", display_.c_str(), 1);
  }
  /// A result, or nothing where this machine cannot draw without a display.
  static bool CanDraw(const Outcome& outcome) {
    if (outcome.code == exit_code::kLack) {
      EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
      return false;
    }
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0;
  }
  std::string display_;
};

class SlowViewCommand : public ViewCommand {};

/// Width and height in a PNG's first chunk.
std::pair<int, int> SizeOfPng(const std::string& bytes) {
  const auto number = [&bytes](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
      value = 256 * value + static_cast<int>(static_cast<unsigned char>(bytes[i]));
    }
    return value;
  };
  if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return {0, 0};
  return {number(16), number(20)};
}

TEST_F(ViewCommand, DrawsAPictureOfThePage) {
  const Outcome outcome = RunLine({"view", "moon", "--picture", In("a.png")});
  if (!CanDraw(outcome)) return;
  ExpectTextFace(outcome.out);
  EXPECT_EQ(Lines(outcome.out).back(), In("a.png"));
  EXPECT_EQ(SizeOfPng(ReadAll(In("a.png"))), std::make_pair(1280, 720));
  ExpectOnly({"a.png"});
}

TEST_F(ViewCommand, PictureShowsWhatWasTracedSoFar) {
  const std::vector<std::string> args = {"view", "moon", "--json", "--picture"};
  const Outcome blank = RunLine(With(args, {In("a.png")}));
  if (!CanDraw(blank)) return;
  EXPECT_EQ(blank.Json()["moments"], 0);
  const Outcome traced = RunLine(With(args, {In("b.png"), "--seconds", "2"}));
  ASSERT_EQ(traced.code, 0) << traced.err;
  EXPECT_EQ(traced.Json()["moments"], 500);  // one each 4 ms
  EXPECT_NE(ReadAll(In("a.png")), ReadAll(In("b.png")));
  // simulated time, and a seed: the same picture again
  ASSERT_EQ(RunLine(With(args, {In("c.png"), "--seconds", "2"})).code, 0);
  EXPECT_EQ(ReadAll(In("b.png")), ReadAll(In("c.png")));
}

TEST_F(SlowViewCommand, ContrastAndLargeTextLookOtherwise) {
  const std::vector<std::string> args = {"view", "moon", "--picture"};
  if (!CanDraw(RunLine(With(args, {In("a.png")})))) return;
  ASSERT_EQ(RunLine(With(args, {In("b.png"), "--contrast"})).code, 0);
  ASSERT_EQ(RunLine(With(args, {In("c.png"), "--large-text"})).code, 0);
  EXPECT_NE(ReadAll(In("a.png")), ReadAll(In("b.png")));
  EXPECT_NE(ReadAll(In("a.png")), ReadAll(In("c.png")));
}

TEST_F(ViewCommand, WritesFramesOfARunningLoop) {
  const Outcome outcome =
      RunLine({"view", "moon", "--frames", In("f"), "--seconds", "0.7", "--json"});
  if (!CanDraw(outcome)) return;
  const nlohmann::json json = outcome.Json();
  EXPECT_EQ(json["device"]["name"], "simulated");
  EXPECT_GT(json["view"]["frames"], 0);
  EXPECT_GT(json["view"]["median_frame_ms"], 0);
  EXPECT_LE(json["view"]["median_frame_ms"], json["view"]["slowest_frame_ms"]);
  EXPECT_TRUE(json["view"].contains("median_change_ms"));
  EXPECT_TRUE(json.contains("lateness_us"));
  EXPECT_EQ(SizeOfPng(ReadAll(In("f/frame-00001.png"))), std::make_pair(1280, 720));
}

TEST_F(ViewCommand, HelpHasTheViewsWordsAndColours) {
  const Outcome outcome = RunLine(
      {"loop", "moon", "--device", "simulated", "--frames", In("f"), "--seconds", "0.3"}, "?\n");
  if (!CanDraw(outcome)) return;
  std::string out = outcome.out;
  std::replace(out.begin(), out.end(), '\n', ' ');
  EXPECT_NE(out.find(say::ViewWordsHelp()), std::string::npos) << outcome.out;
  EXPECT_NE(out.find(say::ViewColoursHelp()), std::string::npos) << outcome.out;
  for (const std::string& word : ViewWords()) {
    EXPECT_NE(say::ViewWordsHelp().find(word), std::string::npos) << word;
  }
}

/// Being looked at changes nothing but how long it takes.
TEST_F(SlowViewCommand, ATraceThatIsSeenIsTheSameTrace) {
  const std::vector<std::string> args = {"trace", "i", "--json"};
  const Outcome seen = RunLine(With(args, {"--frames", In("f")}));
  if (!CanDraw(seen)) return;
  nlohmann::json with = seen.Json(), without = RunLine(args).Json();
  EXPECT_GT(with["view"]["frames"], 0);
  with.erase("view");
  with["total"].erase("real_time_factor");
  without["total"].erase("real_time_factor");
  EXPECT_EQ(with, without);
}

TEST_F(SlowViewCommand, AReadingThatIsSeenIsTheSameReading) {
  const std::vector<std::string> args = {"recognise", "i", "--json"};
  const Outcome seen = RunLine(With(args, {"--frames", In("f"), "--width-px", "320"}));
  if (!CanDraw(seen)) return;
  nlohmann::json with = seen.Json(), without = RunLine(args).Json();
  const auto frames = static_cast<int>(30 * with["duration_s"].get<double>());
  EXPECT_NEAR(with["view"]["frames"], frames, 1);
  for (nlohmann::json* json : {&with, &without}) json->erase("real_time_factor");
  with.erase("view");
  EXPECT_EQ(with, without);
}

TEST_F(SlowViewCommand, AReplayThatIsSeenIsEqualToTheBit) {
  ASSERT_EQ(RunLine({"trace", "i", "--record", In("r")}).code, 0);
  const Outcome seen = RunLine({"replay", In("r"), "--check", "--frames", In("f"), "--json"});
  if (!CanDraw(seen)) return;
  EXPECT_EQ(seen.Json()["bit_equal"], true);
  EXPECT_GT(seen.Json()["view"]["frames"], 0);
}

// Frame k is of k / 30 s of the record. The hand moves all the time, so no two are equal; drawn as
// time went by, a busy machine gave the same picture twice and others in the next run.
TEST_F(SlowViewCommand, FramesOfAReplayAreOfItsMomentsToTheByte) {
  ASSERT_EQ(RunLine({"trace", "i", "--record", In("r")}).code, 0);
  const Outcome first = RunLine({"replay", In("r"), "--frames", In("f"), "--json"});
  if (!CanDraw(first)) return;
  ASSERT_EQ(RunLine({"replay", In("r"), "--frames", In("g"), "--contrast"}).code, 0);
  ASSERT_EQ(RunLine({"replay", In("r"), "--frames", In("h")}).code, 0);
  const double seconds = first.Json()["ticks"].get<double>() / 1000;
  const auto count = static_cast<std::size_t>(seconds * 30);
  ASSERT_GT(count, 10U);
  std::string before;
  std::size_t files = 0, others = 0;
  for (const auto& entry : fs::directory_iterator(In("f"))) {
    ++files;
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(ReadAll(In("f/" + name)), ReadAll(In("h/" + name))) << name;
    others += ReadAll(In("f/" + name)) != ReadAll(In("g/" + name)) ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(files), static_cast<double>(count), 1);
  EXPECT_EQ(others, files);
  for (std::size_t k = 1; k <= files; ++k) {
    const std::string picture = ReadAll(In(fmt::format("f/frame-{:05}.png", k)));
    EXPECT_NE(picture, before) << k;
    before = picture;
  }
}

TEST_F(ViewCommand, WithoutADisplaySaysSoInOneLineAndGoesOn) {
  for (const char* command : {"view", "loop"}) {
    const Outcome outcome = RunLine(
        With({command, "moon", "--seconds", "0.2", "--quiet"},
             command[0] == 'l' ? std::vector<std::string>{"--view"} : std::vector<std::string>{}));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<std::string> lines = Lines(outcome.out);
    ASSERT_FALSE(lines.empty()) << outcome.out;
    EXPECT_EQ(lines[0].find("Ran "), 0U) << outcome.out;
  }
  const Outcome told = RunLine({"trace", "i", "--view"});
  EXPECT_EQ(told.code, 0);
  ASSERT_EQ(Lines(told.err).size(), 1U) << told.err;
  ExpectTextFace(told.err);
}

TEST_F(ViewCommand, LacksAWindowWhereNobodySaysAWordEither) {
  const Outcome silent = RunLine({"view", "moon"});
  EXPECT_EQ(silent.code, exit_code::kLack) << silent.out;
  EXPECT_EQ(Lines(silent.err).back().find("nothing was seen"), 0U) << silent.err;
  const Outcome spoken = RunLine({"view", "moon"}, "where\n");
  EXPECT_EQ(spoken.code, 0) << spoken.err;
}

TEST_F(ViewCommand, RefusesInOneLine) {
  WriteAll(In("file"), "");
  const std::pair<std::vector<std::string>, int> lines[] = {
      {{"loop", "o", "--device", "mouse"}, exit_code::kUsage},
      {{"view", "o", "--device", "mouse", "--frames", In("f")}, exit_code::kUsage},
      {{"trace", "o", "--device", "mouse"}, exit_code::kUsage},
      {{"learn", "--device", "mouse", "--learner", "ann", "--records", In("r")}, exit_code::kUsage},
      {{"loop", "o", "--device", "mouse", "--view", "--seconds", "1"}, exit_code::kLack},
      {{"loop", "o", "--view", "--frames", In("f")}, exit_code::kUsage},
      {{"loop", "o", "--contrast"}, exit_code::kUsage},
      {{"trace", "o", "--large-text"}, exit_code::kUsage},
      {{"view", "o", "--picture", In("a.svg")}, exit_code::kUsage},
      {{"view", "o", "--picture", In("a.png"), "--device", "mouse"}, exit_code::kUsage},
      {{"view", "o", "--picture", In("a.png"), "--frames", In("f")}, exit_code::kUsage},
      {{"view", "o", "--picture", In("a.png"), "--rate-hz", "500"}, exit_code::kUsage},
      {{"view", "o", "--view"}, exit_code::kUsage},
      {{"view", "o", "--frames", In("file/x"), "--seconds", "1"}, exit_code::kLack},
  };
  for (const auto& [args, code] : lines) {
    const Outcome outcome = RunLine(args);
    EXPECT_TRUE(outcome.code == code || (!code && outcome.code == exit_code::kLack))
        << args[0] << ' ' << args.back() << ": " << outcome.code << ' ' << outcome.err;
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

TEST_F(ViewCommand, HelpTellsItsOptions) {
  const Outcome help = RunLine({"view", "--help-all"});
  EXPECT_EQ(help.code, 0);
  ExpectTextFace(help.out);
  for (const char* option : {"--picture", "--frames", "--contrast", "--large-text", "--device"}) {
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  }
  for (const char* command : {"loop", "learn", "trace", "replay", "recognise"}) {
    const Outcome other = RunLine({command, "--help-all"});
    EXPECT_NE(other.out.find("--view"), std::string::npos) << command;
    EXPECT_NE(other.out.find("--frames"), std::string::npos) << command;
  }
}

TEST_F(ViewCommand, DrawsAModelAndTellsWhatIsSeen) {
  const std::vector<std::string> args = {"view", "--model", SourcePath("models/mug.xml"),
                                         "--width-px", "320"};
  const Outcome outcome = RunLine(With(args, {"--picture", In("a.png")}));
  if (!CanDraw(outcome)) return;
  ExpectTextFace(outcome.out);
  EXPECT_EQ(SizeOfPng(ReadAll(In("a.png"))), std::make_pair(320, 180));
  EXPECT_NE(outcome.out.find("MORNING TEA on mug, a cylinder: "), std::string::npos);
  EXPECT_NE(outcome.out.find("HOT on handle, a capsule: all of it is seen, "), std::string::npos);
  const Outcome own = RunLine(With(args, {"--picture", In("b.png"), "--camera", "reader"}));
  ASSERT_EQ(own.code, 0) << own.err;
  EXPECT_NE(own.out.find("Seen by the camera reader, "), std::string::npos);
  EXPECT_NE(ReadAll(In("a.png")), ReadAll(In("b.png")));
  const Outcome traced =
      RunLine(With(args, {"--picture", In("c.png"), "--seconds", "1", "--json"}));
  ASSERT_EQ(traced.code, 0) << traced.err;
  EXPECT_NE(traced.Json()["seen"].back().get<std::string>().find("The tip "), std::string::npos);
}

TEST_F(ViewCommand, AnUnknownThingToLookAtIsOneLine) {
  const std::vector<std::string> args = {"view",      "--model",   SourcePath("models/mug.xml"),
                                         "--picture", In("a.png"), "--camera"};
  const Outcome outcome = RunLine(With(args, {"handel"}));
  EXPECT_EQ(outcome.code, exit_code::kInput);
  EXPECT_EQ(Lines(outcome.err).back(),
            "the model has nothing named 'handel' to look at: did you mean handle?");
  EXPECT_FALSE(fs::exists(In("a.png")));
  const Outcome page = RunLine({"view", "moon", "--picture", In("a.png"), "--camera", "reader"});
  EXPECT_EQ(page.code, exit_code::kUsage);
  EXPECT_EQ(page.err, "--camera needs --model beside it\n");
}

TEST_F(ViewCommand, ARoundLabelIsFeltInTheView) {
  const Outcome outcome = RunLine({"view", "--model", SourcePath("models/mug.xml"), "--frames",
                                   In("f"), "--width-px", "320", "--seconds", "0.2"});
  if (!CanDraw(outcome)) return;
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Running: simulated stylus."), std::string::npos) << outcome.out;
  EXPECT_TRUE(fs::exists(In("f/frame-00001.png")));  // how many more, the machine decides
}

}  // namespace
}  // namespace moontrace
