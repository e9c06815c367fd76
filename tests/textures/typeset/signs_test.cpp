#include "textures/typeset/signs.h"

#include <gtest/gtest.h>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

struct Written {
  std::vector<Sign> signs;
  Typeset notes;
  std::string names;  // glyph names, '_' for a space
};

Written Write(std::string_view text, double grade = 1, const Script& script = SmallScript()) {
  const SignWriter writer(script, grade, "");
  Folder folder(text, script);
  std::vector<FoldedChar> line;
  Written result;
  for (std::size_t number = 1; folder.NextLine(line); ++number) {
    writer.Write(text, number, line, result.signs, result.notes);
  }
  for (const Sign& sign : result.signs) {
    if (!result.names.empty()) result.names += ' ';
    result.names += sign.space ? "_" : script.glyphs[sign.glyph].name;
  }
  return result;
}

std::string Names(std::string_view text, double grade = 1) { return Write(text, grade).names; }

// bsblind, Grade 1: AND stands for the whole word only; TH wherever th occurs, alone it is "the".
TEST(Contractions, FollowTheReferenceAtGrade1) {
  EXPECT_EQ(Names("and"), "and");
  EXPECT_EQ(Names("the"), "th");
  EXPECT_EQ(Names("this"), "th i s");
  EXPECT_EQ(Names("bathe"), "b a th e");
  EXPECT_EQ(Names("band"), "b a n d");
  EXPECT_EQ(Names("andes"), "a n d e s");
  EXPECT_EQ(Names("The AND the"), "th _ and _ th");
  EXPECT_EQ(Names("and,the."), "and comma th stop");
}

// The sign TH alone is "the": whoever reads it must not meet it for two letters of their own.
TEST(Contractions, OfAPartOfAWordNeedALetterBesideThem) {
  EXPECT_EQ(Names("th"), "t h");
  EXPECT_EQ(Names("a th, the"), "a _ t h comma _ th");
  EXPECT_EQ(Names("4th"), "numeral d t h");
  EXPECT_EQ(Names("bath"), "b a th");
  EXPECT_EQ(Names("\u65E5th"), "t h");  // what is missing does not stand beside it
}

TEST(Contractions, AreNotPartedFromTheirWordByASoftHyphen) {
  EXPECT_EQ(Names("ba\u00ADthe"), "b a th e");
  EXPECT_EQ(Names("ba\u00ADth"), "b a th");
  EXPECT_EQ(Names("and\u00ADes"), "a n d e s");
}

TEST(Contractions, AreSpelledOutBelowTheirGrade) {
  EXPECT_EQ(Names("and the bath", 0.5), "a n d _ t h e _ b a t h");
}

TEST(Contractions, AtAWordsEndNeedALetterBeforeThem) {
  EXPECT_EQ(Names("sing"), "s mark g");
  EXPECT_EQ(Names("ing"), "i n g");
  EXPECT_EQ(Names("singer"), "s i n g e r");
  EXPECT_EQ(Names("sing."), "s mark g stop");
}

TEST(Contractions, DoNotReachAcrossACharacterThatIsMissing) {
  EXPECT_EQ(Names("t\u65E5h"), "t h");
  EXPECT_EQ(Names("\u65E5and"), "a n d");  // not a word of its own
}

TEST(Contractions, OfSeveralSignsGiveTheirRangeToTheFirst) {
  const Written written = Write("sing");
  ASSERT_EQ(written.signs.size(), 3u);
  EXPECT_EQ(written.signs[1].begin, 1u);
  EXPECT_EQ(written.signs[1].end, 4u);
  EXPECT_EQ(written.signs[2].begin, 4u);
  EXPECT_EQ(written.signs[2].end, 4u);
}

TEST(ProtectMark, KeepsAGroupSpelledOutAndIsNotShown) {
  EXPECT_EQ(Names("|and ba|th |the"), "a n d _ b a t h _ t h e");
  EXPECT_EQ(Write("|and").notes.missing_count, 0u);
}

TEST(ProtectMark, IsNotShownBelowTheGroupsGradeEither) {
  EXPECT_EQ(Names("ba|th", 0.5), "b a t h");
  EXPECT_EQ(Write("ba|th", 0.5).notes.missing_count, 0u);
}

TEST(ProtectMark, IsACharacterLikeOthersElsewhere) {
  const Written written = Write("a|b");
  EXPECT_EQ(written.names, "a b");
  ASSERT_EQ(written.notes.missing.size(), 1u);
  EXPECT_EQ(written.notes.missing[0].was, "|");
  EXPECT_EQ(written.notes.missing[0].column, 2u);
}

// moonliteracy glossary: 23 = sign b c, 207 = sign b j g; mychristmascards: 1989 = sign a i h i.
TEST(Numbers, HaveTheNumeralSignOnceBeforeThem) {
  EXPECT_EQ(Names("23"), "numeral b c");
  EXPECT_EQ(Names("207"), "numeral b j g");
  EXPECT_EQ(Names("1989"), "numeral a i h i");
  EXPECT_EQ(Names("in 1989 b"), "i n _ numeral a i h i _ b");
}

TEST(Numbers, EndAtAnythingThatIsNotADigit) {
  EXPECT_EQ(Names("3.14"), "numeral c stop numeral a d");
  EXPECT_EQ(Names("1 2"), "numeral a _ numeral b");
  EXPECT_EQ(Names("1\u65E5"
                  "2"),
            "numeral a numeral b");
  EXPECT_EQ(Names("3x4"), "numeral c x numeral d");
}

TEST(Numbers, CannotTellALetterThatFollowsDirectly) {
  EXPECT_EQ(Names("3d"), "numeral c d");  // as 34: Moon has no sign that ends a number
}

// The letters a to j as "became" says, the same as the numbers' test above: j is 0.
std::string Doubtful(std::string_view text) {
  std::string result;
  for (const Replacement& r : Write(text).notes.doubtful) {
    result += r.was + "=" + r.became + "@" + std::to_string(r.column) + " ";
  }
  return result;
}

TEST(Notes, TellWhichLettersReadAsDigits) {
  EXPECT_EQ(Doubtful("3a"), "a=1@2 ");
  EXPECT_EQ(Doubtful("x 12Hj"), "H=8@5 j=0@6 ");
  EXPECT_EQ(Doubtful("3\u00E9"), "\u00E9=5@2 ");
  EXPECT_EQ(Doubtful("3\u00E6"), "\u00E6=1@2 e=5@2 ");
  EXPECT_EQ(Doubtful("3\u00ADa 3\u65E5"
                     "b"),
            "a=1@3 b=2@7 ");  // nothing is seen between them
  EXPECT_EQ(Write("3a").notes.doubtful_count, 1u);
}

TEST(Notes, DoubtNoLetterThatANumberDoesNotReach) {
  EXPECT_EQ(Doubtful("a 3 a 3xa 3-a 3k a3 3the"), "");
  EXPECT_EQ(Doubtful("3ka"), "");   // k ends the number
  EXPECT_EQ(Doubtful("3and"), "");  // the sign AND
}

TEST(Notes, NameWhatCannotBeSeen) {
  const Written written = Write("ab\u200B");
  ASSERT_EQ(written.notes.folded.size(), 1u);
  EXPECT_EQ(written.notes.folded[0].was, "U+200B");
  EXPECT_EQ(written.notes.folded[0].name, "zero width space (U+200B)");
  EXPECT_EQ(written.notes.folded[0].became, "");
}

TEST(Numbers, DoNotRunIntoRaisedDigits) { EXPECT_EQ(Names("10\u00B2"), "numeral a j numeral b"); }

TEST(Numbers, HaveASignWithAnEmptyRangeAtTheFirstDigit) {
  const Written written = Write("x 23");
  ASSERT_EQ(written.signs.size(), 5u);
  EXPECT_EQ(written.signs[2].begin, 2u);
  EXPECT_EQ(written.signs[2].end, 2u);
  EXPECT_TRUE(written.signs[2].keep_next);
  EXPECT_EQ(written.signs[3].begin, 2u);
  EXPECT_EQ(written.signs[3].end, 3u);
}

TEST(Hyphens, LetALineEndBehindThemWithinAWordOnly) {
  const auto breaks = [](std::string_view text) {
    std::string result;
    for (const Sign& sign : Write(text).signs) result += sign.break_after ? '1' : '0';
    return result;
  };
  EXPECT_EQ(breaks("a-b"), "010");
  EXPECT_EQ(breaks("-b"), "00");
  EXPECT_EQ(breaks("a--b"), "0010");
  EXPECT_EQ(breaks("a -b"), "0000");
}

TEST(Notes, TellWhatWasFoldedAndWhere) {
  const Written written = Write("x\ncaf\u00E9 \uFB01");
  ASSERT_EQ(written.notes.folded.size(), 2u);
  EXPECT_EQ(written.notes.folded[0].was, "\u00E9");
  EXPECT_EQ(written.notes.folded[0].became, "e");
  EXPECT_EQ(written.notes.folded[0].line, 2u);
  EXPECT_EQ(written.notes.folded[0].column, 4u);
  EXPECT_EQ(written.notes.folded[1].was, "\uFB01");
  EXPECT_EQ(written.notes.folded[1].became, "fi");
  EXPECT_EQ(written.notes.missing_count, 0u);
}

TEST(Notes, TellWhatWasFoldedInsideAContraction) {
  const Written written = Write("\u00E3nd");
  EXPECT_EQ(written.names, "and");
  ASSERT_EQ(written.notes.folded.size(), 1u);
  EXPECT_EQ(written.notes.folded[0].became, "a");
}

TEST(Notes, TellWhatIsMissingAndWhere) {
  const Written written = Write("ab\nc\u65E5");
  EXPECT_EQ(written.names, "a b c");
  ASSERT_EQ(written.notes.missing.size(), 1u);
  EXPECT_EQ(written.notes.missing[0].was, "\u65E5");
  EXPECT_EQ(written.notes.missing[0].became, "");
  EXPECT_EQ(written.notes.missing[0].line, 2u);
  EXPECT_EQ(written.notes.missing[0].column, 2u);
}

TEST(Notes, KeepTheFirstThousandAndCountAll) {
  std::string text;
  for (int i = 0; i < 1500; ++i) text += "\u00E9\u65E5";
  const Written written = Write(text);
  EXPECT_EQ(written.notes.folded.size(), 1000u);
  EXPECT_EQ(written.notes.folded_count, 1500u);
  EXPECT_EQ(written.notes.missing.size(), 1000u);
  EXPECT_EQ(written.notes.missing_count, 1500u);
}

TEST(SignWriter, DrawsTheChosenFormOfH) {
  const Script script = SmallScript();
  const std::string text = "h8";
  const SignWriter writer(script, 1, "arc");
  Folder folder(text, script);
  std::vector<FoldedChar> line;
  ASSERT_TRUE(folder.NextLine(line));
  std::vector<Sign> signs;
  Typeset notes;
  writer.Write(text, 1, line, signs, notes);
  ASSERT_EQ(signs.size(), 3u);
  EXPECT_EQ(script.glyphs[signs[0].glyph].name, "h.arc");
  EXPECT_EQ(script.glyphs[signs[2].glyph].name, "h.arc");  // the digit 8
}

std::string ErrorOf(const Script& script, double grade, const std::string& h_form) {
  try {
    SignWriter(script, grade, h_form);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(SignWriter, NamesTheGradesAndFormsThatItKnows) {
  const Script script = SmallScript();
  EXPECT_EQ(ErrorOf(script, 2, ""), "script small has no grade 2: choose from 0.5, 1");
  EXPECT_EQ(ErrorOf(script, 1, "pocket"), "script small has no h 'pocket': choose arc, plain");
}

TEST(SignWriter, RefusesARuleWithoutItsGlyph) {
  Script script = SmallScript();
  script.signs[U'!'] = "exclamation";
  EXPECT_NE(ErrorOf(script, 1, "").find("'exclamation'"), std::string::npos);
}

}  // namespace
}  // namespace moontrace
