#include "sim/loop/button.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace moontrace {
namespace {

/// Buttons that hold a state for some time.
struct Step {
  std::uint32_t buttons;
  double seconds;
};

/// What was told, as "say@0.452" of the moments at 1 kHz.
std::vector<std::string> Told(const std::vector<Step>& steps, bool hold_to_feel = false) {
  ButtonState state;
  std::vector<std::string> told;
  int n = 0;
  for (const Step& step : steps) {
    const int end = n + static_cast<int>(step.seconds * 1000 + 0.5);
    for (; n < end; ++n) {
      const ButtonAction action = AdvanceButtons(state, step.buttons, n * 0.001, hold_to_feel);
      const char* names[] = {"", "say", "bookmark", "stop"};
      if (action == ButtonAction::kNone) continue;
      told.push_back(fmt::format("{}@{}", names[static_cast<int>(action)], n));
    }
  }
  return told;
}

using Words = std::vector<std::string>;

TEST(Button, ShortPressSaysOnceNoSecondPressHasFollowed) {
  // released at 200 ms; the wait for a second press is over after more than 300 ms
  EXPECT_EQ(Told({{0, 0.1}, {1, 0.1}, {0, 2}}), Words{"say@501"});
}

TEST(Button, DoublePressBookmarksAtItsSecondRelease) {
  // the release at 400 ms counts once it has stood for 10 ms
  EXPECT_EQ(Told({{0, 0.1}, {1, 0.1}, {0, 0.1}, {1, 0.1}, {0, 2}}), Words{"bookmark@410"});
}

TEST(Button, TwoPressesFarApartSayTwice) {
  EXPECT_EQ(Told({{1, 0.1}, {0, 0.5}, {1, 0.1}, {0, 1}}).size(), 2U);
  EXPECT_EQ(Told({{1, 0.1}, {0, 0.5}, {1, 0.1}, {0, 1}})[1].substr(0, 3), "say");
}

TEST(Button, HeldStopsOnceWhileItIsStillHeld) {
  EXPECT_EQ(Told({{0, 0.1}, {1, 3}, {0, 2}}), Words{"stop@500"});
}

TEST(Button, HeldAfterAShortPressStopsToo) {
  // 0.6 - 0.2 falls short of 0.4 by rounding
  EXPECT_EQ(Told({{1, 0.1}, {0, 0.1}, {1, 3}, {0, 2}}), Words{"stop@601"});
}

TEST(Button, JustUnderTheTimeIsNoStop) {
  EXPECT_EQ(Told({{1, 0.398}, {0, 2}})[0].substr(0, 3), "say");
}

TEST(Button, SecondButtonStopsInTheVeryTick) {
  EXPECT_EQ(Told({{0, 0.1}, {2, 0.5}, {0, 1}}), Words{"stop@100"});
  EXPECT_EQ(Told({{1, 0.1}, {3, 0.1}, {0, 1}})[0], "stop@100");
  EXPECT_EQ(Told({{0, 0.1}, {2, 0.5}, {0, 1}}, true), Words{"stop@100"});
  EXPECT_EQ(Told({{2, 0.5}}), Words{"stop@0"});
}

TEST(Button, BounceIsNoPress) {
  std::vector<Step> steps;
  for (int i = 0; i < 4; ++i) steps.insert(steps.end(), {{1, 0.001}, {0, 0.001}});
  steps.push_back({1, 0.1});
  for (int i = 0; i < 4; ++i) steps.insert(steps.end(), {{0, 0.001}, {1, 0.001}});
  steps.push_back({0, 2});
  ASSERT_EQ(Told(steps).size(), 1U);
  EXPECT_EQ(Told(steps)[0].substr(0, 3), "say");
  EXPECT_EQ(Told({{0, 0.1}, {1, 0.009}, {0, 2}}), Words{});  // a spike
}

TEST(Button, HoldToFeelMakesHoldingNoStop) {
  EXPECT_EQ(Told({{1, 5}, {0, 2}}, true), Words{});
  EXPECT_EQ(Told({{1, 0.1}, {0, 2}}, true)[0].substr(0, 3), "say");
  EXPECT_EQ(Told({{1, 0.1}, {0, 0.1}, {1, 0.1}, {0, 2}}, true)[0].substr(0, 8), "bookmark");
}

TEST(Button, FurtherButtonsMeanNothing) { EXPECT_EQ(Told({{0xfffffffcU, 5}, {0, 2}}), Words{}); }

TEST(Button, HeldOverAGapStops) {
  ButtonState state;
  EXPECT_EQ(AdvanceButtons(state, 1, 0, false), ButtonAction::kNone);
  EXPECT_EQ(AdvanceButtons(state, 1, 0.02, false), ButtonAction::kNone);
  EXPECT_EQ(AdvanceButtons(state, 0, 1, false), ButtonAction::kNone);  // may be bounce
  EXPECT_EQ(AdvanceButtons(state, 0, 1.01, false), ButtonAction::kStop);
}

}  // namespace
}  // namespace moontrace
