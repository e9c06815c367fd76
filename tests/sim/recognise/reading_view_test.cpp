#include "sim/recognise/reading_view.h"

#include <gtest/gtest.h>

#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

/// A reader in the midst of a page.
class ReaderInTheMidst final : public PageReader {
 public:
  ReaderAction Step(const ReaderInput&) override { return {}; }
  bool done() const override { return false; }
  std::vector<ReadToken> tokens() const override { return tokens_; }
  std::vector<ReadToken> Pending() const override { return pending_; }
  std::vector<SignGuess> belief() const override { return belief_; }
  ReaderActivity activity() const override { return ReaderActivity::kTurning; }

  std::vector<ReadToken> tokens_, pending_;
  std::vector<SignGuess> belief_;
};

class ReadingView : public testing::Test {
 protected:
  std::size_t Glyph(const char* name) const { return script_.Find(name); }
  ReadToken Sign(const char* name) const {
    ReadToken token;
    token.glyph = Glyph(name);
    return token;
  }
  TrialTexts::Reading Texts() const { return ReadingTexts(reader_, shapes_, script_); }

  Script script_ = FindScript("moon");
  SignShapes shapes_{script_, {Glyph("n"), Glyph("o")}, SignShapes::Dots::kFloors};
  ReaderInTheMidst reader_;
};

TEST_F(ReadingView, ShowsLinesThatAreReadAndTheOneThatIsBeingRead) {
  ReadToken end;
  end.kind = ReadToken::Kind::kLineEnd;
  reader_.tokens_ = {Sign("n"), end};
  reader_.pending_ = {Sign("o")};
  EXPECT_EQ(Texts().read, "n o");
}

TEST_F(ReadingView, ShowsTheEndOfALongText) {
  reader_.tokens_.assign(100, Sign("n"));
  reader_.pending_ = {Sign("o")};
  EXPECT_EQ(Texts().read, std::string(59, 'n') + "o");
}

TEST_F(ReadingView, NamesTheLikeliestSignsAndHowSureTheyAre) {
  EXPECT_EQ(Texts().belief, "");
  SignGuess o, n;
  o.sign = 1;
  o.probability = 0.934;
  n.sign = 0;
  n.probability = 0.06;
  SignGuess unknown;
  unknown.probability = 0.006;
  reader_.belief_ = {o, n, unknown};
  EXPECT_EQ(Texts().belief, "o 93 %, n 6 %");
  unknown.probability = 1;
  reader_.belief_ = {unknown};
  EXPECT_EQ(Texts().belief, "unknown 100 %");
}

// Window fonts have no Braille cells.
TEST_F(ReadingView, ShowsBrailleByTheNumbersOfItsDots) {
  const Script braille = FindScript("braille");
  const SignShapes shapes(braille, {braille.Find("dots-234")}, SignShapes::Dots::kMiddles);
  ReadToken s, o;
  s.glyph = braille.Find("dots-234");
  o.glyph = braille.Find("dots-135");
  reader_.tokens_ = {s, o};
  SignGuess guess;
  guess.sign = 0;
  guess.probability = 1;
  reader_.belief_ = {guess};
  const TrialTexts::Reading texts = ReadingTexts(reader_, shapes, braille);
  EXPECT_EQ(texts.read, "234 135");
  EXPECT_EQ(texts.belief, "234 100 %");
}

TEST_F(ReadingView, TellsWhatTheHandIsAt) { EXPECT_EQ(Texts().doing, "looks for the rest"); }

}  // namespace
}  // namespace moontrace
