#include "textures/typeset/line_ends.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/textures/small_script.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

/// The text with "|" wherever a line may end within a word.
std::string Ends(std::string_view text) {
  const Script script = SmallScript();  // the folder keeps a reference
  Folder folder(text, script, [](char32_t c) { return c != U' ' && c != 0xAD; });
  std::vector<FoldedChar> line;
  folder.NextLine(line);
  const std::vector<LineEnd> ends = LineEndsOf(line);
  std::string marked;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].kind == FoldedChar::Kind::kNothing) continue;
    marked += ToUtf8(line[i].code);
    const bool in_word = i + 1 < line.size() && line[i].kind == FoldedChar::Kind::kSign &&
                         line[i + 1].kind != FoldedChar::Kind::kSpace;
    if (in_word && !ends[i].keep_next) marked += '|';
  }
  return marked;
}

/// The text with "_" for each space at which no line ends, "|" where a line may end in every word.
std::string Spaces(std::string_view text) {
  const Script script = SmallScript();
  Folder folder(text, script, [](char32_t c) { return c != U' ' && c != 0x202F && c != 0xA0; });
  std::vector<FoldedChar> line;
  folder.NextLine(line);
  const std::vector<LineEnd> ends = LineEndsOf(line);
  std::string marked;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool space = line[i].kind == FoldedChar::Kind::kSpace;
    marked += space && ends[i].keep_next ? "_" : ToUtf8(line[i].code);
    const bool kept = !space && i + 1 < line.size() && ends[i + 1].keep_next &&
                      line[i + 1].kind == FoldedChar::Kind::kSpace;
    EXPECT_TRUE(!kept || ends[i].keep_next) << marked;
    if (ends[i].may_end && !ends[i].keep_next && i + 1 < line.size()) marked += '|';
  }
  return marked;
}

// What typesetters hold to in every language: no line begins with a mark that closes or ends with
// one that opens, and an ellipsis is one mark.
TEST(LineEnds, KeepMarksThatCloseWithWhatStandsBeforeThem) {
  EXPECT_EQ(Ends("wait..."), "w|a|i|t...");
  EXPECT_EQ(Ends("(no), it?!"), "(n|o), i|t?!");
  EXPECT_EQ(Ends("30% 5\u20AC \u20AC5"), "3|0% 5\u20AC \u20AC5");
  EXPECT_EQ(Ends("\u300Ca\u300D\u3002"), "\u300Ca\u300D\u3002");
}

TEST(LineEnds, KeepQuotationMarksByTheirPlaceInAnyForm) {
  EXPECT_EQ(Ends("\"no\""), "\"n|o\"");
  EXPECT_EQ(Ends("\u201Eso\u201C \u00BBso\u00AB \u00ABso\u00BB"),
            "\u201Es|o\u201C \u00BBs|o\u00AB \u00ABs|o\u00BB");
  EXPECT_EQ(Ends("'\"no,\"' (\"a\")"), "'\"n|o,\"' (\"a\")");
  EXPECT_EQ(Ends("so-\"a\" half-\" b"), "s|o-|\"a\" h|a|l|f-\" b");
}

TEST(LineEnds, StandBehindHyphensAndStrokes) {
  EXPECT_EQ(Ends("to-do and/or"), "t|o-|d|o a|n|d/|o|r");
  EXPECT_EQ(Ends("no--on"), "n|o--|o|n");
  EXPECT_EQ(Ends("-ab --ab ...ab"), "-a|b --a|b ...a|b");
}

// Neither "don" nor "t" is a word.
TEST(LineEnds, KeepAnApostropheWithBothSides) {
  EXPECT_EQ(Ends("don't boys'"), "d|o|n't b|o|y|s'");
}

// UAX #14, class GL; French sets such a space before high marks and within its quotation marks.
TEST(LineEnds, AreNoneAtANoBreakSpace) {
  EXPECT_EQ(Spaces("10\u202F000\u00A0F a b"), "10_000_F a b");
  EXPECT_EQ(Spaces("\u00AB\u00A0so\u202F!\u00A0\u00BB a\u202F; b"), "\u00AB_so_!_\u00BB a_, b");
  EXPECT_EQ(Spaces("a  b \u00A0c"), "a  b _c");
}

// Rules LB13 and LB14 of UAX #14; who types has the plain space only.
TEST(LineEnds, AreNoneAtASpaceBesideAMarkThatStandsAlone) {
  EXPECT_EQ(Spaces("\u00AB so ? \u00BB dit-il : \u00AB non ! \u00BB (a) [ b ]"),
            "\u00AB_so_?_\u00BB dit-il_: \u00AB_non_!_\u00BB (a) [_b_]");
  EXPECT_EQ(Spaces("er \u00BBso\u00AB und \u201Eso\u201C - a"),
            "er \u00BBso\u00AB und \u201Eso\u201C - a");
  EXPECT_EQ(Spaces("a \u00BFb? \u00A1c! \"d\" e ... f * g"),
            "a \u00BFb? \u00A1c! \"d\" e ... f * g");
}

TEST(LineEnds, StandBetweenCharactersOfScriptsThatPartNoWords) {
  EXPECT_EQ(Spaces("\u4F60\u597D\uFF0C\u201C\u4E16\u754C\u201D\u3002ab\u4E00"),
            "\u4F60|\u597D\uFF0C|\u201C\u4E16|\u754C\u201D\u3002|ab|\u4E00");
}

}  // namespace
}  // namespace moontrace
