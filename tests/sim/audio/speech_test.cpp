#include "sim/audio/speech.h"

#include <algorithm>

#include "sim/audio/ssip.h"
#include "tests/sim/fake_ssip.h"
#include "tests/sim/tutor_fixture.h"

namespace moontrace {
namespace {

/// A runtime folder of its own, in which SPEECHD_ADDRESS points to a socket.
class SpeechTest : public TutorTest {
 protected:
  SpeechTest() { setenv("SPEECHD_ADDRESS", ("unix_socket:" + path()).c_str(), 1); }
  ~SpeechTest() override { unsetenv("SPEECHD_ADDRESS"); }
  std::string path() const { return runtime_ + "/speechd.sock"; }

  /// What was asked for behind the greeting.
  static std::vector<std::string> Behind(const std::vector<std::string>& log) {
    const auto greeted = std::find(log.begin(), log.end(), "SET SELF PRIORITY TEXT");
    return greeted == log.end() ? log : std::vector<std::string>(greeted + 1, log.end());
  }
  static std::string Sentence(Speech& speech) {
    std::optional<std::string> sentence;
    EXPECT_TRUE(Eventually([&] { return (sentence = speech.TakeSentence()).has_value(); }));
    EXPECT_FALSE(speech.speaking());
    EXPECT_FALSE(speech.TakeSentence()) << "said twice";
    return sentence.value_or("");
  }
};

TEST_F(SpeechTest, SaysWhoItIsAndHowFast) {
  const FakeSsip service(path(), {});
  const Speech speech({"ada b", 30, "en"});
  EXPECT_TRUE(Eventually([&] { return speech.speaking(); }));
  EXPECT_EQ(service.Log(),
            (std::vector<std::string>{"SET SELF CLIENT_NAME ada_b:moontrace:lesson",
                                      "SET SELF NOTIFICATION END ON",
                                      "SET SELF NOTIFICATION CANCEL ON", "SET SELF LANGUAGE en",
                                      "SET SELF RATE 30", "SET SELF PRIORITY TEXT"}));
}

TEST_F(SpeechTest, GivesEachSentenceItsPriority) {
  const FakeSsip service(path(), {});
  Speech speech({});
  speech.Say(Priority::kImportant, "Stopped: no force.");
  speech.Say(Priority::kMessage, "Right: b.");
  speech.Say(Priority::kText, "B.");
  speech.Say(Priority::kText, "Twenty millimetres.");
  speech.Say(Priority::kNotification, "over j");
  speech.Say(Priority::kProgress, "50 percent");
  EXPECT_TRUE(Eventually([&] { return service.Heard("text: 50 percent"); }));
  EXPECT_EQ(Behind(service.Log()),
            (std::vector<std::string>{"SET SELF PRIORITY IMPORTANT", "SPEAK",
                                      "text: Stopped: no force.", "SET SELF PRIORITY MESSAGE",
                                      "SPEAK", "text: Right: b.", "SET SELF PRIORITY TEXT", "SPEAK",
                                      "text: B.", "SPEAK", "text: Twenty millimetres.",
                                      "SET SELF PRIORITY NOTIFICATION", "SPEAK", "text: over j",
                                      "SET SELF PRIORITY PROGRESS", "SPEAK", "text: 50 percent"}));
}

TEST_F(SpeechTest, SpellsAndNamesCharacters) {
  const FakeSsip service(path(), {});
  Speech speech({});
  speech.Spell("moon");
  speech.Character(",");
  speech.Character(" ");
  speech.SetRate(200);
  EXPECT_TRUE(Eventually([&] { return service.Heard("SET SELF RATE 100"); }));
  EXPECT_EQ(Behind(service.Log()),
            (std::vector<std::string>{"SET SELF SPELLING ON", "SPEAK", "text: moon",
                                      "SET SELF SPELLING OFF", "CHAR ,", "CHAR space",
                                      "SET SELF RATE 100"}));
}

TEST_F(SpeechTest, FallsSilentAtOnceAndDropsWhatWaits) {
  const FakeSsip service(path(), {});
  Speech speech({});
  EXPECT_TRUE(Eventually([&] { return speech.speaking(); }));
  speech.Say(Priority::kText, "A long explanation.");
  speech.Cancel();
  speech.Say(Priority::kText, "After it.");
  EXPECT_TRUE(Eventually([&] { return service.Heard("text: After it."); }));
  const auto log = service.Log();
  const auto cancelled = std::find(log.begin(), log.end(), "CANCEL SELF");
  EXPECT_NE(cancelled, log.end());
  EXPECT_LT(cancelled, std::find(log.begin(), log.end(), "text: After it."));
}

TEST_F(SpeechTest, LetsWhatIsImportantSpeakToItsEnd) {
  FakeSsip service(path(), {-1, false, false, "", ""});
  Speech speech({});
  speech.Say(Priority::kImportant, "Stopped: no force.");
  EXPECT_TRUE(Eventually([&] { return service.Heard("text: Stopped: no force."); }));
  speech.Cancel();
  speech.Character("a");
  EXPECT_TRUE(Eventually([&] { return service.Heard("CHAR a"); }));
  EXPECT_FALSE(service.Heard("CANCEL SELF"));
  service.TellEnd(1);
  speech.Cancel();
  EXPECT_TRUE(Eventually([&] { return service.Heard("CANCEL SELF"); }));
}

TEST_F(SpeechTest, WithoutAServiceIsOneSentence) {
  Speech speech({});
  speech.Say(Priority::kText, "nobody hears this");
  EXPECT_EQ(Sentence(speech),
            "No speech, all is text: speech-dispatcher is not there; install it or start it.");
}

TEST_F(SpeechTest, WithAServiceThatNeverAnswersIsOneSentenceAndBlocksNothing) {
  const FakeSsip service(path(), {-1, true, true, "", ""});
  Speech speech({});
  for (int i = 0; i < 10000; ++i) speech.Say(Priority::kText, "again and again");
  EXPECT_EQ(Sentence(speech), "No speech, all is text: speech-dispatcher does not answer.");
}

TEST_F(SpeechTest, EndsThoughTheServiceNeverAnswers) {
  const FakeSsip service(path(), {-1, true, true, "", ""});
  Speech speech({});
  EXPECT_TRUE(Eventually([&] { return !service.Log().empty(); }));
}

TEST_F(SpeechTest, WithAServiceThatDiesIsOneSentenceAtEveryCommand) {
  for (int command = 0; command < 9; ++command) {
    std::filesystem::remove(path());
    const FakeSsip service(path(), {command, false, true, "", ""});
    Speech speech({"", 0, "en"});
    speech.Say(Priority::kMessage, "Right: b.");
    speech.Say(Priority::kText, "B.");
    speech.Spell("b");
    EXPECT_EQ(Sentence(speech), "No more speech, all is text: speech-dispatcher has ended.")
        << command;
    speech.Say(Priority::kText, "into the void");
    speech.Cancel();
  }
}

TEST_F(SpeechTest, ThatIsRefusedTellsTheServicesWords) {
  const FakeSsip service(path(), {-1, false, true, "SET SELF LANGUAGE", ""});
  Speech speech({"", 0, "xx"});
  EXPECT_EQ(Sentence(speech),
            "No speech, all is text: speech-dispatcher refused: 408 ERR PARAMETER INVALID.");
}

TEST_F(SpeechTest, GoesOnBehindOneSentenceThatIsRefused) {
  const FakeSsip service(path(), {-1, false, true, "CHAR", ""});
  Speech speech({});
  speech.Character("%");
  speech.Say(Priority::kText, "still here");
  EXPECT_TRUE(Eventually([&] { return service.Heard("text: still here"); }));
  EXPECT_TRUE(speech.speaking());
}

TEST_F(SpeechTest, WithGarbageForAnAnswerIsOneSentence) {
  for (const std::string& garbage :
       {std::string("\x1b[2J nonsense\r\n"), std::string(1, '\n'), std::string("20\r\n")}) {
    std::filesystem::remove(path());
    const FakeSsip service(path(), {-1, false, true, "", garbage});
    Speech speech({});
    const std::string sentence = Sentence(speech);
    EXPECT_EQ(sentence.find("No speech, all is text: "), 0U) << sentence;
    EXPECT_EQ(sentence.find('\x1b'), std::string::npos);
  }
}

TEST_F(SpeechTest, AtAnAddressOfTheNetworkIsRefused) {
  setenv("SPEECHD_ADDRESS", "inet_socket:127.0.0.1:6560", 1);  // nothing leaves this machine
  Speech speech({});
  EXPECT_EQ(Sentence(speech),
            "No speech, all is text: SPEECHD_ADDRESS must be unix_socket:PATH, and is "
            "inet_socket:127.0.0.1:6560.");
}

TEST(SsipText, CannotEndEarlyOrCarryCommands) {
  EXPECT_EQ(SsipText("hello"), "hello\r\n.\r\n");
  EXPECT_EQ(SsipText("."), "..\r\n.\r\n");
  EXPECT_EQ(SsipText("a\r\n.\r\nQUIT"), "a  .  QUIT\r\n.\r\n");
  EXPECT_EQ(SsipText("\x1b[1m"), " [1m\r\n.\r\n");
  EXPECT_EQ(SsipText("\xff"), "?\r\n.\r\n");
}

}  // namespace
}  // namespace moontrace
