#include "sim/app/learn_tutor.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstdlib>

#include "lessons/records.h"
#include "tests/devices/fake_hid.h"
#include "tests/sim/learn_fixture.h"
#include "tests/sim/pty_fixture.h"

namespace moontrace {
namespace {

/// The tutor's end of the door.
class TutorLine {
 public:
  explicit TutorLine(const std::string& path) : socket_(socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0) << path;
  }
  ~TutorLine() { close(socket_); }
  void Say(const std::string& line) {
    const std::string bytes = line + "\n";
    EXPECT_EQ(write(socket_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }

 private:
  int socket_;
};

class LearnTutor : public LearnTest {};

TEST_F(LearnTutor, IsToldToTheLearnerKeptAndNeverUndoesTheLearnersStop) {
  setenv("XDG_RUNTIME_DIR", folder_.c_str(), 1);
  std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
  {
    PtySession session(Learn({"--tutor"}));
    ASSERT_TRUE(session.WaitFor("Keep the raw tracks")) << session.all();
    session.Send("\n");
    ASSERT_TRUE(session.WaitFor("say next to go on.")) << session.all();
    TutorLine tutor(In("moontrace/tutor-ann.sock"));
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
                                                        {"form star", "Stays as it was: script"},
                                                        {"help 3", "Help 3 of 10 now."},
                                                        {"mode rail", "Push now: rail."},
                                                        {"lesson two", "Lesson 2 of 2: Second"}};
    for (const auto& one : said) {
      tutor.Say(one.first);
      EXPECT_TRUE(session.WaitFor(one.second)) << one.first << session.all();
    }
    ASSERT_TRUE(session.Ask("stop")) << session.all();
    tutor.Say("go");
    tutor.Say("lesson nine");  // is not: nothing for the learner to hear
    tutor.Say("record");       // nor in a demonstration: the hand is the program's
    tutor.Say("say after");
    EXPECT_TRUE(session.WaitFor("Tutor says: after")) << session.all();
    EXPECT_EQ(session.all().find("going on", session.all().find("Stopped: no force")),
              std::string::npos);
    EXPECT_EQ(session.all().find("nine"), std::string::npos);
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
  EXPECT_EQ(kept, 18U);  // all but the refused "go", "lesson nine" and "record"
}

TEST_F(LearnTutor, TakesTheTutorsStrokeFromADevice) {
  setenv("XDG_RUNTIME_DIR", folder_.c_str(), 1);
  std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
  const FakeHid fake("moontrace-raw");
  const std::string name = RunLine({"devices", "--json"}).Json()["devices"][0]["name"];
  PtySession session(Learn({"--tutor", "--device", name}));
  ASSERT_TRUE(session.WaitFor("Keep the raw tracks")) << session.all();
  session.Send("\n");
  ASSERT_TRUE(session.WaitFor("say next to go on.")) << session.all();
  TutorLine tutor(In("moontrace/tutor-ann.sock"));
  ASSERT_TRUE(session.WaitFor("Tutor 1 is here")) << session.all();
  tutor.Say("record");
  EXPECT_TRUE(session.WaitFor("Tutor takes the device for a stroke.")) << session.all();
  tutor.Say("record");
  EXPECT_TRUE(session.WaitFor("The device is yours again")) << session.all();
  session.Send("quit\n");
  EXPECT_EQ(session.Wait(), 0);
}

}  // namespace
}  // namespace moontrace
