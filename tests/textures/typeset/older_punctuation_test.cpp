#include "textures/typeset/older_punctuation.h"

#include <gtest/gtest.h>

#include "textures/base/error.h"
#include "textures/base/utf8.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/back_translate.h"

namespace moontrace {
namespace {

const Script& Moon() {
  static const Script moon = FindScript("moon");
  return moon;
}

// The text by the older rules, line by line.
std::string Older(std::string_view text) {
  Folder folder(text, Moon());
  std::vector<FoldedChar> line;
  std::string written;
  while (folder.NextLine(line)) {
    UseOlderPunctuation(text, Moon(), line);
    for (const FoldedChar& c : line) {
      if (c.kind == FoldedChar::Kind::kSpace) written += ' ';
      if (c.kind == FoldedChar::Kind::kSign) written += ToUtf8(c.code);
    }
    written += '\n';
  }
  return written;
}

// bsblind, Grade 1 (moon-script reference, section 6): the mark stood before the question, which
// ended in a short stop.
TEST(OlderPunctuation, PutsTheQuestionMarkBeforeTheQuestion) {
  EXPECT_EQ(Older("Who is it?"), "?who is it,\n");
  EXPECT_EQ(Older("It is I. Who, then, is it? He! What?"),
            "it is i. ?who, then, is it, he! ?what,\n");
  EXPECT_EQ(Older("Who? Where? Nobody."), "?who, ?where, nobody.\n");
}

TEST(OlderPunctuation, ReadsQuestionsOverTheLinesOfAParagraph) {
  EXPECT_EQ(Older("Yes. Is this\na question\nof three lines? No."),
            "yes. ?is this\na question\nof three lines, no.\n");
  EXPECT_EQ(Older("This is none\n\nIs this?"), "this is none\n\n?is this,\n");
  EXPECT_EQ(Older("Is it Mr.\nMoon?\r\nIt is."), "?is it mr,\nmoon,\nit is.\n");
}

TEST(OlderPunctuation, KeepsAQuestionWithinItsQuotationOrBracket) {
  EXPECT_EQ(Older("He said, \"Who is it?\" and went."), "he said, \"?who is it,\" and went.\n");
  EXPECT_EQ(Older("Is the \"main\" thing (this) here?"), "?is the \"main\" thing (this) here,\n");
  EXPECT_EQ(Older("It came (why?) late."), "it came (?why,) late.\n");
}

TEST(OlderPunctuation, WritesTheShortStopForColonSemicolonAndAbbreviation) {
  EXPECT_EQ(Older("Dr. Moon: one; two."), "dr, moon, one, two.\n");
  EXPECT_EQ(Older("E.g. this, i.e. that, etc."), "e,g, this, i,e, that, etc,\n");
  EXPECT_EQ(Older("W. Moon is I. He is."), "w, moon is i. he is.\n");
}

TEST(OlderPunctuation, LeavesWhatIsNoSentence) {
  EXPECT_EQ(Older("? (?) ??"), "? (?) ??\n");
  EXPECT_EQ(Older("a?b"), "a?b\n");
  EXPECT_EQ(Older("Wait... what? It is 3.14."), "?wait... what, it is 3.14.\n");
  EXPECT_EQ(Older("He left... What?"), "he left... ?what,\n");
}

// What was asked still reads so: by the mark before it.
TEST(OlderPunctuation, ReadsBackAsWritten) {
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, Moon());
  style.older_punctuation = true;
  const BackTranslation back = TranslateBack("Dr. Moon, who is it?", Moon(), style);
  EXPECT_EQ(back.text, "?dr, moon, who is it,\n");
  EXPECT_EQ(back.differ_count, 0U);
  EXPECT_EQ(back.replaced, 2U);
}

TEST(OlderPunctuation, IsOfMoonAlone) {
  const Script shapes = FindScript("shapes");
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, shapes);
  style.older_punctuation = true;
  EXPECT_THROW(TranslateBack("a", shapes, style), InputError);
}

// A book that never ends a sentence, or opens a quotation on every line, takes its time once.
TEST(SlowOlderPunctuation, IsLinearInTheText) {
  std::string open, quoted;
  while (open.size() < 4'000'000) open += "and so on\n";
  while (quoted.size() < 4'000'000) quoted += "he \"said\n";
  for (const std::string& text : {open, quoted}) EXPECT_EQ(Older(text).size(), text.size());
}

}  // namespace
}  // namespace moontrace
