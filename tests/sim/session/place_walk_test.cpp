#include "sim/session/place_walk.h"

#include <gtest/gtest.h>

#include <sstream>

#include "sim/session/place_messages.h"
#include "tests/devices/fake_hid.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

using Places = std::vector<std::size_t>;

TEST(PlaceWalkText, IsFoundWithoutCapitalsAndAcrossLineEnds) {
  EXPECT_EQ(Occurrences("The moon. MOON, moons", "moon"), (Places{4, 10, 16}));
  EXPECT_EQ(Occurrences("full\n  moon, Full moon", "full moon"), (Places{0, 13}));
  EXPECT_EQ(Occurrences("caf\xc3\x89 caf\xc3\xa9", "CAF\xc3\x89"), (Places{0, 6}));
  EXPECT_EQ(Occurrences("aaaa", "aa"), (Places{0, 2}));
  EXPECT_EQ(Occurrences("moon", "sun"), Places{});
  EXPECT_EQ(Occurrences("moon", " \n"), Places{});
  EXPECT_EQ(Occurrences("", "a"), Places{});
  EXPECT_EQ(Occurrences("a\xff\xfe z", "z"), Places{4});  // broken bytes are no other letter's
}

TEST(PlaceWalkSentences, HaveTheirOutcomeFirst) {
  EXPECT_EQ(say::PlaceIs("moon, 2 of 5", 1, 3, 0, glm::dvec2(0.012, -0.003)),
            "moon, 2 of 5: page 2 of 3, line 1, 12 mm right, 3 mm down.");
  EXPECT_EQ(say::PlaceIs("", 0, 1, 3, glm::dvec2(-0.02, 0)), "Line 4, 20 mm left.");
  EXPECT_EQ(say::PlaceIs("", 0, 2, 0, glm::dvec2(0, 0)), "Page 1 of 2, line 1, under the tip.");
}

/// On a device whose tip a test puts where it likes: of two pages, whose letters are 12 mm high.
class PlaceWalkTest : public ::testing::Test {
 protected:
  static SessionRequest Request() {
    SessionRequest request;
    request.text.text.text = "IT\nLOT\n# TOIL\nIT\nNOT IT";
    request.text.style.structure = true;
    request.text.style.size = 0.012;
    request.live.device = RunLine({"devices", "--json"}).Json()["devices"][0]["name"];
    return request;
  }
  /// The tip rests just within a letter, or off its corner by `off_P` [m]. (At the corner itself it
  /// is as near to the letter before.)
  LoopSnapshot At(std::size_t page, std::size_t glyph, glm::dvec2 off_P = {0.001, 0.001}) const {
    LoopSnapshot now;
    now.tip_P = glm::dvec3(Set(page).glyphs.at(glyph).origin_P + off_P, 0);
    now.page = session_.felt().number;
    return now;
  }
  const TextPage& Set(std::size_t page) const { return session_.text().set.pages.at(page); }
  /// A word said with the tip there, which stays.
  std::string Say(PlaceWord word, const std::string& text, LoopSnapshot now) {
    const std::string refusal = walk_.Go({word, text}, now);
    if (!refusal.empty()) return refusal;
    now.page = session_.felt().number;
    const auto arrival = walk_.Arrived(now);
    EXPECT_FALSE(walk_.Arrived(now)) << "told twice";
    if (!arrival) return "nothing was told";
    place_P_ = arrival->place_P;
    return arrival->sentence;
  }

  FakeHid fake_{"moontrace-raw"};
  std::istringstream in_;
  std::ostringstream out_, err_;
  Console console_{in_, out_, err_};
  LoopSession session_{Request(), console_};
  std::vector<std::size_t> turned_;
  PlaceWalk walk_{session_, [this](std::size_t page) {
                    turned_.push_back(page);
                    session_.TurnTo(page);
                  }};
  glm::dvec2 place_P_{0, 0};
};

TEST_F(PlaceWalkTest, FindsFromTheTipOnAndCounts) {
  const std::size_t pages = session_.text().set.pages.size();
  ASSERT_GT(pages, 1U);
  // from the second letter of "LOT": the next IT stands behind the heading
  std::string said = Say(PlaceWord::kFind, "it", At(0, 3));
  EXPECT_EQ(said.rfind("it, 2 of 3: page ", 0), 0U) << said;
  said = Say(PlaceWord::kFindNext, "", At(0, 0));
  EXPECT_EQ(said.rfind("it, 3 of 3: page ", 0), 0U) << said;
  EXPECT_EQ(session_.felt().index, pages - 1);  // the last word of the text
  said = Say(PlaceWord::kFindNext, "", At(pages - 1, 0));
  EXPECT_EQ(said.rfind("it, 1 of 3: page 1 of ", 0), 0U) << said;  // round again
  EXPECT_EQ(session_.felt().index, 0U);
  EXPECT_EQ(turned_.back(), 0U);
}

TEST_F(PlaceWalkTest, SaysTheWayFromTheTip) {
  // I of "IT", found from 10 mm left of its corner and 4 mm nearer: its middle is half its height
  // up, and a quarter of it to the right
  const std::string said = Say(PlaceWord::kFind, "IT", At(0, 0, {-0.010, -0.004}));
  EXPECT_NE(said.find(", line 1, 13 mm right, 10 mm up."), std::string::npos) << said;
  EXPECT_NEAR(place_P_.x, Set(0).glyphs[0].origin_P.x + 0.003, 1e-9);
  EXPECT_NEAR(place_P_.y, Set(0).glyphs[0].origin_P.y + 0.006, 1e-9);
}

TEST_F(PlaceWalkTest, ReturnsToWhereTheHandWasBeforeTheFirstFind) {
  EXPECT_EQ(Say(PlaceWord::kReturn, "", At(0, 3)), say::NowhereToReturn());
  EXPECT_EQ(Say(PlaceWord::kFind, "moon", At(0, 3)), say::NotInText("moon"));
  EXPECT_EQ(Say(PlaceWord::kReturn, "", At(0, 3)), say::NowhereToReturn());
  Say(PlaceWord::kFind, "not", At(0, 3));
  Say(PlaceWord::kFind, "it", At(session_.felt().index, 0));
  const std::string said = Say(PlaceWord::kReturn, "", At(session_.felt().index, 0));
  EXPECT_EQ(said.rfind("Back at O: page 1 of ", 0), 0U) << said;  // the second letter of "LOT"
  EXPECT_EQ(Say(PlaceWord::kReturn, "", At(0, 3)), "You are back already.");
  EXPECT_EQ(Say(PlaceWord::kFind, "moon", At(0, 3)), say::NotInText("moon"));
  EXPECT_EQ(Say(PlaceWord::kReturn, "", At(0, 3)), "You are back already.");
}

TEST_F(PlaceWalkTest, ReturnsToTheVeryPlace) {
  Say(PlaceWord::kFind, "it", At(0, 3, {0.002, 0.008}));
  const std::string said = Say(PlaceWord::kReturn, "", At(0, 3, {0.002, 0.008}));
  EXPECT_NE(said.find("under the tip"), std::string::npos) << said;
}

// "next line" said three times with the hand at rest told the same line three times.
TEST_F(PlaceWalkTest, AWordSaidAgainLeadsOnWhileTheHandRests) {
  std::string all;
  for (int i = 0; i < 5; ++i) {
    // it trembles by a millimetre
    const std::string said = Say(PlaceWord::kNextLine, "", At(0, 0, {0.001 * (i % 2), 0.001}));
    all += said.substr(0, said.find(", ", said.find("line"))) + "; ";
  }
  // four rows lie on the first page, the last one on the second
  EXPECT_EQ(all,
            "Page 1 of 2, line 2; Page 1 of 2, line 3; Page 1 of 2, line 4; Page 2 of 2, line 1; "
            "This is the last line.; ");
}

TEST_F(PlaceWalkTest, AHandThatWentElsewhereIsLedFromThere) {
  ASSERT_NE(Say(PlaceWord::kNextLine, "", At(0, 0)).find("ine 2, "), std::string::npos);
  // beyond a letter's height off the way from the first row to the second
  const std::string said = Say(PlaceWord::kNextLine, "", At(0, 1, {0.020, 0.003}));
  EXPECT_NE(said.find("ine 2, "), std::string::npos) << said;
}

TEST_F(PlaceWalkTest, GoesFromLineToLineAndToHeadings) {
  std::string said = Say(PlaceWord::kNextLine, "", At(0, 1));
  EXPECT_NE(said.find("ine 2, "), std::string::npos) << said;
  said = Say(PlaceWord::kNextHeading, "", At(0, 0));
  EXPECT_EQ(said.rfind("Heading TOIL: page ", 0), 0U) << said;
  const std::size_t last = session_.text().set.pages.size() - 1;
  session_.TurnTo(last);
  const LoopSnapshot end = At(last, Set(last).glyphs.size() - 1);
  EXPECT_EQ(Say(PlaceWord::kNextLine, "", end), say::NoLineBehind());
  EXPECT_EQ(Say(PlaceWord::kNextHeading, "", end), say::NoHeadingBehind());
}

/// A text of paragraphs, lists and links, as a document is transcribed.
class PlaceWalkOfMarks : public PlaceWalkTest {
 protected:
  PlaceWalkOfMarks() {
    TextRequest request = session_.request();
    request.text.text = "AT SEA\n\n> [MOON](a)[SUN](b) AND\nA [TIDE](c)\n\n\n### LAND\n\nA HILL\n";
    session_.ChangeText(std::move(request), false);
  }
  /// The letter at a byte, as the tip on it.
  LoopSnapshot AtByte(std::size_t source) {
    const auto found = Find(session_.text(), {source, {0.5, 0.5}});
    session_.TurnTo(found->page);
    LoopSnapshot now;
    now.tip_P = glm::dvec3(found->p_P, 0);
    now.page = session_.felt().number;
    return now;
  }
  std::size_t Byte(const std::string& words) const { return session_.text().text.find(words); }
};

TEST_F(PlaceWalkOfMarks, GoesFromParagraphToParagraph) {
  std::string said = Say(PlaceWord::kNextParagraph, "", AtByte(3));
  EXPECT_EQ(said.rfind("Paragraph MOON", 0), 0U) << said;
  said = Say(PlaceWord::kNextParagraph, "", AtByte(Byte("SUN")));
  EXPECT_EQ(said.rfind("Paragraph LAND", 0), 0U) << said;
  said = Say(PlaceWord::kNextParagraph, "", AtByte(Byte("AND\n")));  // two lines are one
  EXPECT_EQ(said.rfind("Paragraph LAND", 0), 0U) << said;
  said = Say(PlaceWord::kNextParagraph, "", AtByte(Byte("LAND")));
  EXPECT_EQ(said.rfind("Paragraph A HILL", 0), 0U) << said;
  EXPECT_EQ(Say(PlaceWord::kNextParagraph, "", AtByte(Byte("HILL"))), say::NoParagraphBehind());
}

TEST_F(PlaceWalkOfMarks, GoesFromLinkToLink) {
  std::string said = Say(PlaceWord::kNextLink, "", AtByte(0));
  EXPECT_EQ(said.rfind("Link MOON: ", 0), 0U) << said;
  said = Say(PlaceWord::kNextLink, "", AtByte(Byte("OON")));  // not the one that it is in
  EXPECT_EQ(said.rfind("Link SUN: ", 0), 0U) << said;
  said = Say(PlaceWord::kNextLink, "", AtByte(Byte("SUN")));
  EXPECT_EQ(said.rfind("Link TIDE: ", 0), 0U) << said;
  EXPECT_EQ(Say(PlaceWord::kNextLink, "", AtByte(Byte("TIDE"))), say::NoLinkBehind());
}

TEST_F(PlaceWalkOfMarks, GoesToPagesByTheirNumber) {
  const std::size_t pages = session_.text().set.pages.size();
  ASSERT_GT(pages, 1U);
  const std::string said = Say(PlaceWord::kGoTo, std::to_string(pages), AtByte(0));
  EXPECT_EQ(said.rfind("Page " + std::to_string(pages) + " of ", 0), 0U) << said;
  EXPECT_EQ(session_.felt().index, pages - 1);
  for (const char* none : {"0", "-1", "x", "", "99999999999999999999", "2 "}) {
    EXPECT_EQ(Say(PlaceWord::kGoTo, none, AtByte(0)), say::NoSuchPage(none, pages)) << none;
  }
}

TEST_F(PlaceWalkTest, LeadsAtAnEvenPace) {
  PlaceWalk::Arrival arrival;
  arrival.place_P = {0.08, 0};
  const auto path = PathTo(arrival, 0.001);
  EXPECT_NEAR(path->times.back(), 2, 1e-9);  // 80 mm at 40 mm a second
  EXPECT_NEAR(path->points.back().x, 0.08, 1e-9);
}

TEST(PlaceWords, AreObeyedInALoopAndEachIsAnswered) {
  const Outcome outcome = RunLine({"loop", "MOON NOON", "--page", "60x40", "--size-mm", "20"},
                                  "find noon\nfind next\nreturn\nfind\nfind x\nnext line\n"
                                  "next heading\n48 moon\nwhere\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* said : {"noon, 1 of 1: page ", "Back", "Say what to find: find moon.",
                           "Not in this text: x.", "No heading further on.", "moon, 1 of 1: "}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << said << outcome.out;
  }
}

}  // namespace
}  // namespace moontrace
