#include "textures/typeset/fold.h"

#include <gtest/gtest.h>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

using Kind = FoldedChar::Kind;

std::vector<std::vector<FoldedChar>> FoldLines(std::string_view text, const Script& script) {
  Folder folder(text, script);
  std::vector<std::vector<FoldedChar>> lines;
  for (std::vector<FoldedChar> line; folder.NextLine(line);) lines.push_back(line);
  return lines;
}

// Folded characters as text: '_' for a blank, '?' for what is missing.
std::string Folded(std::string_view text) {
  std::string result;
  const auto lines = FoldLines(text, SmallScript());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) result += '\n';
    for (const FoldedChar& c : lines[i]) {
      if (c.kind == Kind::kSign) result += ToUtf8(c.code);
      if (c.kind == Kind::kSpace) result += '_';
      if (c.kind == Kind::kMissing) result += '?';
    }
  }
  return result;
}

std::string ErrorOf(std::string_view text) {
  const Script script = SmallScript();
  try {
    Folder folder(text, script);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Folder, DropsCaseWithoutCallingItAChange) {
  const auto lines = FoldLines("AbZ", SmallScript());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(Folded("AbZ"), "abz");
  for (const FoldedChar& c : lines[0]) EXPECT_FALSE(c.changed);
}

TEST(Folder, DropsAccentsInEitherUnicodeForm) {
  EXPECT_EQ(Folded("caf\u00E9 \u00C0\u0148"), "cafe_an");
  EXPECT_EQ(Folded("cafe\u0301"), "cafe");
  const auto lines = FoldLines("e\u0301x", SmallScript());
  ASSERT_EQ(lines[0].size(), 2u);
  EXPECT_TRUE(lines[0][0].changed);
  EXPECT_EQ(lines[0][0].begin, 0u);
  EXPECT_EQ(lines[0][0].end, 3u);  // e and the two bytes of its accent
  EXPECT_EQ(lines[0][1].begin, 3u);
  EXPECT_EQ(lines[0][1].column, 3u);
}

TEST(Folder, PrefersTheScriptsOwnTableInEitherUnicodeForm) {
  EXPECT_EQ(Folded("\u00F6"), "oe");   // Unicode alone would say o
  EXPECT_EQ(Folded("o\u0308"), "oe");  // o and a combining diaeresis
  EXPECT_EQ(Folded("\u00D6"), "oe");
  EXPECT_EQ(Folded("\u00C6;"), "ae,");
  EXPECT_EQ(Folded("a\u2014b"), "a_-_b");
}

TEST(Folder, OpensLigaturesAndCompatibilityForms) {
  EXPECT_EQ(Folded("\uFB01x"), "fix");
  EXPECT_EQ(Folded("stra\u00DFe"), "strasse");
  EXPECT_EQ(Folded("\u2026"), "...");
  EXPECT_EQ(Folded("\uFF21\uFF11"), "a1");  // full width
}

TEST(Folder, GivesAnExpansionsRangeToItsFirstCharacter) {
  const auto lines = FoldLines("\uFB01", SmallScript());
  ASSERT_EQ(lines[0].size(), 2u);
  EXPECT_EQ(lines[0][0].begin, 0u);
  EXPECT_EQ(lines[0][0].end, 3u);
  EXPECT_EQ(lines[0][1].begin, 3u);
  EXPECT_EQ(lines[0][1].end, 3u);
}

TEST(Folder, LeavesACharacterMissingAsAWhole) {
  EXPECT_EQ(Folded("\u65E5"), "?");
  EXPECT_EQ(Folded("\u00B4"), "?");  // decomposes to a space and an accent: not a blank
  EXPECT_EQ(Folded("\u2479"), "?");  // (6): its brackets have no sign here
  EXPECT_EQ(Folded("\u304B\u3099"), "?");
}

TEST(Folder, LeavesControlCharactersMissing) {
  EXPECT_EQ(Folded(std::string_view("a\0b\x1B", 4)), "a?b?");
}

TEST(Folder, TakesBlanksOfAnyWidth) { EXPECT_EQ(Folded("a\tb\u00A0c\u2003d"), "a_b_c_d"); }

TEST(Folder, TakesAwayWhatHasNoMarkInPrint) {
  const auto lines = FoldLines("a\u00ADb", SmallScript());
  ASSERT_EQ(lines[0].size(), 3u);
  EXPECT_EQ(lines[0][1].kind, Kind::kNothing);
  EXPECT_TRUE(lines[0][1].changed);
}

// A line of 200,000 words: no part is much longer than promised, none begins or ends within a word,
// and together they are the line.
TEST(Folder, GivesAVeryLongLineInPartsThatEndBehindABlank) {
  std::string text;
  while (text.size() < 800'000) text += "abe ";
  text += "\nz";
  const Script script = SmallScript();
  Folder folder(text, script);
  std::vector<FoldedChar> line;
  std::size_t characters = 0, parts = 0;
  while (folder.NextLine(line) && folder.line_number() == 1) {
    EXPECT_EQ(folder.begins_line(), parts == 0);
    ASSERT_LE(line.size(), kLinePart + 4);
    if (line.empty()) continue;  // the line's end may stand alone
    EXPECT_EQ(line.front().begin, characters);
    EXPECT_EQ(line.front().column, characters + 1);
    EXPECT_EQ(line.back().kind, Kind::kSpace);
    characters += line.size();
    ++parts;
  }
  EXPECT_EQ(characters, 800'000u);
  EXPECT_EQ(parts, 800'000 / kLinePart + 1);
  EXPECT_TRUE(folder.begins_line());
  EXPECT_EQ(folder.line_number(), 2u);
  ASSERT_EQ(line.size(), 1u);
  EXPECT_EQ(line[0].column, 1u);
}

TEST(Folder, PartsEvenAWordWithoutAnEnd) {
  const std::string text(5 * kLinePart, 'a');
  std::size_t characters = 0;
  for (const auto& part : FoldLines(text, SmallScript())) {
    EXPECT_LE(part.size(), 2 * kLinePart + 1);
    characters += part.size();
  }
  EXPECT_EQ(characters, text.size());
}

TEST(Folder, EndsLinesAtEveryKindOfLineEnd) {
  EXPECT_EQ(Folded("a\nb\r\nc\rd\u2028e\ff"), "a\nb\nc\nd\ne\nf");
  EXPECT_EQ(Folded("a\n\nb\n"), "a\n\nb");
}

TEST(Folder, SkipsTheByteOrderMark) {
  const auto lines = FoldLines("\uFEFFab", SmallScript());
  ASSERT_EQ(lines[0].size(), 2u);
  EXPECT_EQ(lines[0][0].begin, 3u);
  EXPECT_EQ(lines[0][0].column, 1u);
}

TEST(Folder, CountsColumnsInCharactersNotBytes) {
  const auto lines = FoldLines("\u00E9\u65E5x", SmallScript());
  ASSERT_EQ(lines[0].size(), 3u);
  EXPECT_EQ(lines[0][2].column, 3u);
  EXPECT_EQ(lines[0][2].begin, 5u);
}

TEST(Folder, SetsRaisedDigitsApartFromTheNumberBesideThem) {
  const auto lines = FoldLines("2\u00B2", SmallScript());
  ASSERT_EQ(lines[0].size(), 2u);
  EXPECT_FALSE(lines[0][0].apart);
  EXPECT_TRUE(lines[0][1].apart);
}

TEST(Folder, SaysWhereTextIsNotUtf8) {
  EXPECT_EQ(ErrorOf("ab\ncd\xFF"),
            "the text is not UTF-8 at byte offset 5 (line 2, column 3): save it as UTF-8");
  EXPECT_NE(ErrorOf("\xC0\x80").find("byte offset 0"), std::string::npos);       // overlong
  EXPECT_NE(ErrorOf("a\xED\xA0\x80").find("byte offset 1"), std::string::npos);  // surrogate
  EXPECT_NE(ErrorOf("a\xE2\x82").find("byte offset 1"), std::string::npos);      // cut short
  EXPECT_NE(ErrorOf("\uFEFF\r\n\r\u00E9\xFF").find("(line 3, column 2)"), std::string::npos);
}

TEST(Folder, RefusesEmptyText) {
  EXPECT_NE(ErrorOf("").find("empty"), std::string::npos);
  EXPECT_NE(ErrorOf("\uFEFF").find("empty"), std::string::npos);
}

TEST(Folder, RefusesTextOverItsLimit) {
  EXPECT_EQ(ErrorOf(std::string(kMostText, 'a')), "");
  EXPECT_EQ(ErrorOf(std::string(kMostText + 1, 'a')),
            "the text has 17 MB, at most 16 MB are taken: split it");
}

TEST(Shown, WritesOutWhatATerminalWouldObey) {
  EXPECT_EQ(Shown("\x1B[2J"), "U+001B[2J");
  EXPECT_EQ(Shown("\u65E5"), "\u65E5");
  EXPECT_EQ(Shown("\u202E"), "U+202E");
  EXPECT_EQ(Shown(std::string(40, 'a')), std::string(16, 'a') + "...");
}

}  // namespace
}  // namespace moontrace
