#include "sim/session/loop_session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <sstream>
#include <thread>

#include "sim/session/tip_words.h"
#include "sim/trial/trial.h"
#include "tests/source_path.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

class LoopSessionTest : public ::testing::Test {
 protected:
  static SessionRequest Request() {
    SessionRequest request;
    request.text.text.text = "MOON\nMOON";
    request.text.style.size = 0.02;
    return request;
  }
  static LoopSnapshot TipAt(glm::dvec3 tip_P) {
    LoopSnapshot now;
    now.tip_P = tip_P;
    return now;
  }

  std::istringstream in_;
  std::ostringstream out_, err_;
  Console console_{in_, out_, err_};
  LoopSession session_{Request(), console_};
};

TEST_F(LoopSessionTest, SaysTheWayToTheBookmark) {
  const glm::dvec2 letter_P = session_.text().set.pages[0].glyphs[1].origin_P;
  const auto mark = LetterPlaceOf(session_.felt(), {letter_P.x + 0.004, letter_P.y + 0.010});
  EXPECT_EQ(WayToMark(session_, mark, TipAt({letter_P.x, letter_P.y + 0.0125, 0})),
            "Bookmark at O, page 1 of 1: 4 mm right, 2.5 mm down.");
}

TEST_F(LoopSessionTest, TheBookmarkStaysAtItsPlaceOfTheLetterAtAnotherSize) {
  const glm::dvec2 before_P = session_.text().set.pages[0].glyphs[1].origin_P;
  const auto mark = LetterPlaceOf(session_.felt(), {before_P.x + 0.004, before_P.y + 0.010});
  session_.Resize(true, before_P.x * glm::dvec3(1, 0, 0));
  const glm::dvec2 letter_P = session_.text().set.pages[0].glyphs[1].origin_P;
  // a quarter larger: 5 mm and 12.5 mm from the letter's origin
  EXPECT_EQ(WayToMark(session_, mark, TipAt({letter_P.x, letter_P.y, 0})),
            "Bookmark at O, page 1 of 1: 5 mm right, 12.5 mm up.");
}

TEST_F(LoopSessionTest, TakesAnyFormAndSizeAndKeepsThemTogether) {
  const TypeStyle before = session_.text().set.style;
  PageForm form;
  form.depth = 0.5;
  form.paper = PaperKind::kGrid;
  session_.SetForm(form, {0, 0});
  EXPECT_EQ(session_.form(), form);
  EXPECT_DOUBLE_EQ(session_.text().set.style.depth, 0.5 * before.depth);
  session_.SetSize(0.01, {0, 0});
  const TypeStyle& style = session_.text().set.style;
  EXPECT_DOUBLE_EQ(style.size, 0.01);
  EXPECT_DOUBLE_EQ(style.depth, 0.5 * before.depth / 2);  // of letters half as large
  ASSERT_TRUE(style.texture.paper);
  EXPECT_EQ(style.texture.paper->kind, PaperKind::kGrid);
  session_.Tilt(0.2);
  EXPECT_EQ(session_.tilt(), 0.2);
}

TEST_F(LoopSessionTest, StaysAsItWasWhereAFormCannotBe) {
  const PageForm before = session_.form();
  PageForm form;
  form.h_form = "star";
  EXPECT_THROW(session_.SetForm(form, {0, 0}), InputError);
  EXPECT_EQ(session_.form(), before);
  EXPECT_THROW(session_.SetSize(1, {0, 0}), InputError);  // no room on A4
  EXPECT_DOUBLE_EQ(session_.text().set.style.size, 0.02);
}

// The text can be set, and only the loop refuses its page: grooves twice as deep are too steep for
// this friction.
TEST(LoopSessionPage, StaysAsItWasWhereItCannotBeFelt) {
  std::istringstream in;
  std::ostringstream out, err;
  Console console(in, out, err);
  SessionRequest request;
  request.text.text.text = "MOON\nMOON";
  request.text.style.size = 0.02;
  request.text.feel.scene.friction = 0.3;
  LoopSession session(request, console);
  const FeltPage before = session.felt();
  const PageForm form_before = session.form();
  PageForm deep = form_before;
  deep.depth = 2;
  EXPECT_THROW(session.SetForm(deep, {0, 0}), InputError);
  EXPECT_EQ(session.felt().text, before.text);
  EXPECT_EQ(session.felt().field, before.field);
  EXPECT_EQ(session.felt().shown, before.shown);
  EXPECT_EQ(session.form(), form_before);
  EXPECT_DOUBLE_EQ(session.text().set.style.size, 0.02);
  session.SetSize(0.01, {0, 0});
  EXPECT_DOUBLE_EQ(session.text().set.style.size, 0.01);
  EXPECT_EQ(session.form(), form_before);
}

TEST_F(LoopSessionTest, ReadsTheHandOnce) {
  // a data folder that has the scripts, but no devices/hand.toml
  const std::filesystem::path data = std::filesystem::path(testing::TempDir()) / "no_hand";
  std::filesystem::remove_all(data);
  std::filesystem::create_directories(data);
  std::filesystem::create_directory_symlink(SourcePath("textures"), data / "textures");
  setenv("MOONTRACE_DATA", data.c_str(), 1);
  EXPECT_THROW(ShippedHand(), LackError);
  EXPECT_NO_THROW(session_.SetSize(0.01, {0, 0}));
  unsetenv("MOONTRACE_DATA");
  EXPECT_DOUBLE_EQ(session_.text().set.style.size, 0.01);
}

/// Looks until something is seen, at most 20 s.
template <typename Seen>
bool Until(LoopSession& session, Seen seen) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  LoopSnapshot now;
  while (std::chrono::steady_clock::now() < end) {
    if (session.loop().TakeSnapshot(now) && seen(now)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

class SlowLoopSession : public LoopSessionTest {};

TEST_F(SlowLoopSession, AHandThatRanOnWhileAllRestedBeginsAnewAndNothingJumps) {
  double stopped_at = 0;
  ASSERT_TRUE(Until(session_, [](const LoopSnapshot& now) { return now.depth > 0; }));
  session_.loop().Stop();
  ASSERT_TRUE(Until(session_, [&](const LoopSnapshot& now) {
    stopped_at = now.time;
    return now.stopped;
  }));
  // long enough that the hand is letters away
  ASSERT_TRUE(Until(session_, [&](const LoopSnapshot& now) { return now.time > stopped_at + 5; }));
  session_.GoOn();
  ASSERT_TRUE(Until(session_, [](const LoopSnapshot& now) { return !now.stopped; }));
  const double rested_until = stopped_at + 5;
  EXPECT_TRUE(
      Until(session_, [&](const LoopSnapshot& now) { return now.time > rested_until + 3; }));
  LoopEvent event;
  while (session_.loop().TakeEvent(event)) {
    if (event.time < rested_until) continue;  // unheld, it may spring
    EXPECT_FALSE(event.kind == LoopEventKind::kSafety && event.safety == SafetyEvent::kJump);
  }
}

TEST(LoopSessionForm, BeginsAsTheCommandLineHasIt) {
  std::istringstream in;
  std::ostringstream out, err;
  Console console(in, out, err);
  SessionRequest request;
  request.text.text.text = "MOON";
  request.text.layout.sheet.texture = "noise";
  LoopSession session(request, console);
  EXPECT_EQ(session.form().paper, PaperKind::kNoise);
  PageForm form = session.form();
  form.depth = 0.5;
  session.SetForm(form, {0, 0});
  EXPECT_TRUE(session.text().set.style.texture.paper);
}

TEST_F(LoopSessionTest, WithoutABookmarkItSaysHowToSetOne) {
  EXPECT_EQ(WayToMark(session_, std::nullopt, TipAt({0, 0, 0})),
            "No bookmark yet: press the button twice to set one.");
}

}  // namespace
}  // namespace moontrace
