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

}  // namespace
}  // namespace moontrace
