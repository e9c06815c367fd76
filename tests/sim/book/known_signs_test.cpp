#include "sim/book/known_signs.h"

#include <gtest/gtest.h>

#include "lessons/records/records.h"
#include "sim/book/book_messages.h"
#include "sim/book/unset_words.h"
#include "sim/setup/text_setup.h"
#include "tests/sim/cli_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

class KnownSignsTest : public CliTest {
 protected:
  void SetUp() override {
    if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
    Records records = Records::Open(In("records.sqlite"));
    for (const char* name : {"owl", "new"}) records.AddLearner({name, 0, false, "", false});
    for (const char* item : {"i", "t", "l", "o"}) {
      Trial trial;
      trial.lesson = "04-itlo";
      trial.item = item;
      trial.kind = StepKind::kDemonstrate;
      trial.right = true;
      records.Add("owl", "learn-moon", trial);
    }
  }
};

FeltPage PageOf(const std::string& text, const std::string& only) {
  std::istringstream in;
  std::ostringstream out, err;
  Console console(in, out, err);
  TextRequest request;
  request.text.text = text;
  request.style.only = only;
  request.book = true;
  return FeltPageOf(std::make_shared<const TextSetup>(SetUpText(request, console)), 0, false, 0);
}

TEST_F(KnownSignsTest, AreThoseThatTheRecordsSayWereTaught) {
  EXPECT_EQ(KnownSigns(In("records.sqlite"), "OWL"), "+i+l+o+t");
  EXPECT_THROW(KnownSigns(In("records.sqlite"), "new"), InputError);
  EXPECT_THROW(KnownSigns(In("records.sqlite"), ""), UsageError);  // two of them
}

// To the hand there are "it", "lot", "to", and a mark for each other word, which says it.
TEST_F(KnownSignsTest, WhatIsLeftOutIsSaidAsOneComesToItsMark) {
  const FeltPage page =
      PageOf("The sun: it has a lot, made to burn.", "+i+t+l+o+" + std::string(kLeftOutMark));
  std::vector<std::string> said;
  const std::vector<PlacedGlyph>& glyphs = page.set().glyphs;
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    const std::string words = UnsetWords(page, i);
    said.push_back(words.empty() ? page.text->script.glyphs[glyphs[i].glyph].name : words);
  }
  EXPECT_EQ(said, (std::vector<std::string>{"The", "sun", "i", "t", "has", "a", "l", "o", "t",
                                            "made", "t", "o", "burn"}));
  EXPECT_EQ(CountLeftOut(*page.text).left_out, 6U);
}

TEST_F(KnownSignsTest, NothingIsSaidOfATextThatIsAllSet) {
  const FeltPage page = PageOf("It is so.", "+i+t+s+o");
  EXPECT_EQ(UnsetWords(page, 0), "");
  EXPECT_EQ(UnsetWords(page, page.set().glyphs.size() - 1), "");
}

TEST_F(KnownSignsTest, ReadSetsOnlyThem) {
  const Outcome outcome = RunLine(
      {"read", "-", "--known", "--learner", "owl", "--records", In("records.sqlite"), "--json"},
      "to list it");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.Json()["signs"], 5);  // a mark for "list"
  EXPECT_EQ(outcome.Json()["left_out_words"], 1);
  EXPECT_EQ(RunLine({"read", "-", "--known", "--records", In("records.sqlite")}, "x").code, 2);
}

TEST_F(KnownSignsTest, PrintingSaysHowManyWordsAreLeftOut) {
  const Outcome outcome = RunLine({"read", "-", "--known", "--learner", "owl", "--records",
                                   In("records.sqlite"), "--print", In("page.svg")},
                                  "it is a lot");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("Set in the 4 signs that you know."), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.out.find("Left out: 2 of 4 words. Two level lines stand for each.\n"),
            std::string::npos)
      << outcome.out;
}

}  // namespace
}  // namespace moontrace
