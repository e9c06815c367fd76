#include "textures/fonts/fallback.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/textures/small_script.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

Typeset Set(std::string_view text, const Script& script) {
  return SetText(text, script, DefaultStyle(0.010, Relief::kEngraved, script), FindPage("a4"));
}

std::string Names(const Typeset& set, const Script& script) {
  std::string names;
  for (const TextPage& page : set.pages) {
    for (const PlacedGlyph& placed : page.glyphs) {
      names += (names.empty() ? "" : " ") + script.glyphs[placed.glyph].name;
    }
  }
  return names;
}

Script WithFallbacks(const char* toml) {
  Script script = SmallScript();
  ReadFallbacks(toml, "fallback.toml", script);
  return script;
}

TEST(Fallbacks, WriteOtherAlphabetsBySound) {
  const Script script = WithFallbacks(
      "[letters]\n'\u0436' = 'zh'\n'\u0438' = 'i'\n'\u0439' = 'y'\n"
      "'\u044C' = ''\n");
  const Typeset set = Set("\u0416\u0438\u0439\u044C", script);
  EXPECT_EQ(Names(set, script), "z h i y");
  ASSERT_EQ(set.folded_count, 4U);
  EXPECT_EQ(set.folded[0].how, Replaced::kTransliterated);
  EXPECT_EQ(set.folded[0].was, "\u0416");
  EXPECT_EQ(set.folded[0].became, "zh");
  EXPECT_EQ(set.missing_count, 0U);
}

TEST(Fallbacks, WriteDecomposedLettersBySound) {
  const Script script = WithFallbacks("[letters]\n'\u03B1' = 'a'\n");
  const Typeset set = Set("\u03AC", script);  // alpha with tonos
  EXPECT_EQ(Names(set, script), "a");
  EXPECT_EQ(set.folded[0].how, Replaced::kTransliterated);
}

TEST(Fallbacks, SpellTheNameInBrackets) {
  Script script = WithFallbacks("[names]\n'\u20AC' = 'euro sign'\n");
  EXPECT_EQ(Set("a\u20AC", script).missing_count, 1U);  // this script has no brackets
  script.folds[U'['] = "-";
  script.folds[U']'] = "-";
  const Typeset set = Set("a\u20AC", script);
  EXPECT_EQ(Names(set, script), "a hyphen e u r o s i g n hyphen");
  ASSERT_EQ(set.folded_count, 1U);
  EXPECT_EQ(set.folded[0].how, Replaced::kNamed);
  EXPECT_EQ(set.folded[0].became, "-euro sign-");
  EXPECT_EQ(set.missing_count, 0U);
}

TEST(Fallbacks, ComeAfterDecomposition) {
  const Script script = WithFallbacks("[letters]\n'\u00E9' = 'x'\n[names]\n'\u00E9' = 'n'\n");
  const Typeset set = Set("\u00E9", script);
  EXPECT_EQ(Names(set, script), "e");
  EXPECT_EQ(set.folded[0].how, Replaced::kFolded);
}

TEST(Fallbacks, LeaveTheRestOutAndTellIt) {
  const Typeset set = Set("a\u65E5", FindScript("moon"));
  EXPECT_EQ(set.missing_count, 1U);
  EXPECT_EQ(set.missing[0].was, "\u65E5");
}

TEST(Fallbacks, OfTheShippedFileWriteGreekCyrillicAndSigns) {
  const Script moon = FindScript("moon");
  EXPECT_EQ(Names(Set("\u039C\u03BF\u03C3\u03C7\u03B1", moon), moon), "m o s c h a");
  EXPECT_EQ(Names(Set("\u041C\u043E\u0441\u043A\u0432\u0430", moon), moon), "m o s k v a");
  EXPECT_EQ(Names(Set("\u20AC", moon), moon), "paren-open e u r o s i g n paren-close");
}

TEST(Fallbacks, NameWhatIsWrongInTheFile) {
  Script script = SmallScript();
  try {
    ReadFallbacks("[letters]\nab = 'c'\n", "fallback.toml", script);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "fallback.toml:2:6: ab: 'ab' is not one character; give one");
  }
}

class BorrowedScript : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("moontrace-borrow-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "greek.svg")
        << "<svg><defs><font horiz-adv-x='1000'><font-face units-per-em='1000' cap-height='1000'/>"
           "<glyph unicode='\u03B1' glyph-name='a' d='M0 0 L500 0'/>"
           "<glyph unicode='\u20AC' glyph-name='euro' d='M0 0 L500 500'/>"
           "<glyph unicode='B' glyph-name='B' d='M0 0 L500 700'/></font></defs></svg>";
    std::ofstream(folder_ / "greek.toml")
        << "title='Greek'\nauthor='x'\nlicence='CC0-1.0'\nstroke_width_em=0.1\n"
           "space_advance_em=1\ngrades=[1]\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(BorrowedScript, LendsOnlyWhatIsLacking) {
  Script script = SmallScript();
  const std::string path = (folder_ / "greek.svg").string();
  Borrow(script, FindScript(path), path);
  const Typeset set = Set("a\u03B1\u20ACB", script);
  EXPECT_EQ(Names(set, script), "a greek.a euro b");  // B is b here: the script has no case
  ASSERT_EQ(set.folded_count, 2U);
  EXPECT_EQ(set.folded[0].how, Replaced::kOtherScript);
  EXPECT_EQ(set.folded[0].was, "\u03B1");
  const Script greek = LoadScript(path);
  EXPECT_EQ(script.glyphs[script.Find("greek.a")].strokes[0].pieces,
            greek.glyphs[greek.Find("a")].strokes[0].pieces);
}

TEST_F(BorrowedScript, ThatLendsNothingIsRefused) {
  Script script = FindScript("moon");
  EXPECT_THROW(Borrow(script, FindScript("moon"), "moon"), InputError);
}

}  // namespace
}  // namespace moontrace
