#include "sim/book/moon_lines.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/devices/fake_hid.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class MoonLinesTest : public CliTest {
 protected:
  /// The page of a device small enough for four lines.
  SessionRequest Request(const std::string& text) {
    SessionRequest request;
    request.text.text.text = text;
    request.text.style.size = 0.012;
    request.live.device = RunLine({"devices", "--json"}).Json()["devices"][0]["name"];
    return request;
  }
  /// A press on the letter that begins at a byte of the text.
  static LoopEvent PressOn(const LoopSession& session, std::size_t byte) {
    LoopEvent event;
    event.kind = LoopEventKind::kSay;
    event.tip_P = glm::dvec3(Find(session.text(), {byte, {0.25, 0.5}})->p_P, 0);
    return event;
  }

  /// The hand reads from one letter on to another.
  static void Read(MoonLines& lines, const LoopSession& session, std::size_t from, std::size_t to) {
    for (const std::size_t byte : {from, to}) {
      LoopSnapshot now;
      now.page = session.felt().number;
      now.depth = 1e-4;
      now.tip_P = PressOn(session, byte).tip_P;
      lines.Look(now);
    }
  }

  FakeHid fake_{"moontrace-raw"};
  std::istringstream in_;
  std::ostringstream out_, err_;
  Console console_{in_, out_, err_};
};

TEST_F(MoonLinesTest, APressOnAnAnswerTakesItAndOneOnTheQuestionDoesNot) {
  LoopSession session(Request("who reads?\nann\nbob"), console_);
  MoonLines lines(session, "who reads?", {"ann", "bob"});
  EXPECT_EQ(lines.Look({}), (std::vector<std::string>{"who reads?", "ann", "bob"}));
  EXPECT_TRUE(lines.urgent());  // with a tremble
  EXPECT_TRUE(lines.Look({}).empty());
  EXPECT_FALSE(lines.urgent());
  Read(lines, session, 0, 4);
  lines.Pressed(false, PressOn(session, 4));
  EXPECT_FALSE(lines.ended());
  Read(lines, session, 11, 12);
  lines.Pressed(false, PressOn(session, 16));
  EXPECT_FALSE(lines.ended()) << "ann was read, not bob";
  Read(lines, session, 15, 16);
  lines.Pressed(false, PressOn(session, 16));
  EXPECT_TRUE(lines.ended());
  EXPECT_EQ(lines.taken(), "bob");
}

TEST_F(MoonLinesTest, APressBesideThemLeadsOnAndBehindTheLastPageToTheFirst) {
  const std::string text = "who reads?\nann\nbob\ncat\ndan\neve\nfay\ngus\nhal";
  LoopSession session(Request(text), console_);
  MoonLines lines(session, "who reads?", {"ann", "hal"});
  const std::size_t pages = session.text().set.pages.size();
  ASSERT_GT(pages, 1U);
  LoopEvent beside;
  beside.tip_P = {-0.5, -0.5, 0};
  for (std::size_t page = 1; page <= pages; ++page) {
    lines.Pressed(false, beside);
    EXPECT_EQ(session.felt().index, page % pages);
  }
  EXPECT_FALSE(lines.ended());
}

TEST_F(MoonLinesTest, WithoutForceAPressBringsItBackAndTakesNoAnswer) {
  LoopSession session(Request("who reads?\nann\nbob"), console_);
  MoonLines lines(session, "who reads?", {"ann", "bob"});
  LoopSnapshot now;
  now.stopped = true;
  Read(lines, session, 15, 16);
  lines.Look(now);
  EXPECT_TRUE(lines.Pressed(false, PressOn(session, 16)).taken);
  EXPECT_FALSE(lines.ended());
  EXPECT_FALSE(lines.Obey("go", now));  // the loop's own word
  now.stopped = false;
  lines.Look(now);
  lines.Pressed(false, PressOn(session, 16));
  EXPECT_EQ(lines.taken(), "bob");
}

TEST_F(MoonLinesTest, AnyPressTakesASentenceAway) {
  LoopSession session(Request("no such book"), console_);
  MoonLines lines(session, "no such book", {});
  LoopEvent anywhere;
  anywhere.tip_P = {-0.5, -0.5, 0};
  lines.Pressed(false, anywhere);
  EXPECT_TRUE(lines.ended());
}

TEST_F(MoonLinesTest, ATypedAnswerIsTakenInAnyCaseAndQuitLeaves) {
  in_.str("who\nBOB\nrest\n");
  LineReader typed(in_);
  EXPECT_EQ(ChooseByTouch(Request(""), "who reads?", {"ann", "bob"}, typed, console_), "bob");
  EXPECT_EQ(typed.Next(0), "rest");                                       // left for the book
  EXPECT_EQ(out_.str(), "who reads?\nann\nbob\nwho reads?\nann\nbob\n");  // "who" is no answer
  std::istringstream leaves("quit\n");
  LineReader quits(leaves);
  EXPECT_EQ(ChooseByTouch(Request(""), "who reads?", {"ann", "bob"}, quits, console_),
            std::nullopt);
}

}  // namespace
}  // namespace moontrace
