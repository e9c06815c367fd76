#include "sim/app/loop_session.h"

#include <gtest/gtest.h>

#include <sstream>

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
  session_.SetMark({letter_P.x + 0.004, letter_P.y + 0.010, 0});
  EXPECT_EQ(session_.WayToMark(TipAt({letter_P.x, letter_P.y + 0.0125, 0})),
            "Bookmark at O, page 1 of 1: 4 mm right, 2.5 mm down.");
}

TEST_F(LoopSessionTest, TheBookmarkStaysAtItsPlaceOfTheLetterAtAnotherSize) {
  const glm::dvec2 before_P = session_.text().set.pages[0].glyphs[1].origin_P;
  session_.SetMark({before_P.x + 0.004, before_P.y + 0.010, 0});
  session_.Resize(true, before_P.x * glm::dvec3(1, 0, 0));
  const glm::dvec2 letter_P = session_.text().set.pages[0].glyphs[1].origin_P;
  // a quarter larger: 5 mm and 12.5 mm from the letter's origin
  EXPECT_EQ(session_.WayToMark(TipAt({letter_P.x, letter_P.y, 0})),
            "Bookmark at O, page 1 of 1: 5 mm right, 12.5 mm up.");
}

TEST_F(LoopSessionTest, WithoutABookmarkItSaysHowToSetOne) {
  EXPECT_EQ(session_.WayToMark(TipAt({0, 0, 0})),
            "No bookmark yet: press the button twice to set one.");
}

}  // namespace
}  // namespace moontrace
