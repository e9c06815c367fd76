#include "textures/fonts/script.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "tests/source_path.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFont =
    "<svg><font horiz-adv-x=\"900\"><font-face units-per-em=\"1000\"/>"
    "<glyph unicode=\"t\" d=\"M0 0L1 1\"/><glyph unicode=\"h\" d=\"M0 0L1 2\"/>"
    "<glyph glyph-name=\"th\" d=\"M0 0L1 3\"/><glyph glyph-name=\"h.arc\" d=\"M0 0L1 4\"/>"
    "<glyph glyph-name=\"comma\" d=\"M0 0L1 5\"/></font></svg>";

/// The least that a script's rules say, six lines.
constexpr const char* kRules =
    "title = 'T'\nauthor = 'A'\nlicence = 'L'\n"
    "stroke_width_em = 0.1\nspace_advance_em = 1.4\ngrades = [1]\n";

Script Parse(const std::string& more, const std::string& rules = kRules) {
  return ParseScript(kFont, "dir/small.svg", rules + more, "small.toml");
}

std::string ErrorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}
std::string RulesError(const std::string& more, const std::string& rules = kRules) {
  return ErrorOf([&] { Parse(more, rules); });
}

TEST(ParseScript, TakesItsOwnEmBeforeTheFontsCapHeight) {
  const Script as_font = Parse(""), own = Parse("em_units = 2000\n");  // the font has 1000
  ASSERT_EQ(own.glyphs.size(), as_font.glyphs.size());
  EXPECT_DOUBLE_EQ(own.glyphs[0].advance, as_font.glyphs[0].advance / 2);
  EXPECT_DOUBLE_EQ(Length(own.glyphs[0].strokes[0].pieces),
                   Length(as_font.glyphs[0].strokes[0].pieces) / 2);
  for (const char* wrong : {"0", "-1000", "99", "10001", "nan", "inf"}) {
    const std::string error = RulesError(std::string("em_units = ") + wrong + "\n");
    EXPECT_EQ(error.rfind("small.toml:7:", 0), 0U) << error;
  }
}

TEST(ParseScript, RefusesAnEmByWhichAGlyphIsTooLarge) {
  const std::string font =
      "<svg><font horiz-adv-x='900'><font-face units-per-em='1000'/>"
      "<glyph unicode='a' d='M0 0L50000 0'/></font></svg>";
  const std::string rules = kRules;
  EXPECT_EQ(ErrorOf([&] { ParseScript(font, "a.svg", rules + "em_units = 499\n", "a.toml"); }),
            "a.toml:7:12: em_units: by it a glyph reaches beyond 100 em; correct it");
  EXPECT_EQ(ErrorOf([&] { ParseScript(font, "a.svg", rules + "em_units = 501\n", "a.toml"); }),
            "no error");
}

TEST(ParseScript, KnowsGlyphsByNumberedNamesToo) {
  const Script script = Parse("[signs]\n'!' = 'uni0074'\n");  // U+0074 is t
  EXPECT_EQ(script.signs.at(U'!'), "t");
}

TEST(ParseScript, ReadsEveryRule) {
  const Script script = Parse(
      "protect_mark = '|'\n[signs]\n',' = 'comma'\n[folds]\n'æ' = 'ae'\n"
      "[[contractions]]\nprint = 'th'\nsigns = ['th']\ngrade = 1\n"
      "[[contractions]]\nprint = 'hth'\nsigns = ['h', 'th']\ngrade = 2\nwhere = 'word-end'\n"
      "[numerals]\nsign = 'comma'\n"
      "digits = {0='t',1='t',2='t',3='t',4='t',5='t',6='t',7='t',8='t',9='h'}\n"
      "[forms.h]\nplain = 'h'\narc = 'h.arc'\n");
  EXPECT_EQ(script.name, "small");
  EXPECT_EQ(script.title, "T");
  EXPECT_EQ(script.author, "A");
  EXPECT_EQ(script.licence, "L");
  EXPECT_EQ(script.stroke_width, 0.1);
  EXPECT_EQ(script.space_advance, 1.4);
  EXPECT_EQ(script.grades, (std::vector<double>{1}));
  EXPECT_EQ(script.protect_mark, U'|');
  EXPECT_EQ(script.signs,
            (std::map<char32_t, std::string>{{U't', "t"}, {U'h', "h"}, {U',', "comma"}}));
  EXPECT_EQ(script.folds, (std::map<char32_t, std::string>{{U'æ', "ae"}}));
  ASSERT_EQ(script.contractions.size(), 2U);
  EXPECT_EQ(script.contractions[0].where, Contraction::Where::kAnywhere);
  EXPECT_EQ(script.contractions[1].where, Contraction::Where::kWordEnd);
  EXPECT_EQ(script.contractions[1].signs, (std::vector<std::string>{"h", "th"}));
  EXPECT_EQ(script.contractions[1].grade, 2);
  EXPECT_EQ(script.numeral_sign, "comma");
  EXPECT_EQ(script.digits.at(U'9'), "h");
  EXPECT_EQ(script.forms.at("h").at("arc"), "h.arc");
  EXPECT_EQ(script.Find("h.arc"), 3U);
  EXPECT_EQ(script.Find("nothing"), Script::npos);
}

TEST(ParseScript, TakesAScriptWithoutOptionalRules) {
  const Script script = Parse("");
  EXPECT_EQ(script.protect_mark, 0U);
  EXPECT_TRUE(script.contractions.empty() && script.digits.empty() && script.forms.empty());
}

TEST(ParseScript, NamesPlaceCauseAndCureOfABrokenRule) {
  EXPECT_EQ(RulesError("[signs]\n',' = 'coma'\n"),
            "small.toml:8:7: ,: no glyph 'coma' in the font; did you mean 'comma'?");
  EXPECT_EQ(RulesError("[signs]\n',' = 'zebra'\n"),
            "small.toml:8:7: ,: no glyph 'zebra' in the font; draw it or correct the name");
  EXPECT_EQ(RulesError("[signs]\nab = 'comma'\n"),
            "small.toml:8:6: ab: 'ab' is not one character; give one");
  EXPECT_EQ(RulesError("[signs]\nt = 'comma'\n"),
            "small.toml:8:5: t: the font binds this character to 't'; keep one of the two");
  EXPECT_EQ(RulesError("[[contractions]]\nprint = 'th'\nsigns = ['thh']\ngrade = 1\n"),
            "small.toml:9:9: signs: no glyph 'thh' in the font; did you mean 'th'?");
  EXPECT_EQ(RulesError("[[contractions]]\nprint = 'th'\nsigns = ['th']\ngrade = 1\nwhere = 'x'\n"),
            "small.toml:11:9: where: 'x' is none of anywhere, whole-word, part-of-word, word-end");
  EXPECT_EQ(RulesError("[[contractions]]\nprint = ''\n"),
            "small.toml:8:9: print: empty; give the letters it stands for");
  EXPECT_EQ(RulesError("[[contractions]]\nprint = 'th'\nsigns = []\n"),
            "small.toml:9:9: signs: empty; name the glyphs that are written");
  EXPECT_EQ(RulesError("[numerals]\nsign = 'comma'\ndigits = {1='t'}\n"),
            "small.toml:9:10: no key '0'; add it (a string)");
  EXPECT_EQ(RulesError("[forms.h]\narc = 'h.arc'\n"),
            "small.toml:7:1: h: no form is the glyph 'h' itself; name one so");
  EXPECT_EQ(RulesError("protect_mark = '||'\n"),
            "small.toml:7:16: protect_mark: '||' is not one character; give one");
  EXPECT_EQ(RulesError("protectmark = '|'\n"),
            "small.toml:7:1: unknown key 'protectmark'; did you mean 'protect_mark'?");
  EXPECT_EQ(RulesError("x = = 1\n").rfind("small.toml:7:5: broken TOML: ", 0), 0U);
}

TEST(ParseScript, RefusesMeasuresAndGradesOutOfRange) {
  const std::string head = "title = 'T'\nauthor = 'A'\nlicence = 'L'\n";
  EXPECT_EQ(RulesError("stroke_width_em = 0\n", head),
            "small.toml:4:19: stroke_width_em: not above 0 and up to 1 em; correct it");
  EXPECT_EQ(RulesError("stroke_width_em = nan\n", head),
            "small.toml:4:19: stroke_width_em is not finite; give a finite number");
  EXPECT_EQ(RulesError("stroke_width_em = 0.1\nspace_advance_em = 101\n", head),
            "small.toml:5:20: space_advance_em: not above 0 and up to 100 em; correct it");
  const std::string measures = head + "stroke_width_em = 0.1\nspace_advance_em = 1\n";
  EXPECT_EQ(RulesError("grades = []\n", measures),
            "small.toml:6:10: grades: empty; name one grade at least");
  EXPECT_EQ(RulesError("grades = [1, 0.5]\n", measures),
            "small.toml:6:10: grades: not ascending from above 0; order them");
  EXPECT_EQ(RulesError("", "author = 'A'\n"), "small.toml:1:1: no key 'title'; add it (a string)");
}

TEST(FindScript, LoadsMoonByNameAndByPath) {
  const Script by_name = FindScript("moon");
  const Script by_path = FindScript(SourcePath("textures/scripts/moon.svg"));
  EXPECT_EQ(by_name.name, "moon");
  EXPECT_EQ(by_name.title, "Moon");
  EXPECT_EQ(by_path.glyphs.size(), by_name.glyphs.size());
}

TEST(FindScript, NamesTheKnownScriptsForAnUnknownName) {
  EXPECT_EQ(ErrorOf([] { FindScript("mon"); }), "unknown script 'mon'; did you mean 'moon'?");
  EXPECT_EQ(ErrorOf([] { FindScript("\n"); }),
            "unknown script '?': give a font's path, or see: moontrace script list");
}

class ScriptFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "moontrace-script-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  fs::path folder_;
};

TEST_F(ScriptFiles, ComeInPairsOrWithoutRules) {
  const std::string svg = Write("small.svg", kFont);
  EXPECT_EQ(FindScript(svg).author, "not said in the font");
  Write("small.toml", kRules);
  EXPECT_EQ(FindScript(svg).name, "small");
  EXPECT_EQ(FindScript(svg).author, "A");
}

TEST_F(ScriptFiles, NameAMissingFontAFolderAndAFileThatIsNoSvg) {
  const std::string missing = (folder_ / "none.svg").string();
  EXPECT_EQ(ErrorOf([&] { FindScript(missing); }),
            missing + ": cannot be opened (No such file or directory): check the path");
  EXPECT_EQ(
      ErrorOf([&] { FindScript(folder_.string()); }),
      folder_.string() + ": a folder without characters: give KanjiVG's or hanzi-writer-data's");
  const std::string text = Write("letter.txt", "Dear reader,\n");
  EXPECT_EQ(ErrorOf([&] { FindScript(text); }),
            text + ":1:1: broken JSON; get the file of medians again");
  const std::string svg = Write("letter.svg", "Dear reader,\n");
  EXPECT_EQ(ErrorOf([&] { FindScript(svg); }),
            svg + ":1:1: no XML in this file; give an SVG 1.1 font");
}

}  // namespace
}  // namespace moontrace
