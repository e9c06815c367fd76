#include "textures/fonts/script_library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/source_path.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

const std::string kScripts = SourcePath("textures/scripts");
const std::string kData = SourcePath("tests/data");

/// A user's folder of scripts, found by XDG_DATA_HOME.
class ScriptLibrary : public testing::Test {
 protected:
  ScriptLibrary() {
    // a folder of its own: tests run side by side
    std::string name = (fs::temp_directory_path() / "moontrace-library-XXXXXX").string();
    home_ = mkdtemp(name.data());
    fs::create_directories(Folder());
    setenv("XDG_DATA_HOME", home_.c_str(), 1);
  }
  ~ScriptLibrary() override {
    unsetenv("XDG_DATA_HOME");
    fs::remove_all(home_);
  }
  fs::path Folder() const { return home_ / "moontrace" / "scripts"; }
  void Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(Folder() / name, std::ios::binary) << bytes;
  }
  static bool Lists(const std::string& name) {
    const std::vector<ScriptEntry> all = ListScripts();
    return std::any_of(all.begin(), all.end(),
                       [&](const ScriptEntry& entry) { return entry.name == name; });
  }
  static std::string Error(const std::string& name) {
    try {
      LoadScriptNamed(name, "");
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  fs::path home_;
};

TEST_F(ScriptLibrary, FindsTheUsersOwnScriptsByName) {
  Write("own.jhf", "    1  1JZ\n    2  3MWRFRT\n");
  Write("strokes.svg",
        "<svg><font horiz-adv-x=\"9\"><font-face units-per-em=\"9\"/>"
        "<glyph unicode=\"a\" d=\"M0 0L1 1\"/></font></svg>");
  fs::copy(kScripts + "/sample-kanji", Folder() / "kanji");
  fs::copy(kData + "/hanzi/graphics.txt", Folder() / "hanzi.txt");
  for (const char* name : {"moon", "own", "strokes", "kanji", "hanzi"}) EXPECT_TRUE(Lists(name));
  EXPECT_EQ(LoadScriptNamed("own", "").glyphs.at(0).name, "!");
  EXPECT_EQ(LoadScriptNamed("strokes", "").signs.count(U'a'), 1U);
  EXPECT_EQ(LoadScriptNamed("kanji", "").glyphs.size(), 7U);
  EXPECT_EQ(LoadScriptNamed("kanji", "\u6728\u6728 \u65e5").glyphs.size(), 2U);
  EXPECT_EQ(LoadScriptNamed("hanzi", "\u4e00").glyphs.size(), 1U);
}

TEST_F(ScriptLibrary, KeepsMoonForItself) {
  Write("moon.svg", "<svg/>");
  EXPECT_EQ(LoadScriptNamed("moon", "").title, "Moon");
}

TEST_F(ScriptLibrary, LoadsByPathWhateverTheKind) {
  EXPECT_EQ(LoadScriptFile(kScripts + "/sample-kanji/", "").glyphs.size(), 7U);
  EXPECT_EQ(LoadScriptFile(kScripts + "/sample-kanji/", "").name, "sample-kanji");
  EXPECT_EQ(LoadScriptFile(kScripts + "/sample-hanzi", "").glyphs.size(), 2U);
  EXPECT_EQ(LoadScriptFile(kData + "/hanzi/graphics.txt", "\u5341").glyphs.size(), 1U);
}

TEST_F(ScriptLibrary, FindsDebiansHersheyFonts) {
  if (!fs::exists("/usr/share/hershey-fonts")) {
    // a lack of the machine, as the gallery takes it, not a fault of the name
    EXPECT_THROW(LoadScriptNamed("hershey:rowmans", ""), LackError);
    GTEST_SKIP() << "hershey-fonts-data is not installed";
  }
  EXPECT_TRUE(Lists("hershey:rowmans"));
  EXPECT_EQ(LoadScriptNamed("hershey:rowmans", "").glyphs.size(), 95U);
  EXPECT_NE(Error("rowmans").find("did you mean 'hershey:rowmans'?"), std::string::npos);
  EXPECT_NE(Error("hershey:rowman").find("did you mean 'hershey:rowman"), std::string::npos);
}

TEST_F(ScriptLibrary, NamesTheNearestOfAllSources) {
  Write("kanarese.jhf", "    1  1JZ\n    2  3MWRFRT\n");
  EXPECT_EQ(Error("kanares"), "unknown script 'kanares'; did you mean 'kanarese'?");
  EXPECT_EQ(Error("sampel-kanji"), "unknown script 'sampel-kanji'; did you mean 'sample-kanji'?");
  if (!fs::exists("/usr/share/hershey-fonts")) {
    GTEST_SKIP() << "hershey-fonts-data is not installed";
  }
  EXPECT_EQ(Error("hershey:gothgb"),
            "unknown script 'hershey:gothgb'; did you mean 'hershey:gothgbt'?");
  EXPECT_EQ(Error("hershy:scripts"),
            "unknown script 'hershy:scripts'; did you mean 'hershey:scripts'?");
  EXPECT_EQ(Error("hershey:rowmans.jhf"),
            "unknown script 'hershey:rowmans.jhf'; did you mean 'hershey:rowmans'?");
  EXPECT_EQ(Error("futura"), "unknown script 'futura'; did you mean 'hershey:futural'?");
  EXPECT_EQ(Error("gothgbd"), "unknown script 'gothgbd'; did you mean 'hershey:gothgbt'?");
}

TEST_F(ScriptLibrary, TellsHowToNameAFolderThatLiesHere) {
  const fs::path before = fs::current_path();
  fs::current_path(kScripts + "/..");
  EXPECT_EQ(Error("tiles"), "unknown script 'tiles'; for the file or folder here give './tiles'");
  fs::current_path(before);
}

// Whoever wants contracted Braille may take the grade for a script.
TEST_F(ScriptLibrary, TellsWhoNamesAGradeHowToAskForIt) {
  const auto line = [](const std::string& name, const std::string& meant) {
    return "unknown script '" + name + "', it names a grade; write " + meant;
  };
  for (const char* name : {"grade2", "Grade2", "grade-2", "grade 2", "g2"}) {
    EXPECT_EQ(Error(name), line(name, "--script braille --grade 2"));
  }
  EXPECT_EQ(Error("braille2"), line("braille2", "--script braille --grade 2"));
  EXPECT_EQ(Error("braille-grade1"), line("braille-grade1", "--script braille --grade 1"));
  EXPECT_EQ(Error("moon-g2"), line("moon-g2", "--script moon --grade 2"));
  for (const char* name : {"2", "grade", "gr8", "grade22", "moon2x"}) {
    EXPECT_EQ(Error(name).find("names a grade"), std::string::npos) << name;
  }
}

TEST_F(ScriptLibrary, SaysWhatIsKnownAndWhatIsNoScript) {
  EXPECT_EQ(Error("mon"), "unknown script 'mon'; did you mean 'moon'?");
  // half of its letters are those of 'hershey:greek'
  EXPECT_EQ(Error("grace2"),
            "unknown script 'grace2': give a font's path, or see: moontrace script list");
  EXPECT_EQ(Error(kData),
            kData + ": a folder without characters: give KanjiVG's or hanzi-writer-data's");
  EXPECT_NE(Error("./none.jhf").find("./none.jhf"), std::string::npos);
}

}  // namespace
}  // namespace moontrace
