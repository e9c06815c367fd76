#include "textures/typeset/back_translate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/louis.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

const Script& Moon() {
  static const Script moon = FindScript("moon");
  return moon;
}

BackTranslation Back(std::string_view text, double grade = 1, const std::string& form = "") {
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, Moon());
  style.grade = grade;
  style.h_form = form;
  return TranslateBack(text, Moon(), style);
}

TEST(BackTranslation, ReadsMoonByItsRules) {
  EXPECT_EQ(Back("The band, and then 1989.").text, "the band, and then 1989.\n");
  EXPECT_EQ(Back("4th of 12: three").text, "4th of 12: three\n");
  EXPECT_EQ(Back("a  b\n\nc").text, "a b\n\nc\n");
  EXPECT_EQ(Back("th po|thole").text, "th pothole\n");
  EXPECT_EQ(Back("which church", 2).text, "which church\n");
  EXPECT_EQ(Back("I like yesterday", 2).text, "i like yesterday\n");
  EXPECT_EQ(Back("Hath 8", 1, "reverse-n").text, "hath 8\n");
}

/// Reads the rows of a page whose lines are `width_mm` wide.
BackTranslation BackFromPage(std::string_view text, double width_mm) {
  const TypeStyle style = DefaultStyle(0.010, Relief::kEngraved, Moon());
  const PageSpec page{"custom", width_mm / 1000 + 0.010, 0.200, 0.005};
  RowSigns rows;
  SetPages(text, Moon(), style, page, [&rows](TextPage&& one) { rows.Add(one); });
  return TranslateBack(text, Moon(), style, &rows);
}

TEST(BackTranslation, ReadsTheRowsOfAPage) {
  const std::string text =
      "The band, and \"then\" 1234567890123 years...\n\nwait... 3.14 it's (no) 4th R&D\n";
  for (double width_mm = 30; width_mm < 200; width_mm += 1) {
    EXPECT_EQ(BackFromPage(text, width_mm).text, Back(text).text) << width_mm;
  }
}

// A row that has room for one sign has none for a numeral sign of its own.
TEST(BackTranslation, ReadsABrokenNumberWithoutItsSignAsLetters) {
  const BackTranslation back = BackFromPage("12", 10);
  EXPECT_EQ(back.differ_count, 1U);
}

// What differs is told as it was written, not as it was folded.
TEST(BackTranslation, QuotesTheTextAsItWasWritten) {
  const BackTranslation back = Back("\u00C9tude \u201E3D\u201C 3D");
  ASSERT_EQ(back.differ.size(), 2U);
  EXPECT_EQ(back.differ[0].first, "\u201E3D\u201C");
  EXPECT_EQ(back.differ[1].first, "3D");
}

// What the script cannot tell apart (moon-script reference, sections 5 and 7).
TEST(BackTranslation, ShowsWhatMoonCannotTellApart) {
  const BackTranslation digits = Back("3d");
  EXPECT_EQ(digits.text, "34\n");
  ASSERT_EQ(digits.differ.size(), 1U);
  EXPECT_EQ(digits.differ[0].first, "3d");
  EXPECT_EQ(digits.differ[0].second, "34");
  EXPECT_EQ(Back("l", 2).text, "like\n");
  EXPECT_EQ(Back("l", 1).text, "l\n");
}

// Reference, section 6: three dots mark an ellipsis, a comma has one dot and a full stop two.
TEST(BackTranslation, ReadsThreeDotsAsAnEllipsis) {
  EXPECT_EQ(Back("wait... so\u2026 (...) a, b.").text, "wait... so... (...) a, b.\n");
  EXPECT_EQ(Back("the end....", 0.5).text, "the end....\n");
  EXPECT_EQ(Back("the...the", 1).text, "the...the\n");
}

// Section 5: AND stands only for the whole word, which an ampersand is.
TEST(BackTranslation, ReadsAnAmpersandAsAWord) {
  for (const double grade : {0.5, 1.0, 2.0}) {
    EXPECT_EQ(Back("R&D, r & d (&) 3&4 &c.", grade).text,
              "r and d, r and d (and) 3 and 4 and c.\n");
    EXPECT_EQ(Back("R&D", grade).differ_count, 0U);
  }
}

// What is written in the same signs is told so: "3d" and "34", at grade 2 "l" and "like".
TEST(BackTranslation, TellsWhatIsWrittenAlike) {
  const BackTranslation digits = Back("3d or 34");
  ASSERT_EQ(digits.differ_count, 1U);
  EXPECT_EQ(digits.alike_count, 1U);
  EXPECT_TRUE(digits.differ[0].alike);
  EXPECT_EQ(Back("l", 2).alike_count, 1U);
}

TEST(BackTranslation, LettersNotTaughtDiffer) {
  TypeStyle style = DefaultStyle(0.012, Relief::kEngraved, Moon());
  style.only = {"i", "t"};
  const BackTranslation back = TranslateBack("it sit", Moon(), style);
  EXPECT_EQ(back.text, "it it\n");
  EXPECT_EQ(back.differ_count, 1U);
}

// Debian's list of American English words (package wamerican, public domain), each on its line.
TEST(BackTranslation, GivesBackTenThousandEnglishWords) {
  std::ifstream in("/usr/share/dict/american-english");
  if (!in) GTEST_SKIP() << "no list of words: install wamerican";
  std::string text, lower;
  std::size_t words = 0, number = 0;
  for (std::string word; std::getline(in, word);) {
    if (++number % 5 != 0) continue;
    const bool ascii = std::all_of(word.begin(), word.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    if (!ascii) continue;
    text += word + '\n';
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return static_cast<char>(std::tolower(c)); });
    lower += word + '\n';
    ++words;
  }
  ASSERT_GE(words, 10000U);
  for (const double grade : {0.5, 1.0}) {
    const BackTranslation back = Back(text, grade);
    EXPECT_TRUE(back.text == lower) << "at grade " << grade;
    EXPECT_EQ(back.differ_count, 0U)
        << back.differ.front().first << " reads " << back.differ.front().second;
    EXPECT_EQ(back.words, words);
  }
}

class BrailleBackTranslation : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      BrailleTable("en-ueb-g1.ctb");
    } catch (const LackError&) {
      GTEST_SKIP() << "built without liblouis";
    }
  }
  static BackTranslation Back(std::string_view text, double grade, const std::string& table = "") {
    const Script braille = FindScript("braille");
    TypeStyle style = DefaultStyle(braille.size, Relief::kEngraved, braille);
    style.grade = grade;
    style.table = table;
    return TranslateBack(text, braille, style);
  }
};

// liblouis' own back-translation gives a typographic apostrophe, "(x's)", "getopt.have", "ABM'S"
// and passages of capitals in small letters.
TEST_F(BrailleBackTranslation, ReadsWhatLiblouisMisreads) {
  const std::string text =
      "It's (it's) there. ABM's AF \u2018so\u2019 getopt.h, e.g. C++ Benghazi's... DON'T "
      "std::cout\n"
      "THIS SOFTWARE IS A GIFT, \"AS IS\", AND FREE OF CHARGE; see \"ABOUT THIS PROGRAM\" there.\n";
  for (const double grade : {1.0, 2.0}) {
    const BackTranslation back = Back(text, grade);
    EXPECT_EQ(back.text, text) << "at grade " << grade;
    EXPECT_EQ(back.differ_count, 0U);
  }
}

// Unified English Braille has one sign for the apostrophe, typewritten or printed.
TEST_F(BrailleBackTranslation, TellsWhatIsWrittenAlike) {
  for (const double grade : {1.0, 2.0}) {
    const BackTranslation back = Back("it\u2019s so", grade);
    EXPECT_EQ(back.text, "it's so\n");
    EXPECT_EQ(back.differ_count, 1U);
    EXPECT_EQ(back.alike_count, 1U);
  }
  // German Braille at its usual setting leaves capitals unmarked
  const BackTranslation german = Back("Haus", 1, "de-g1.ctb");
  EXPECT_EQ(german.text, "haus\n");
  EXPECT_EQ(german.alike_count, 1U);
}

// A low quotation mark, which the English tables lack, opens like the others.
TEST_F(BrailleBackTranslation, LeavesNoQuotationMarkOut) {
  const BackTranslation low = Back("\u201Eso\u201D", 1);
  EXPECT_EQ(low.left_out, 0U);
  EXPECT_EQ(low.replaced, 1U);
  EXPECT_EQ(low.text, Back("\u201Cso\u201D", 1).text);
  EXPECT_EQ(Back("\u201Eso\u201C", 1, "de-g1.ctb").replaced, 0U);  // has one of its own
}

// A tenth of Debian's list of American English (package wamerican), each word on its line.
TEST_F(BrailleBackTranslation, GivesBackTenThousandEnglishWords) {
  std::ifstream in("/usr/share/dict/american-english");
  if (!in) GTEST_SKIP() << "no list of words: install wamerican";
  std::string text;
  std::size_t words = 0, number = 0;
  for (std::string word; std::getline(in, word);) {
    if (++number % 10 != 0) continue;
    text += word + '\n';
    ++words;
  }
  ASSERT_GE(words, 10000U);
  for (const double grade : {1.0, 2.0}) {
    const BackTranslation back = Back(text, grade);
    EXPECT_EQ(back.words, words);
    EXPECT_EQ(back.left_out, 0U);
    // one word in two thousand, a tenth of what is wanted of any reader
    EXPECT_LT(2000 * back.differ_count, words) << back.differ.front().first;
  }
}

TEST_F(BrailleBackTranslation, ReadsByLiblouis) {
  const Script braille = FindScript("braille");
  TypeStyle style = DefaultStyle(braille.size, Relief::kEngraved, braille);
  for (const double grade : {1.0, 2.0}) {
    style.grade = grade;
    const BackTranslation back = TranslateBack("The quick fox, 12 times.", braille, style);
    EXPECT_EQ(back.text, "The quick fox, 12 times.\n");
    EXPECT_EQ(back.differ_count, 0U);
  }
}

}  // namespace
}  // namespace moontrace
