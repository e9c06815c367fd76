#include "sim/app/commands.h"

#include <atomic>
#include <chrono>
#include <thread>

#include "sim/tutor/tutor_messages.h"
#include "sim/tutor/tutor_server.h"
#include "tests/sim/cli_fixture.h"
#include "tests/sim/tutor_fixture.h"

namespace moontrace {
namespace {

/// A lesson that answers each line by what it heard, and ends with the twentieth.
class Lesson {
 public:
  explicit Lesson(const std::string& learner) {
    server_ = std::make_unique<TutorServer>(learner, "Lesson of " + learner + ".");
    thread_ = std::thread([this] {
      while (!end_) {
        while (const auto line = server_->Next()) Obey(*line);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      server_.reset();
    });
  }
  ~Lesson() {
    end_ = true;
    thread_.join();
  }

 private:
  void Obey(const TutorServer::Line& line) {
    const bool leaves = line.text == "quit";
    server_->Answer(line.tutor, leaves ? say::TutorGone() : "Heard: " + line.text);
    if (leaves) server_->Dismiss(line.tutor);
    if (++heard_ == kLongest) end_ = true;
  }
  static constexpr int kLongest = 20;  ///< lines of a lesson
  int heard_ = 0;
  std::unique_ptr<TutorServer> server_;
  std::atomic<bool> end_{false};
  std::thread thread_;
};

/// Input that never ends: a tutor who asks "where" again and again.
class TalkativeTutor : public std::streambuf {
  int_type underflow() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    setg(line_, line_, line_ + sizeof line_);
    return traits_type::to_int_type(line_[0]);
  }
  char line_[6] = {'w', 'h', 'e', 'r', 'e', '\n'};
};

class TutorCommandLine : public TutorTest {};

TEST_F(TutorCommandLine, SpeaksThroughAPipeAndEndsWithItOnceAllIsAnswered) {
  const Lesson lesson("ada");
  const Outcome outcome = RunLine({"tutor"}, "size 20\nhelp 3");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out,
            "Lesson of ada.\nHeard: size 20\nHeard: help 3\nYou have left; the lesson goes on.\n");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(TutorCommandLine, LeavesByQuitAndReadsNothingBehindIt) {
  const Lesson lesson("ada");
  EXPECT_EQ(RunLine({"tutor", "--learner", "ada"}, "quit\nsize 20\n").out,
            "Lesson of ada.\nYou have left; the lesson goes on.\n");
}

TEST_F(TutorCommandLine, EndsInOrderWhenTheLessonEnds) {
  const Lesson lesson("ada");
  TalkativeTutor words;
  std::istream in(&words);
  std::ostringstream out, err;
  Console console(in, out, err);
  EXPECT_EQ(RunCli({"tutor"}, console), 0);
  EXPECT_EQ(out.str().find("Lesson of ada.\nHeard: where\nHeard: where\n"), 0U);
  EXPECT_EQ(Lines(out.str()).back(), "It has ended: nobody is there any more.");
  EXPECT_EQ(err.str(), "");
}

TEST_F(TutorCommandLine, WritesEachLineAsJson) {
  const Lesson lesson("ada");
  const Outcome outcome = RunLine({"tutor", "--json"}, "where\n");
  EXPECT_EQ(outcome.out,
            "{\"line\":\"Lesson of ada.\"}\n{\"line\":\"Heard: where\"}\n{\"line\":\"You have "
            "left; the lesson goes on.\"}\n");
}

TEST_F(TutorCommandLine, SaysInOneLineThatNoLessonRuns) {
  const Outcome none = RunLine({"tutor"});
  EXPECT_EQ(none.code, 4);
  EXPECT_EQ(none.out, "");
  EXPECT_EQ(none.err, "no lesson runs here with a tutor: start one with moontrace learn --tutor\n");
  const Outcome other = RunLine({"tutor", "--learner", "bob"});
  EXPECT_EQ(other.code, 4);
  EXPECT_EQ(other.err,
            "no lesson of bob runs here with a tutor: start one with moontrace learn --tutor\n");
}

// As report and records do: a name in another case, or with a slip, is not found but named.
TEST_F(TutorCommandLine, NamesTheLearnerWhoWasPerhapsMeant) {
  const Lesson lesson("Ada");
  for (const std::string given : {"ada", "Adq"}) {
    const Outcome outcome = RunLine({"tutor", "--learner", given});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_EQ(outcome.err,
              "no lesson of " + given + " runs here with a tutor: did you mean Ada?\n");
  }
  EXPECT_EQ(RunLine({"tutor", "--learner", "bob"}).err,
            "no lesson of bob runs here with a tutor: start one with moontrace learn --tutor\n");
}

TEST_F(TutorCommandLine, AsksWhichOfSeveralLessons) {
  const Lesson ada("ada"), bob("bob");
  const Outcome outcome = RunLine({"tutor"}, "where\n");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.err, "several lessons run: choose with --learner: ada, bob\n");
  EXPECT_EQ(RunLine({"tutor", "--learner", "bob"}, "").out,
            "Lesson of bob.\nYou have left; the lesson goes on.\n");
}

TEST_F(TutorCommandLine, EntersNoFolderThatOthersMayWriteTo) {
  std::filesystem::create_directory(folder());
  std::filesystem::permissions(folder(), std::filesystem::perms::all);
  const Outcome outcome = RunLine({"tutor"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.err.find("no tutor can come: others may enter"), 0U) << outcome.err;
}

}  // namespace
}  // namespace moontrace
