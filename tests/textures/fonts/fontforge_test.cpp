// A font that people open, change and save in fontforge must come back as it was. The one setting
// that this takes is "Stroked Font" (Element, Font Info, Layers): without it fontforge closes every
// path of an SVG font.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/source_path.h"
#include "tests/textures/stroke_distance.h"
#include "textures/base/text_file.h"
#include "textures/fonts/script.h"
#include "textures/fonts/script_check.h"
#include "textures/fonts/script_library.h"
#include "textures/fonts/script_writer.h"
#include "textures/fonts/svg_font_writer.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

constexpr double kTolerance = 0.001;  // [em]

class Fontforge : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v fontforge >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "fontforge is not installed (Debian: fontforge-nox)";
    }
    folder_ = fs::path(testing::TempDir()) /
              (std::string("moontrace_fontforge_") +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  /// The script as the font was opened and saved, its rules beside it as before.
  Script Saved(const std::string& svg, const std::string& toml, bool stroked) const {
    const fs::path before = folder_ / "before.svg", after = folder_ / "after.svg";
    std::ofstream(before, std::ios::binary) << svg;
    const std::string program = std::string("import fontforge; f = fontforge.open('") +
                                before.string() +
                                "'); f.strokedfont = " + (stroked ? "True" : "False") +
                                "; f.generate('" + after.string() + "')";
    const std::string command = "fontforge -lang=py -c \"" + program + "\" >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return ParseScript(ReadTextFile(after.string(), 64U << 20U), "after.svg", toml, "after.toml");
  }

  fs::path folder_;
};

void ExpectSame(const Script& moon, const Script& again) {
  ASSERT_EQ(again.glyphs.size(), moon.glyphs.size());
  for (const auto& [character, name] : moon.signs) {  // fontforge binds U+02BC of its own accord
    ASSERT_EQ(again.signs.count(character), 1U) << name;
    EXPECT_EQ(again.signs.at(character), name);
  }
  for (const Glyph& glyph : moon.glyphs) {
    const std::size_t index = again.Find(glyph.name);
    ASSERT_NE(index, Script::npos) << glyph.name;
    const Glyph& other = again.glyphs[index];
    EXPECT_NEAR(other.advance, glyph.advance, kTolerance) << glyph.name;
    ASSERT_EQ(other.strokes.size(), glyph.strokes.size()) << glyph.name;
    for (std::size_t s = 0; s < glyph.strokes.size(); ++s) {
      EXPECT_EQ(other.strokes[s].kind, glyph.strokes[s].kind) << glyph.name;
      EXPECT_LE(DistanceOf(glyph.strokes[s], other.strokes[s]), kTolerance) << glyph.name;
      EXPECT_LE(DistanceOf(other.strokes[s], glyph.strokes[s]), kTolerance) << glyph.name;
    }
  }
}

/// Round trips of what the converter writes.
class SlowFontforge : public Fontforge {
 protected:
  void ExpectBack(const Script& script) const {
    SCOPED_TRACE(script.title);
    const WrittenScript written = WriteScript(script, "a.svg");
    ExpectSame(script, Saved(written.svg, written.toml, true));
  }
};

std::string Shipped(const char* file) {
  return ReadTextFile(SourcePath(std::string("textures/scripts/") + file), 64U << 20U);
}

TEST_F(Fontforge, BringsEveryGlyphOfMoonBack) {
  const Script moon = FindScript("moon");
  ExpectSame(moon, Saved(Shipped("moon.svg"), Shipped("moon.toml"), true));
}

TEST_F(Fontforge, BringsBackWhatTheConverterWrote) {
  const Script moon = FindScript("moon");
  ExpectSame(moon, Saved(WriteSvgFont(moon), WriteRules(moon), true));
}

TEST_F(SlowFontforge, BringsEveryShippedScriptBack) {
  for (const char* name : {"moon", "braille", "shapes", "sample-kanji", "sample-hanzi"}) {
    ExpectBack(FindScript(name));
  }
}

// Their glyphs go by their characters, & < > " among them, and by numbers as "#95"; where a symbol
// stands for H, fontforge writes its height as the cap-height.
TEST_F(SlowFontforge, BringsHersheyFontsBack) {
  if (!fs::exists("/usr/share/hershey-fonts")) {
    GTEST_SKIP() << "hershey-fonts-data is not installed";
  }
  for (const char* name : {"rowmans", "scripts", "gothgbt", "timesrb", "japanese", "symbolic"}) {
    ExpectBack(FindScript(std::string("hershey:") + name));
  }
}

TEST_F(Fontforge, ClosesEveryPathUnlessTheFontIsStrokedAndIsCaughtAtIt) {
  EXPECT_TRUE(IsOutlineFont(Saved(Shipped("moon.svg"), Shipped("moon.toml"), false)));
}

}  // namespace
}  // namespace moontrace
