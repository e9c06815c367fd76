#include "textures/typeset/typeset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/layout.h"

namespace moontrace {
namespace {

// Letters of 10 mm on a page whose lines hold `columns` letters of the small script: strokes reach
// half an em, so n letters need n - 0.5 em; and `rows` lines, pitch 20 mm.
TypeStyle Style() {
  TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, SmallScript());
  style.line_pitch = 0.020;
  return style;
}
PageSpec Page(int columns, int rows) {
  PageSpec page;
  page.name = "custom";
  page.margin = 0.005;
  page.width = 0.010 + 0.010 * columns - 0.005;
  page.height = 0.010 + 0.010 + 0.020 * (rows - 1);
  return page;
}

Typeset Set(std::string_view text, int columns, int rows) {
  return SetText(text, SmallScript(), Style(), Page(columns, rows));
}

// Rows as text: letters at their column (the advance is 10 mm), '\n' between rows, '=' between
// pages.
std::string Drawn(const Typeset& set) {
  const Script script = SmallScript();
  std::string result;
  for (const TextPage& page : set.pages) {
    if (!result.empty()) result += '=';
    std::vector<std::string> rows(page.lines);
    for (const PlacedGlyph& placed : page.glyphs) {
      const auto column =
          static_cast<std::size_t>(std::lround((placed.origin_P.x - set.page.margin) / 0.010));
      std::string& row = rows.at(placed.line);
      row.resize(std::max(row.size(), column + 1), ' ');
      const std::string& name = script.glyphs[placed.glyph].name;
      row[column] = name.size() == 1 ? name[0] : name == "hyphen" ? '-' : '#';
    }
    for (std::size_t i = 0; i < rows.size(); ++i) result += (i > 0 ? "\n" : "") + rows[i];
  }
  return result;
}

template <typename Call>
std::string ErrorOf(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SetText, PutsTheFirstBaseLineOneEmBelowTheTopMargin) {
  const Typeset set = Set("ab\nc", 5, 3);  // page 70 mm high, margin 5 mm
  ASSERT_EQ(set.pages.size(), 1u);
  ASSERT_EQ(set.pages[0].glyphs.size(), 3u);
  // To rounding: sums of a few lengths below 0.1 m.
  EXPECT_NEAR(set.pages[0].glyphs[0].origin_P.x, 0.005, 1e-15);
  EXPECT_NEAR(set.pages[0].glyphs[0].origin_P.y, Page(5, 3).height - 0.015, 1e-15);
  EXPECT_NEAR(set.pages[0].glyphs[1].origin_P.x, 0.015, 1e-15);
  EXPECT_NEAR(set.pages[0].glyphs[2].origin_P.x, 0.005, 1e-15);
  EXPECT_NEAR(set.pages[0].glyphs[2].origin_P.y, Page(5, 3).height - 0.035, 1e-15);
}

TEST(SetText, AddsTheGapsToTheAdvances) {
  TypeStyle style = Style();
  style.letter_gap = 0.002;
  style.word_gap = 0.005;
  const Typeset set = SetText("ab c", SmallScript(), style, Page(20, 1));
  // a at 0, b at 10 + 2, space at 24, c at 24 + 10 + 5 mm.
  EXPECT_NEAR(set.pages[0].glyphs[1].origin_P.x - 0.005, 0.012, 1e-15);
  EXPECT_NEAR(set.pages[0].glyphs[2].origin_P.x - 0.005, 0.039, 1e-15);
}

TEST(SetText, WrapsAtSpaces) {
  EXPECT_EQ(Drawn(Set("abc de fgh", 6, 9)), "abc de\nfgh");
  EXPECT_EQ(Drawn(Set("abc de fgh", 5, 9)), "abc\nde\nfgh");
  EXPECT_EQ(Drawn(Set("abcde fg", 5, 9)), "abcde\nfg");  // just fits
}

TEST(SetText, WrapsBehindHyphens) {
  EXPECT_EQ(Drawn(Set("ab cd-ef", 6, 9)), "ab cd-\nef");
  EXPECT_EQ(Drawn(Set("ab cd-ef", 5, 9)), "ab\ncd-ef");
  EXPECT_EQ(Drawn(Set("ab -cd", 5, 9)), "ab\n-cd");
}

// A line that comes in parts (fold.h) is set as one: each row full, none begun for a part.
TEST(SetText, SetsAVeryLongLineAsOne) {
  std::string text;
  while (text.size() < 3 * kLinePart) text += "ab ";
  const Typeset set = Set(text, 24, 40);  // eight words a row
  std::size_t rows = 0, words = 0;
  for (const TextPage& page : set.pages) {
    for (const PlacedGlyph& placed : page.glyphs) {
      if (placed.source_begin % 3 != 0) continue;
      ASSERT_EQ(rows + placed.line, words / 8) << placed.source_begin;
      ++words;
    }
    rows += page.lines;
  }
  EXPECT_EQ(words, text.size() / 3);
}

TEST(SetText, KeepsTheKindOfAVeryLongLine) {
  std::string text = "> ";
  while (text.size() < 3 * kLinePart) text += "# ab ";
  TypeStyle style = Style();
  style.structure.read = true;
  for (const LineDirection lines : {LineDirection::kLeftToRight, LineDirection::kAlternate}) {
    style.lines = lines;
    const Typeset set = SetText(text, SmallScript(), style, Page(24, 40));
    EXPECT_EQ(set.structure.quotations, 1u);
    EXPECT_EQ(set.structure.headings, 0u);
    std::size_t last_row = 0, rows = 0, letters = 0;
    for (const TextPage& page : set.pages) {
      for (const PlacedGlyph& placed : page.glyphs) {
        ASSERT_EQ(placed.kind, LineKind::kQuotation);
        ASSERT_LE(rows + placed.line, last_row + 1);  // no empty row
        last_row = rows + placed.line;
        ++letters;
      }
      rows += page.lines;
    }
    EXPECT_EQ(letters, 2 * (text.size() / 5));
  }
}

TEST(SetText, BreaksAWordThatNoLineHolds) {
  EXPECT_EQ(Drawn(Set("ab cdefghi", 4, 9)), "ab\ncdef\nghi");
}

TEST(SetText, KeepsTheNumeralSignWithItsDigit) {
  // Too long for a line: x y z, then the sign and its digits.
  EXPECT_EQ(Drawn(Set("xyz12", 4, 9)), "xyz\n#ab");
}

// Behind a new line the letters a to j would else be letters.
TEST(SetText, RepeatsTheNumeralSignOfABrokenNumber) {
  EXPECT_EQ(Drawn(Set("1234567", 4, 9)), "#abc\n#def\n#g");
  EXPECT_EQ(Drawn(Set("12,345", 4, 9)), "#ab#\n#cde");  // the first row ends in the comma
  EXPECT_EQ(Drawn(Set("123", 1, 9)), "#\na\nb\nc");     // no room for it
}

TEST(SetText, BeginsNoLineWithAMarkThatCloses) {
  EXPECT_EQ(Drawn(Set("abcd, ef", 4, 9)), "abc\nd#\nef");
  EXPECT_EQ(Drawn(Set("abcd.,. ef", 4, 9)), "abc\nd###\nef");
  EXPECT_EQ(Drawn(Set("ab-, cd", 4, 9)), "ab-#\ncd");
  EXPECT_EQ(Drawn(Set("......", 4, 9)), "####\n##");  // nothing else is left
  EXPECT_EQ(Drawn(Set("a....", 4, 9)), "a\n####");    // the marks at least stay together
  EXPECT_EQ(Drawn(Set("abc...", 3, 9)), "abc\n###");  // and c, which they leave, stays with a and b
}

TEST(SetText, PartsNoMarkThatOpensFromItsWord) {
  EXPECT_EQ(Drawn(Set("ab -,cdef", 4, 9)), "ab\n-#cd\nef");
}

TEST(SetText, WrapsAtNoSpaceThatKeepsItsSides) {
  EXPECT_EQ(Drawn(Set("x ab\u00A0cd", 6, 9)), "x\nab cd");
  EXPECT_EQ(Drawn(Set("abc def ; g", 8, 9)), "abc\ndef # g");  // a mark that closes
  // where no line holds all, rather there than within a word
  EXPECT_EQ(Drawn(Set("ab\u00A0cde\u00A0fg", 5, 9)), "ab\ncde\nfg");
  EXPECT_EQ(Drawn(Set("\u00A0 abcd\u00A0;", 4, 9)), "abc\nd #");
}

TEST(SetText, CountsWordsAcrossNoBreakSpaces) {
  const Typeset set = Set("ab\u00A0cd e", 8, 1);
  const auto& glyphs = set.pages.at(0).glyphs;
  ASSERT_EQ(glyphs.size(), 5U);
  EXPECT_EQ(glyphs[1].word, 0U);
  EXPECT_EQ(glyphs[2].word, 1U);
  EXPECT_EQ(glyphs[4].word, 2U);
}

TEST(SetText, KeepsMarksInAlternatingLines) {
  Script script = SmallScript();
  TypeStyle style = Style();
  style.lines = LineDirection::kAlternate;
  AddGuides(script, style);
  std::string text;
  for (std::size_t i = 0; i < 60; ++i) text += std::string(1 + i % 5, 'x') + "., 123456 ";
  const std::size_t numeral = script.Find("numeral");
  const Typeset set = SetText(text, script, style, Page(14, 40));
  std::size_t row = ~std::size_t{0}, before = numeral, repeated = 0;
  for (const PlacedGlyph& placed : set.pages.front().glyphs) {
    const std::size_t last = std::exchange(before, placed.glyph);
    if (placed.bridge) {
      EXPECT_NE(last, numeral) << placed.line;
      continue;
    }
    const bool begins = std::exchange(row, placed.line) != placed.line;
    if (!begins) continue;
    const char first = text[placed.source_begin];
    EXPECT_TRUE(first != '.' && first != ',') << placed.line;
    const bool digit = first >= '1' && first <= '6';
    EXPECT_EQ(placed.glyph == numeral, digit) << placed.line;
    if (first > '1' && first <= '6') ++repeated;
  }
  EXPECT_GT(repeated, 0U);
}

// Under the guide of a short line there may be room for the sign alone.
TEST(SetText, KeepsTheNumeralSignInAlternatingLines) {
  Script script = SmallScript();
  TypeStyle style = Style();
  style.lines = LineDirection::kAlternate;
  AddGuides(script, style);
  const std::size_t numeral = script.Find("numeral");
  for (int columns = 5; columns < 16; ++columns) {
    const Typeset set =
        SetText("abc, de 1234567890 abcd 12 abcde 1 a 12", script, style, Page(columns, 40));
    std::size_t before = script.glyphs.size();
    for (const PlacedGlyph& placed : set.pages.front().glyphs) {
      const std::size_t last = std::exchange(before, placed.glyph);
      if (placed.bridge) {
        EXPECT_NE(last, numeral) << columns << ", " << placed.line;
      }
    }
  }
}

TEST(SetText, KeepsLinesAndBlanksAsTyped) {
  EXPECT_EQ(Drawn(Set("a\n  b  c\nd", 9, 9)), "a\n  b  c\nd");
  EXPECT_EQ(Drawn(Set("ab   cd", 4, 9)), "ab\ncd");  // blanks at the wrap go
}

TEST(SetText, KeepsOneEmptyLineBetweenParagraphs) {
  EXPECT_EQ(Drawn(Set("a\n\nb", 4, 9)), "a\n\nb");
  EXPECT_EQ(Drawn(Set("\n\na\n \n\n\nb\n\n", 4, 9)), "a\n\nb");
}

TEST(SetText, StartsNewPages) {
  const Typeset set = Set("a\nb\nc\nd\ne", 4, 2);
  EXPECT_EQ(Drawn(set), "a\nb=c\nd=e");
  EXPECT_EQ(set.pages[2].glyphs[0].line, 0u);
  EXPECT_EQ(set.pages[2].glyphs[0].origin_P, set.pages[0].glyphs[0].origin_P);
}

TEST(SetText, LeavesNoEmptyLineAtTheTopOfAPage) {
  EXPECT_EQ(Drawn(Set("a\nb\n\nc", 4, 2)), "a\nb=c");
  EXPECT_EQ(Drawn(Set("a\n\nc", 4, 2)), "a=c");  // the empty line is the page's last
}

TEST(SetText, CountsWordsThroughTheText) {
  const Typeset set = Set("ab c-d\nefghi j", 4, 2);
  std::vector<std::size_t> words;
  for (const TextPage& page : set.pages) {
    for (const PlacedGlyph& placed : page.glyphs) words.push_back(placed.word);
  }
  EXPECT_EQ(words, (std::vector<std::size_t>{0, 0, 1, 1, 1, 2, 2, 2, 2, 2, 3}));
}

TEST(SetText, TellsWhatItLeftOut) {
  const Typeset set = Set("a\u65E5b", 4, 1);
  EXPECT_EQ(Drawn(set), "ab");
  EXPECT_EQ(set.missing_count, 1u);
  EXPECT_EQ(set.pages[0].glyphs[1].source_begin, 4u);
}

// Without contractions every sign but the numeral stands for one byte of ASCII text, so the ranges
// in order are the text without blanks and without what is missing.
TEST(SetText, CoversEachCharacterOnce) {
  std::mt19937 random(2);
  const std::string alphabet = "abcdefghijklmnopqrstuvwxyzABCTH0123456789.,;-- \n\t!$|";
  for (int round = 0; round < 300; ++round) {
    std::string text = "x";
    const std::size_t length = random() % 200;
    while (text.size() < length) text += alphabet[random() % alphabet.size()];
    std::string expected;
    for (const char c : text) {
      if (std::string(" \n\t!$|").find(c) == std::string::npos) expected += c;
    }
    for (const double grade : {0.5, 1.0}) {
      TypeStyle style = Style();
      style.grade = grade;
      const Typeset set = SetText(text, SmallScript(), style, Page(7, 3));
      std::string covered;
      std::size_t end = 0;
      for (const TextPage& page : set.pages) {
        for (const PlacedGlyph& placed : page.glyphs) {
          ASSERT_LE(end, placed.source_begin) << text;
          end = placed.source_end;
          covered += text.substr(placed.source_begin, end - placed.source_begin);
        }
      }
      EXPECT_EQ(covered, expected) << text;
    }
  }
}

TEST(SetText, KeepsAllStrokesWithinTheMargins) {
  std::mt19937 random(3);
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "abc defgh-\n1"[random() % 12];
  const Typeset set = Set(text, 6, 4);
  ASSERT_GT(set.pages.size(), 50u);
  for (const TextPage& page : set.pages) {
    ASSERT_LE(page.lines, 4u);
    for (const PlacedGlyph& placed : page.glyphs) {
      ASSERT_LT(placed.line, page.lines);
      ASSERT_GE(placed.origin_P.x, set.page.margin);
      // 2 nm: the slack for lines that fit but for rounding, and the rounding itself.
      ASSERT_LE(placed.origin_P.x + 0.005, set.page.width - set.page.margin + 2e-9);
      ASSERT_GE(placed.origin_P.y, set.page.margin - 2e-9);
    }
  }
}

TEST(SetText, RefusesBlankText) {
  EXPECT_EQ(ErrorOf([] { Set(" \n\t\u00A0 ", 4, 1); }),
            "the text is empty or blank: give at least one letter");
}

TEST(SetText, RefusesTextOfWhichNothingIsLeft) {
  EXPECT_EQ(ErrorOf([] { Set("\n\u65E5\u672C", 4, 1); }),
            "nothing left to set: script small has no sign for '\u65E5' (line 2, column 1)");
}

TEST(SetText, RefusesAPageTooSmallForALine) {
  PageSpec page = Page(4, 1);
  page.height -= 0.001;
  EXPECT_EQ(ErrorOf([&] { SetText("a", SmallScript(), Style(), page); }),
            "page: 9 mm within its margins, a line needs 10 mm: choose smaller letters");
}

TEST(SetText, RefusesAPageTooSmallForALetter) {
  PageSpec page = Page(1, 1);
  EXPECT_EQ(ErrorOf([&] { SetText("a", SmallScript(), Style(), page); }), "no error");
  page.width -= 0.001;
  EXPECT_EQ(ErrorOf([&] { SetText("a", SmallScript(), Style(), page); }),
            "lines are 4 mm wide, the letter 'a' needs 5 mm: choose smaller letters");
}

TEST(SetText, RefusesAPageThatIsNoPage) {
  for (const double width : {0.0, -1.0, 0.01, 1e9, std::nan("")}) {
    PageSpec page = Page(4, 1);
    page.width = width;
    EXPECT_NE(ErrorOf([&] { SetText("a", SmallScript(), Style(), page); }), "no error") << width;
  }
}

TEST(FindPage, KnowsThePapersAndTheWorkspace) {
  EXPECT_EQ(FindPage("a4").width, 0.210);
  EXPECT_EQ(FindPage("a4").height, 0.297);
  EXPECT_EQ(FindPage("a5").width, 0.148);
  EXPECT_EQ(FindPage("a5").height, 0.210);
  EXPECT_EQ(FindPage("workspace").width, 0.160);
  EXPECT_EQ(FindPage("workspace").height, 0.120);
  EXPECT_EQ(FindPage("workspace").margin, 0.010);
}

TEST(FindPage, ReadsASizeInMillimetres) {
  const PageSpec page = FindPage("120x90.5");
  EXPECT_EQ(page.name, "custom");
  EXPECT_EQ(page.width, 0.120);
  EXPECT_EQ(page.height, 0.0905);
  EXPECT_EQ(page.margin, 0.010);
}

TEST(FindPage, RefusesOtherNames) {
  for (const char* name : {"", "letter", "custom", "x", "120x", "x90", "120x90mm", "120 x 90",
                           "nanx90", "-120x90", "0x90", "infx90", "1e9x90"}) {
    EXPECT_NE(ErrorOf([&] { FindPage(name); }), "no error") << name;
  }
  EXPECT_NE(ErrorOf([] { FindPage("letter"); }).find("a4, a5, workspace"), std::string::npos);
}

// 10 MB in pages of a book, and as one word without an end: what is kept is a glyph and at most
// the vector's growth for each letter, and 1000 notes.
TEST(SlowSetText, TakesTenMegabytesInBoundedMemory) {
  const std::size_t letters = 10'000'000;
  std::string book, word(letters, 'q');
  while (book.size() < letters) book += "the band played 1989 times, caf\u00E9 \u65E5 and on\n";
  for (const std::string* text : {&book, &word}) {
    const Script script = SmallScript();
    const Typeset set =
        SetText(*text, script, DefaultStyle(0.006, Relief::kEngraved, script), FindPage("a4"));
    std::size_t glyphs = 0, room = 0;
    for (const TextPage& page : set.pages) {
      glyphs += page.glyphs.size();
      room += page.glyphs.capacity();
    }
    EXPECT_GT(glyphs, letters / 2);
    EXPECT_LE(room, 2 * letters);
    EXPECT_LE(set.folded.size() + set.missing.size(), 2000u);
    const auto lines = static_cast<std::size_t>(std::count(text->begin(), text->end(), '\n'));
    EXPECT_EQ(set.missing_count, lines);  // one in each line of the book
    EXPECT_EQ(set.folded_count, lines);
  }
}

TEST(SlowSetText, RefusesMoreSignsThanItKeeps) {
  std::string text;
  while (text.size() < 12'000'000) text += "1a";  // three signs for two bytes
  EXPECT_EQ(ErrorOf([&] { Set(text, 50, 50); }),
            "the text makes more than 16 million signs: split it");
}

bool SamePage(const TextPage& a, const TextPage& b) {
  const auto same = [](const PlacedGlyph& one, const PlacedGlyph& other) {
    return one.glyph == other.glyph && one.origin_P == other.origin_P && one.line == other.line &&
           one.source_begin == other.source_begin && one.word == other.word;
  };
  return a.lines == b.lines && a.sheet_P.max == b.sheet_P.max &&
         a.text_area_P.min == b.text_area_P.min &&
         std::equal(a.glyphs.begin(), a.glyphs.end(), b.glyphs.begin(), b.glyphs.end(), same);
}

// A heading may move from the foot of a page to the next, so that a page is not finished when the
// next begins.
TEST(SetPages, GivesEachPageOnceAsSetTextHasIt) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += i % 3 == 0 ? "# bad\nabe\n" : "cab\n\nbe\n";
  for (const LineDirection lines : {LineDirection::kLeftToRight, LineDirection::kAlternate}) {
    TypeStyle style = Style();
    style.structure.read = true;
    style.lines = lines;
    Script script = SmallScript();
    if (lines == LineDirection::kAlternate) AddGuides(script, style);
    const PageSpec page = Page(12, 5);
    const Typeset whole = SetText(text, script, style, page);
    ASSERT_GT(whole.pages.size(), 10U);
    std::vector<TextPage> taken;
    const Typeset notes = SetPages(text, script, style, page,
                                   [&](TextPage&& one) { taken.push_back(std::move(one)); });
    EXPECT_TRUE(notes.pages.empty());
    EXPECT_EQ(notes.structure.headings, whole.structure.headings);
    ASSERT_EQ(taken.size(), whole.pages.size());
    for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_TRUE(SamePage(taken[i], whole.pages[i]));
  }
}

// Of a text of hundreds of pages the first is there before the end is looked at.
TEST(SetPages, GivesAPageBeforeTheRestIsSet) {
  std::string text;
  for (int i = 0; i < 500; ++i) text += "bad\n";
  std::size_t taken = 0;
  struct Enough {};
  EXPECT_THROW(SetPages(text, SmallScript(), Style(), Page(4, 2),
                        [&](TextPage&&) {
                          if (++taken == 3) throw Enough();
                        }),
               Enough);
  EXPECT_EQ(taken, 3U);
}

}  // namespace
}  // namespace moontrace
