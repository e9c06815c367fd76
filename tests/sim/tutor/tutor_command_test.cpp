#include "sim/tutor/tutor_command.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "sim/console/vocabulary.h"
#include "sim/tutor/tutor_messages.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

TutorCommand Read(std::string_view line) {
  const auto read = ReadTutorCommand(line);
  if (const TutorRefusal* refusal = std::get_if<TutorRefusal>(&read)) {
    ADD_FAILURE() << line << ": " << refusal->line;
    return {};
  }
  return std::get<TutorCommand>(read);
}

std::string Refused(std::string_view line) {
  const auto read = ReadTutorCommand(line);
  const TutorRefusal* refusal = std::get_if<TutorRefusal>(&read);
  return refusal == nullptr ? std::string() : refusal->line;
}

TEST(TutorCommand, TakesChangesOfThePage) {
  ASSERT_TRUE(Read("size 20 mm").page);
  EXPECT_DOUBLE_EQ(Read("size 20 mm").page->value, 0.020);
  EXPECT_EQ(Read("emb").page->word, PageWord::kEmbossed);
  EXPECT_EQ(Read("paper noise").page->paper, PaperKind::kNoise);
  EXPECT_FALSE(Read("pause").page);
}

TEST(TutorCommand, TakesHelpFromNoneToTen) {
  EXPECT_EQ(Read("help 7").help, 7);
  EXPECT_EQ(Read("help 0").help, 0);
  EXPECT_EQ(Read("help 10").help, 10);
  EXPECT_EQ(Refused("help 10.1"), "No help 10.1, out of range: it wants a number from 0 to 10.");
  EXPECT_EQ(Refused("help 5 mm"), "No help 5 mm: it wants a number from 0 to 10.");
  EXPECT_EQ(Read("help").word, TutorWord::kQuestion) << "alone it means the same everywhere";
  EXPECT_EQ(Read("help show").text, "show");
  EXPECT_EQ(Refused("help magic"), "No help magic: it wants a number from 0 to 10.");
  EXPECT_EQ(Refused("say  "), "say lacks what it wants: a text for the learner.");
}

TEST(TutorCommand, IsReadWholeBegunOrByNumber) {
  std::set<TutorWord> words;
  for (const TypedWord& word : Vocabulary()) {
    if (!word.HoldsIn(WordPlace::kTutor)) continue;
    const std::string behind[] = {"", " 2", " bead", " sine", " x"};
    int taken = 0;
    for (const std::string& more : behind) {
      const auto by_name = ReadTutorCommand(std::string(word.word) + more);
      const auto by_number = ReadTutorCommand(std::to_string(word.number) + more);
      ASSERT_EQ(by_name.index(), by_number.index()) << word.word << more;
      if (by_name.index() != 0) continue;
      ++taken;
      const TutorCommand& command = std::get<TutorCommand>(by_name);
      EXPECT_EQ(command.word, std::get<TutorCommand>(by_number).word);
      words.insert(command.word);
    }
    EXPECT_GE(taken, 1) << word.word;
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(TutorWord::kQuestion) + 1);
  EXPECT_EQ(Read("si 20").page->word, PageWord::kSize);
  EXPECT_EQ(Read(" G\r").word, TutorWord::kGo);
  EXPECT_EQ(Read("next lesson").word, TutorWord::kNextLesson);
  EXPECT_EQ(Read("n").word, TutorWord::kNext);
  EXPECT_EQ(Read("?").word, TutorWord::kQuestion);
  // a broken byte is shown so, but asks nothing
  EXPECT_TRUE(std::holds_alternative<TutorRefusal>(ReadTutorCommand("\xff")));
  EXPECT_EQ(Read("mode BEAD").mode, GuidanceMode::kBead);
}

TEST(TutorCommand, ThatIsNoneOrSeveralIsToldApart) {
  EXPECT_EQ(Refused("spa 2 x"), "No spacing 2 x: it wants 100 to 300 %.");
  EXPECT_EQ(Refused("s 2"), "s could be stop, size, spacing, show or say.");
  EXPECT_EQ(Refused("whare"), "Unknown: whare. Did you mean where? Say ? for the words.");
  EXPECT_EQ(Refused("99"), "Unknown: 99. Say ? for the words.");
  EXPECT_EQ(Refused("0"), "Unknown: 0. Say ? for the words.");
  EXPECT_EQ(Refused(""), "Nothing was said. Say ? for the words.");
  EXPECT_EQ(Refused("pause now"), "Say pause alone, without now.");
  EXPECT_EQ(Refused("next page"), "Say next alone, without page.");
  EXPECT_EQ(Refused("mode magic"),
            "No mode magic: it wants off, attract, rail, bead, amplify, corridor.");
}

TEST(TutorCommand, KeepsTheTextsCapitalsAndNoControlCharacter) {
  EXPECT_EQ(Read("say Well done, J!").text, "Well done, J!");
  EXPECT_EQ(Read("lesson 04-jnz").text, "04-jnz");
  // an escape, and its twin above ASCII, would speak to the learner's terminal
  EXPECT_EQ(Read("say a\x1b[2Jb\xC2\x9Bzc").text, "a?[2Jb?zc");
  EXPECT_EQ(Read("say \xC3\xA4").text, "\xC3\xA4");
}

TEST(TutorCommand, IsRefusedInOneLineOfABrailleDisplayOrTwo) {
  const std::string long_one(500, 'x');
  std::vector<std::string> lines = {"", long_one, "1" + long_one, "s", "p", "e"};
  for (const std::string& word : WordsIn(WordPlace::kTutor)) {
    for (const std::string& behind : {std::string(), long_one, std::string(400, '9'),
                                      std::string("1e300"), std::string("\xE2\x80\xAE now")}) {
      lines.push_back(word + " " + behind);
    }
    lines.push_back(word + "x");
  }
  for (const std::string& line : lines) {
    const std::string refusal = Refused(line);
    EXPECT_LE(CountCharacters(refusal), 80U) << refusal;
  }
}

TEST(TutorCommand, TakesAnyBytes) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 40);
  for (int i = 0; i < 20000; ++i) {
    std::string line = i % 3 == 0 ? "say " : i % 3 == 1 ? "size " : "";
    for (int left = length(random); left > 0; --left) line += static_cast<char>(byte(random));
    const auto read = ReadTutorCommand(line);
    const TutorRefusal* refusal = std::get_if<TutorRefusal>(&read);
    const std::string& text =
        refusal != nullptr ? refusal->line : std::get<TutorCommand>(read).text;
    EXPECT_FALSE(FirstBadUtf8(text)) << text;
    for (const char c : text) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != '\x7f');
  }
}

// "Tutor: pause, no force." was told to who sat alone at the window.
TEST(TutorDoes, NamesNoTutorWhereThereIsNone) {
  EXPECT_EQ(say::WithoutTutor(say::TutorDoes({TutorWord::kPause})), "Pause, no force.");
  EXPECT_EQ(say::WithoutTutor(say::TutorDoes({TutorWord::kStop})), "Stop.");
  EXPECT_EQ(say::WithoutTutor(""), "");
}

}  // namespace
}  // namespace moontrace
