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

// To the hand there are "it", "lot" and "to"; all else is said before or with what is felt next.
TEST_F(KnownSignsTest, WhatIsNotSetIsSaidAsOneComesToTheNextWord) {
  const FeltPage page = PageOf("The sun: it has a lot, made to burn.", "+i+t+l+o");
  std::vector<std::string> said;
  std::size_t word = static_cast<std::size_t>(-1);
  const std::vector<PlacedGlyph>& glyphs = page.set().glyphs;
  std::string set;
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    set += page.text->text.substr(glyphs[i].source_begin,
                                  glyphs[i].source_end - glyphs[i].source_begin);
    if (glyphs[i].word == word) continue;
    word = glyphs[i].word;
    said.push_back(UnsetWords(page, i));
  }
  EXPECT_EQ(set, "Titlotto");  // "T" of The
  EXPECT_EQ(said, (std::vector<std::string>{"The", "sun:", "has a", "made burn."}));
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
  EXPECT_EQ(outcome.Json()["signs"], 7);  // all but s
  EXPECT_EQ(RunLine({"read", "-", "--known", "--records", In("records.sqlite")}, "x").code, 2);
}

}  // namespace
}  // namespace moontrace
