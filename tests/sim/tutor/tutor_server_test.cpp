#include "sim/tutor/tutor_server.h"

#include <random>
#include <thread>

#include "tests/sim/tutor_fixture.h"
#include "textures/base/error.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

class TutorServerTest : public TutorTest {
 protected:
  TutorServer::Line Wait() {
    std::optional<TutorServer::Line> line;
    EXPECT_TRUE(Eventually([&] { return (line = server_.Next()).has_value(); }));
    return line.value_or(TutorServer::Line{});
  }
  /// A tutor who has been greeted.
  RawTutor Come() {
    RawTutor tutor(server_.path());
    EXPECT_EQ(tutor.Line(), "Lesson of ada.");
    return tutor;
  }

  TutorServer server_{"ada", "Lesson of ada."};
};

TEST_F(TutorServerTest, GivesEachLineWithItsTutorAndAnswersThatOneAlone) {
  RawTutor first = Come(), second = Come();
  second.Send("size 20\r\nhelp 3\n");
  const TutorServer::Line size = Wait();
  EXPECT_EQ(size.tutor, 2U);
  EXPECT_EQ(size.text, "size 20");
  const TutorServer::Line help = Wait();
  EXPECT_EQ(help.text, "help 3");
  server_.Answer(2, "Size 20 mm.");
  server_.Answer(1, "For the first.");
  EXPECT_EQ(second.Line(), "Size 20 mm.");
  EXPECT_EQ(first.Line(), "For the first.");
}

TEST_F(TutorServerTest, TellsEveryTutorWhatTheLearnerIsTold) {
  RawTutor first = Come(), second = Come();
  server_.SendToAll("Right: b.");
  server_.SendToAll("two\nlines");  // one line stays one
  for (RawTutor* tutor : {&first, &second}) {
    EXPECT_EQ(tutor->Line(), "Right: b.");
    EXPECT_EQ(tutor->Line(), "two?lines");
  }
  EXPECT_EQ(server_.tutors(), 2U);
}

TEST_F(TutorServerTest, TellsWhoComesAndGoes) {
  RawTutor tutor = Come();
  EXPECT_EQ(server_.TakeSentences(),
            (std::vector<std::string>{"Tutor 1 is here, and sees what you are told."}));
  tutor.Leave();
  EXPECT_TRUE(Eventually([this] { return server_.tutors() == 0; }));
  std::vector<std::string> told;
  EXPECT_TRUE(Eventually([&] { return !(told = server_.TakeSentences()).empty(); }));
  EXPECT_EQ(told, (std::vector<std::string>{"Tutor 1 has left."}));
}

TEST_F(TutorServerTest, LetsATutorGoBehindItsLastAnswer) {
  RawTutor tutor = Come();
  server_.Answer(1, "You have left.");
  server_.Dismiss(1);
  EXPECT_EQ(tutor.Line(), "You have left.");
  EXPECT_EQ(tutor.Line(), "(closed)");
  RawTutor next = Come();
  server_.Answer(2, "numbers are not used again");
  EXPECT_EQ(next.Line(), "numbers are not used again");
}

TEST_F(TutorServerTest, RefusesMoreTutorsThanItHasRoomFor) {
  std::vector<RawTutor> tutors;
  for (int i = 0; i < 8; ++i) tutors.push_back(Come());
  RawTutor ninth(server_.path());
  EXPECT_EQ(ninth.Line(), "No room: 8 tutors are here already. Try again later.");
  EXPECT_EQ(ninth.Line(), "(closed)");
  tutors.front().Leave();
  EXPECT_TRUE(Eventually([this] { return server_.tutors() == 7; }));
  Come();
}

TEST_F(TutorServerTest, DropsOverlongLinesAndSaysSo) {
  RawTutor tutor = Come();
  tutor.Send(std::string(100000, 'x') + "\nsay hello\n");
  EXPECT_EQ(tutor.Line(), "Too long, not read: a line holds at most 1000 bytes.");
  EXPECT_EQ(Wait().text, "say hello");
}

TEST_F(TutorServerTest, MakesEveryByteALineOfText) {
  RawTutor tutor = Come();
  std::mt19937 random(3);
  std::uniform_int_distribution<int> byte(0, 255);
  std::string hostile;
  for (int i = 0; i < 20000; ++i) hostile += static_cast<char>(byte(random));
  std::thread sender([&] { tutor.Send(hostile + "\nthe end\n"); });
  for (std::string text; text != "the end";) {
    text = Wait().text;
    EXPECT_FALSE(FirstBadUtf8(text));
    for (const char c : text) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != '\x7f');
    if (testing::Test::HasFailure()) break;
  }
  sender.join();
}

TEST_F(TutorServerTest, DropsATutorWhoDoesNotRead) {
  RawTutor slow = Come(), quick = Come();
  server_.TakeSentences();
  const std::string line(900, 'x');
  int told = 0;
  EXPECT_TRUE(Eventually([&] {
    server_.SendToAll(line);
    ++told;
    EXPECT_EQ(quick.Line(), line);
    return server_.tutors() == 1;
  }));
  EXPECT_GT(told, 60);  // 64 KB of patience beside the system's own
  std::vector<std::string> sentences;
  EXPECT_TRUE(Eventually([&] { return !(sentences = server_.TakeSentences()).empty(); }));
  EXPECT_EQ(sentences.front(), "Tutor 1 was let go: it did not read what it was sent.");
  server_.Answer(2, "still here");
  EXPECT_EQ(quick.Line(), "still here");
}

TEST_F(TutorServerTest, EndsEveryBatchHoweverMuchATutorSends) {
  RawTutor tutor = Come();
  std::string flood;
  for (int i = 0; i < 3000; ++i) flood += "again\n";
  std::thread sender([&] { tutor.Send(flood + "where\n"); });
  int most = 0;
  bool last = false;
  EXPECT_TRUE(Eventually([&] {
    int batch = 0;
    while (const auto line = server_.Next()) {
      ++batch;
      last = line->text == "where";
    }
    most = std::max(most, batch);
    return last;
  }));
  sender.join();
  EXPECT_LE(most, 8);  // and none was lost: the last one came
}

TEST_F(TutorServerTest, TakesLinesThatCameBeforeATutorLeft) {
  RawTutor tutor = Come();
  tutor.Send("size 20\npause\n");
  tutor.Leave();
  EXPECT_EQ(Wait().text, "size 20");
  EXPECT_EQ(Wait().text, "pause");
}

TEST_F(TutorServerTest, IsRefusedASecondTimeAndTheFirstGoesOn) {
  RawTutor tutor = Come();
  try {
    const TutorServer second("ada", "hello");
    FAIL();
  } catch (const LackError& error) {
    EXPECT_EQ(std::string(error.what()).find("the tutor socket is already taken"), 0U);
  }
  server_.Answer(1, "still here");
  EXPECT_EQ(tutor.Line(), "still here");
}

TEST_F(TutorTest, ServersEndTellsWhatIsLeftAndRemovesTheSocket) {
  auto server = std::make_unique<TutorServer>("bob", "Lesson of bob.");
  RawTutor tutor(server->path());
  EXPECT_EQ(tutor.Line(), "Lesson of bob.");
  server->SendToAll("The last word.");
  server.reset();
  EXPECT_EQ(tutor.Line(), "The last word.");
  EXPECT_EQ(tutor.Line(), "(closed)");
  EXPECT_TRUE(std::filesystem::is_empty(folder()));
}

}  // namespace
}  // namespace moontrace
