#include "sim/session/label_walk.h"

#include <gtest/gtest.h>

#include <sstream>

#include "sim/session/place_messages.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

/// The control panel: `panel` says LIFT, the buttons `up`, `down` and `help` their names.
class LabelWalkTest : public testing::Test {
 protected:
  static SessionRequest Request() {
    SessionRequest request;
    request.text.command = "loop";
    request.text.feel.model = SourcePath("models/panel.xml");
    return request;
  }
  std::string name() const {
    for (const LoopSession::LabelOf& label : session_.labels()) {
      if (label.number == session_.label()) return label.name;
    }
    return {};
  }
  int GeomOf(const std::string& wanted) const {
    for (const LoopSession::LabelOf& label : session_.labels()) {
      if (label.name == wanted) return label.carrier;
    }
    return -1;
  }
  LoopSnapshot At(glm::dvec3 tip_P, int geom = -1, double time = 0) const {
    LoopSnapshot now;
    now.page = session_.felt().number;
    now.tip_P = tip_P;
    now.geom = geom;
    now.time = time;
    return now;
  }

  std::istringstream in_;
  std::ostringstream out_, err_;
  Console console_{in_, out_, err_};
  LoopSession session_{Request(), console_};
  LabelWalk walk_{session_};
};

TEST_F(LabelWalkTest, ListsAllAndGoesRound) {
  EXPECT_EQ(walk_.List(),
            (std::vector<std::string>{"4 labels. Say next label, or find and a name.",
                                      "panel, LIFT: you are here.", "up.", "down.", "help."}));
  for (const char* next : {"up", "down", "help", "panel"}) {
    EXPECT_EQ(walk_.Next(), "");
    EXPECT_EQ(name(), next);
  }
  EXPECT_EQ(session_.text().text, "LIFT");
}

TEST_F(LabelWalkTest, FindsByNameByTextAndByAPiece) {
  EXPECT_EQ(walk_.Find("Help", false), "");
  EXPECT_EQ(session_.text().text, "HELP");
  EXPECT_EQ(walk_.Find("lift", false), "");
  EXPECT_EQ(name(), "panel");
  EXPECT_FALSE(walk_.Find("do", false));
  EXPECT_EQ(walk_.Find("do", true), "");
  EXPECT_EQ(name(), "down");
  EXPECT_FALSE(walk_.Find("zebra", true));
  EXPECT_EQ(walk_.Return(), "");
  EXPECT_EQ(name(), "panel");
  EXPECT_EQ(walk_.Return(), "");
  EXPECT_EQ(name(), "help");
  EXPECT_EQ(walk_.Return(), "");
  EXPECT_EQ(name(), "panel");
  EXPECT_FALSE(walk_.Return());
}

// Each is left as it was set, and what was felt on it stays there.
TEST_F(LabelWalkTest, ALabelIsFoundAsItWasLeft) {
  session_.SetSize(0.012, {0, 0});
  walk_.Next();
  EXPECT_DOUBLE_EQ(session_.text().set.style.size, 0.008);
  walk_.Return();
  EXPECT_DOUBLE_EQ(session_.text().set.style.size, 0.012);
  EXPECT_EQ(session_.view_model()->page, session_.label());
}

TEST_F(LabelWalkTest, TellsTheWayOnceTheLabelLiesThere) {
  walk_.Next();
  LoopSnapshot before = At({0, 0, 0});
  before.page = session_.felt().number - 1;
  EXPECT_FALSE(walk_.Arrived(before));
  const auto arrival = walk_.Arrived(At({0, 0, 0}));
  ASSERT_TRUE(arrival);
  EXPECT_EQ(arrival->sentence, "up.");  // the simulated hand goes there by itself
  EXPECT_FALSE(walk_.Arrived(At({0, 0, 0})));
}

TEST(LabelWalkWay, LeadsOutOfTheFaceFirst) {
  EXPECT_EQ(say::WayToLabel("up.", {0.03, -0.004, 0}), "up: 30 mm right, 4 mm down.");
  EXPECT_EQ(say::WayToLabel("up, UP, top.", {0.03, -0.004, 0.0163}),
            "up, UP, top: first 16.3 mm out from its face, then 30 mm right, 4 mm down.");
}

TEST_F(LabelWalkTest, SaysWhatIsTouchedOnceItIsNoAccident) {
  const int up = GeomOf("up"), panel = GeomOf("panel");
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, up, 1.0)), "");
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, up, 1.1)), "");
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, up, 1.2)), "Touched: up.");
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, up, 1.3)), "");
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, -1, 1.4)), "");
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, up, 1.5)), "");
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, up, 2.0)), "");  // the same again
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, panel, 2.1)), "");
  EXPECT_EQ(walk_.TouchedAnew(At({0, 0, 0}, panel, 2.3)), "Touched: panel, LIFT.");
  EXPECT_EQ(walk_.Touched(At({0, 0, 0}, -1)), "");
}

TEST_F(LabelWalkTest, SaysThatAButtonIsPressedOnceEachTime) {
  LoopSnapshot now = At({0, 0, 0}, GeomOf("up"));
  std::vector<std::string> said;
  for (const double gives : {0.3, 0.89, 0.95, 1.0, 0.7, 1.0, 0.4, 0.95}) {
    now.gives = gives;
    said.push_back(walk_.PressedAnew(now));
  }
  EXPECT_EQ(said,
            (std::vector<std::string>{"", "", "Pressed: up.", "", "", "", "", "Pressed: up."}));
}

TEST(LabelWalkPage, HasNothingToSayWithoutAModel) {
  std::istringstream in;
  std::ostringstream out, err;
  Console console(in, out, err);
  SessionRequest request;
  request.text.text.text = "MOON";
  LoopSession session(request, console);
  LabelWalk walk(session);
  EXPECT_EQ(walk.Next(), "No labels here: they are of a model, loop --model FILE.");
  EXPECT_EQ(walk.List(), (std::vector<std::string>{walk.Next()}));
  EXPECT_FALSE(walk.Find("moon", true));
  LoopSnapshot now;
  now.geom = 0;
  now.time = 9;
  EXPECT_EQ(walk.TouchedAnew(now), "");
  EXPECT_EQ(walk.Touched(now), "");
}

}  // namespace
}  // namespace moontrace
