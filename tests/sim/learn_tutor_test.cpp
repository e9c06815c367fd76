#include "sim/app/learn_tutor.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstdlib>

#include "lessons/records.h"
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
    const std::pair<const char*, const char*> said[] = {{"size 10", "Tutor: letters of 10 mm."},
                                                        {"say hello", "Tutor says: hello"},
                                                        {"depth 150 %", "Tutor: depth 150"},
                                                        {"spacing 1.5", "Tutor: spaces 150"},
                                                        {"tilt 10", "Tutor: page tilted by 10"},
                                                        {"pause", "Tutor: pause, no force."},
                                                        {"go", "Tutor: going on."},
                                                        {"again", "Tutor: once more."},
                                                        {"record", "Tutor takes the device"},
                                                        {"record", "The device is yours again"},
                                                        {"lesson two", "Lesson 2 of 2: Second"}};
    for (const auto& one : said) {
      tutor.Say(one.first);
      EXPECT_TRUE(session.WaitFor(one.second)) << one.first << session.all();
    }
    ASSERT_TRUE(session.Ask("stop")) << session.all();
    tutor.Say("go");
    tutor.Say("lesson nine");  // is not: nothing for the learner to hear
    tutor.Say("say after");
    EXPECT_TRUE(session.WaitFor("Tutor says: after")) << session.all();
    EXPECT_EQ(session.all().find("going on", session.all().find("Stopped: no force")),
              std::string::npos);
    EXPECT_EQ(session.all().find("nine"), std::string::npos);
    session.Send("quit\n");
    EXPECT_EQ(session.Wait(), 0);
    ExpectStream(session.all());
  }
  std::size_t kept = 0;
  for (const RecordedEvent& event : Records::OpenToRead(In("records.sqlite")).Events("ann")) {
    if (event.kind == "tutor") ++kept;
  }
  EXPECT_EQ(kept, 12U);  // all but the refused "go" and "lesson nine"
}

}  // namespace
}  // namespace moontrace
