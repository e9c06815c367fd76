#include "sim/learn/learn_tutor.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "lessons/records/records.h"
#include "tests/devices/fake_hid.h"
#include "tests/sim/learn_fixture.h"
#include "tests/sim/pty_fixture.h"
#include "tests/sim/tutor_fixture.h"

namespace moontrace {
namespace {

/// Whether the tutor hears a line that begins so.
bool Hears(RawTutor& tutor, const std::string& begin) {
  std::string line;
  do line = tutor.Line();
  while (line != "(silence)" && line != "(closed)" && line.find(begin) != 0);
  return line.find(begin) == 0;
}

class LearnTutor : public LearnTest {};

TEST_F(LearnTutor, IsToldToTheLearnerKeptAndNeverUndoesTheLearnersStop) {
  SKIP_WITHOUT_TERMINALS();
  setenv("XDG_RUNTIME_DIR", folder_.c_str(), 1);
  std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
  {
    PtySession session(Learn({"--tutor"}));
    ASSERT_TRUE(session.WaitFor("A tutor may join from a second terminal: ")) << session.all();
    ASSERT_TRUE(session.WaitFor("say next to go on.")) << session.all();
    RawTutor tutor(In("moontrace/tutor-ann.sock"));
    ASSERT_TRUE(session.WaitFor("Tutor 1 is here")) << session.all();
    const std::pair<const char*, const char*> said[] = {{"size 10", "Letters of 10 mm now."},
                                                        {"say hello", "Tutor says: hello"},
                                                        {"depth 150 %", "Tutor: depth 150"},
                                                        {"spacing 1.5", "Tutor: spaces 150"},
                                                        {"tilt 10", "Tutor: page tilted by 10"},
                                                        {"pause", "Tutor: pause, no force."},
                                                        {"go", "Tutor: going on."},
                                                        {"again", "Tutor: once more."},
                                                        {"width 120 %", "Tutor: width 120"},
                                                        {"pitch 2", "Tutor: lines apart 200"},
                                                        {"embossed", "Tutor: embossed"},
                                                        {"form arc", "Tutor: H has the form arc."},
                                                        {"paper noise", "Tutor: paper noise."},
                                                        {"help 3", "Help 3 of 10 now."},
                                                        {"mode rail", "Push now: rail."},
                                                        {"lesson two", "Lesson 2 of 2: Second"},
                                                        {"lesson 1", "Lesson 1 of 2: First"},
                                                        {"next", "Tutor: next."}};
    for (const auto& one : said) {
      tutor.Send(std::string(one.first) + "\n");
      EXPECT_TRUE(session.WaitFor(one.second)) << one.first << session.all();
    }
    ASSERT_TRUE(session.Ask("stop")) << session.all();
    tutor.Send("go\n");
    // Before: lesson and step, and nothing of who, how large, with what push.
    tutor.Send("where\n");
    EXPECT_TRUE(Hears(tutor, "ann: Lesson ")) << session.all();
    EXPECT_TRUE(Hears(tutor, "Letters "));
    EXPECT_TRUE(Hears(tutor, "Nothing right or wrong yet today."));
    tutor.Send("lesson 2\n");
    tutor.Send("next lesson\n");
    EXPECT_TRUE(Hears(tutor, "This is the last lesson"));
    tutor.Send("size 500\n");
    tutor.Send("say so far\n");
    std::string sizes;  // one line, of what lies there: no page here has room for the largest
    for (std::string line = tutor.Line(); line != "Tutor says: so far"; line = tutor.Line()) {
      ASSERT_NE(line[0], '(') << line;
      if (line.find(" mm") != std::string::npos) sizes += line + "\n";
    }
    EXPECT_EQ(sizes, "500 mm has no room: letters of 160 mm now; this does not count.\n");
    tutor.Send("lesson nine\n");  // is not: nothing for the learner to hear
    tutor.Send("lesson 3\n");
    EXPECT_TRUE(Hears(tutor, "No such lesson: 3. Say a number from 1 to 2."));
    tutor.Send("?\n");
    EXPECT_TRUE(Hears(tutor, "help 7 is the push, from 0 to 10.")) << session.all();
    tutor.Send("record\n");  // nor in a demonstration: the hand is the program's
    tutor.Send("form star\n");
    EXPECT_TRUE(Hears(tutor, "Stays as it was: script"));
    tutor.Send("say after\n");
    EXPECT_TRUE(session.WaitFor("Tutor says: after")) << session.all();
    EXPECT_EQ(session.all().find("going on", session.all().find("Stopped. Say go")),
              std::string::npos);
    EXPECT_EQ(session.all().find("nine"), std::string::npos);
    EXPECT_EQ(session.all().find("Stays as it was"), std::string::npos);
    EXPECT_EQ(session.all().find("takes the device"), std::string::npos);
    for (const char* once : {"etters of 10 mm", "elp 3 of 10", "ush now: rail", "ush rail"}) {
      const std::size_t first = session.all().find(once);
      EXPECT_EQ(session.all().find(once, first + 1), std::string::npos) << once;
    }
    session.Send("quit\n");
    EXPECT_EQ(session.Wait(), 0);
    ExpectStream(session.all());
  }
  std::size_t kept = 0;
  for (const RecordedEvent& event : Records::OpenToRead(In("records.sqlite")).Events("ann")) {
    if (event.kind == "tutor") ++kept;
  }
  EXPECT_EQ(kept, 22U);  // all but "go", "lesson nine", "lesson 3", "record" and "form star"
}

// While the hand is led the whole way, "help 7" changes nothing: "where" said "help 10 of 10".
TEST_F(LearnTutor, WhereTellsTheHandThatIsLedFromOneThatIsHelped) {
  SKIP_WITHOUT_TERMINALS();
  setenv("XDG_RUNTIME_DIR", folder_.c_str(), 1);
  std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
  const FakeHid fake("moontrace-raw");
  const std::string name = RunLine({"devices", "--json"}).Json()["devices"][0]["name"];
  PtySession session(Learn({"--tutor", "--device", name}));
  ASSERT_TRUE(session.WaitFor("say next to go on.")) << session.all();
  RawTutor tutor(In("moontrace/tutor-ann.sock"));
  ASSERT_TRUE(session.WaitFor("Tutor 1 is here")) << session.all();
  tutor.Send("help 7\nwhere\n");
  EXPECT_TRUE(Hears(tutor, "Letters 16 mm, not led, help 7 of 10, push attract"));
  session.Send("next\n");  // the course's demonstration
  ASSERT_TRUE(session.WaitFor("hand be led: i")) << session.all();
  tutor.Send("where\n");
  EXPECT_TRUE(Hears(tutor, "Letters 16 mm, the hand is led to the end, then help 7 of 10"));
  tutor.Send("mode off\nwhere\n");  // nothing leads it
  EXPECT_TRUE(Hears(tutor, "Letters 16 mm, no push"));
  session.Send("quit\n\n");
  EXPECT_EQ(session.Wait(), 0);
}

TEST_F(LearnTutor, TakesTheTutorsStrokeFromADevice) {
  SKIP_WITHOUT_TERMINALS();
  setenv("XDG_RUNTIME_DIR", folder_.c_str(), 1);
  std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
  const FakeHid fake("moontrace-raw");
  const std::string name = RunLine({"devices", "--json"}).Json()["devices"][0]["name"];
  PtySession session(Learn({"--tutor", "--device", name}));
  ASSERT_TRUE(session.WaitFor("say next to go on.")) << session.all();
  RawTutor tutor(In("moontrace/tutor-ann.sock"));
  ASSERT_TRUE(session.WaitFor("Tutor 1 is here")) << session.all();
  tutor.Send("record\n");
  EXPECT_TRUE(session.WaitFor("Tutor takes the device for a stroke.")) << session.all();
  tutor.Send("record\n");
  EXPECT_TRUE(session.WaitFor("The device is yours again")) << session.all();
  session.Send("quit\n\n");  // no path of the hand is to be kept
  EXPECT_EQ(session.Wait(), 0);
}

}  // namespace
}  // namespace moontrace
