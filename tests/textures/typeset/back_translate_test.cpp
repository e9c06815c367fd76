#include "textures/typeset/back_translate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/louis.h"

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

TEST(BackTranslation, ReadsBrailleByLiblouis) {
  try {
    BrailleTable("en-ueb-g1.ctb");
  } catch (const LackError&) {
    GTEST_SKIP() << "built without liblouis";
  }
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
