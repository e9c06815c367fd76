#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

const std::string kKanji = SourcePath("textures/scripts/sample-kanji");

/// No scripts of the user who runs the tests.
class ScriptCommand : public CliTest {
 protected:
  ScriptCommand() { setenv("XDG_DATA_HOME", folder_.c_str(), 1); }
  ~ScriptCommand() override { unsetenv("XDG_DATA_HOME"); }
};

std::string Font(const std::string& path) {
  return "<svg><font horiz-adv-x=\"1200\"><font-face font-family=\"F\" units-per-em=\"1000\"/>"
         "<glyph unicode=\"a\" d=\"" +
         path + "\"/></font></svg>";
}

TEST_F(ScriptCommand, ListsWithTitleAndLicence) {
  const Outcome outcome = RunLine({"script", "list"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("moon: Moon, "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("licence CC0-1.0."), std::string::npos);
  ExpectTextFace(outcome.out);
}

TEST_F(ScriptCommand, ListsAScriptThatCannotBeReadAndGoesOn) {
  std::filesystem::create_directories(In("moontrace/scripts"));
  WriteAll(In("moontrace/scripts/broken.jhf"), "x");
  const Outcome outcome = RunLine({"script", "list"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.out.find("broken: cannot be read; see: moontrace script info broken"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(RunLine({"script", "info", "broken"}).code, 3);
}

TEST_F(ScriptCommand, TellsAuthorLicenceAndWhatIsWritten) {
  const Outcome outcome = RunLine({"script", "info", kKanji});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = Lines(outcome.out);
  EXPECT_EQ(lines.at(0), "Sample kanji: 7 signs.");
  EXPECT_EQ(lines.at(1), "Author: Moontrace.");
  EXPECT_EQ(lines.at(2), "Licence: CC0-1.0.");
  EXPECT_NE(outcome.out.find("\u65e5"), std::string::npos);
  ExpectTextFace(outcome.out);
  EXPECT_EQ(RunLine({"script", "info", kKanji, "--json", "--only", "\u6728"}).Json()["characters"],
            "\u6728");
}

TEST_F(ScriptCommand, SaysWhereAFontIsSizedByItsLetters) {
  WriteAll(In("f.svg"),
           "<svg><font horiz-adv-x=\"1200\"><font-face font-family=\"F\" units-per-em=\"1000\" "
           "cap-height=\"500\"/><glyph unicode=\"H\" d=\"M0 0V662\"/></font></svg>");
  const std::string remark = "F: its cap-height is 500, but its H is 662 high; sized by H.";
  for (const std::vector<std::string>& args :
       {std::vector<std::string>{"script", "info", In("f.svg")},
        {"script", "check", In("f.svg")},
        {"script", "convert", In("f.svg"), "--to", In("k.svg")},
        {"page", "H", "--script", In("f.svg")},
        {"probe", "10", "10", "0", "H", "--script", In("f.svg")}}) {
    const Outcome outcome = RunLine(args);
    EXPECT_EQ(outcome.code, 0) << args[1];
    EXPECT_EQ(outcome.err, remark + "\n") << args[1];
  }
  EXPECT_EQ(RunLine({"script", "info", In("f.svg"), "--json"}).Json()["remarks"][0], remark);
  EXPECT_EQ(RunLine({"page", "H", "--json", "--script", In("f.svg")}).Json()["script_remarks"][0],
            remark);
  EXPECT_EQ(RunLine({"script", "info", In("k.svg")}).err, "");
}

TEST_F(ScriptCommand, PartsAllSignsAlike) {
  std::string out = RunLine({"script", "info", "moon"}).out;
  std::replace(out.begin(), out.end(), '\n', ' ');  // wrapped
  EXPECT_NE(out.find("a b c d e f g h i j k l m n o p q r s t u v w x y z 0 to 9"),
            std::string::npos)
      << out;
}

TEST_F(ScriptCommand, ChecksAndExitsWithOneWhereThereIsSomethingToMend) {
  WriteAll(In("good.svg"), Font("M0 0L1000 0"));
  EXPECT_EQ(RunLine({"script", "check", In("good.svg")}).code, 0);
  WriteAll(In("split.svg"), Font("M0 0L500 0M500 0L1000 0"));
  const Outcome outcome = RunLine({"script", "check", In("split.svg")});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(
      outcome.out.find("a: split stroke, strokes 1 and 2: the second goes on where the first"),
      std::string::npos)
      << outcome.out;
  ExpectTextFace(outcome.out);
  const nlohmann::json json = RunLine({"script", "check", In("split.svg"), "--json"}).Json();
  EXPECT_EQ(json["findings"][0]["kind"], "split");
  EXPECT_EQ(json["findings"][0]["strokes"], nlohmann::json({1, 2}));
}

// No single sign of an icon font is at fault, and yet it is not good.
TEST_F(ScriptCommand, TellsAFontForPrintBeforeItCountsFindings) {
  WriteAll(In("print.svg"), Font("M0 0H600V1000H0Z"));
  const Outcome outcome = RunLine({"script", "check", In("print.svg")});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out.rfind("For print, not of strokes: ", 0), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("\n0 findings in 1 sign, "), std::string::npos) << outcome.out;
  ExpectTextFace(outcome.out);
}

/// Twenty-one signs with a gap too narrow, A to U, and one cut stroke, V.
std::string FontOfManyFaults() {
  std::string svg = "<svg><font horiz-adv-x=\"1200\"><font-face units-per-em=\"1000\"/>";
  for (char c = 'A'; c <= 'U'; ++c) {
    svg += std::string("<glyph unicode=\"") + c + "\" d=\"M0 0V1000M100 0V1000\"/>";
  }
  return svg + "<glyph unicode=\"V\" d=\"M0 0V500M0 500V1000\"/></font></svg>";
}

TEST_F(ScriptCommand, SumsUpKindsOfMoreThanTwentyFindings) {
  WriteAll(In("f.svg"), FontOfManyFaults());
  const Outcome outcome = RunLine({"script", "check", In("f.svg")});
  EXPECT_EQ(outcome.code, 1);
  const std::vector<std::string> lines = Lines(outcome.out);
  EXPECT_EQ(lines.at(0).rfind("22 findings in 22 signs, letters of ", 0), 0U) << lines[0];
  const auto has = [&lines](const std::string& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
  };
  EXPECT_TRUE(has("gap too narrow: 21 in 21 signs, such as A, B, C.")) << outcome.out;
  EXPECT_TRUE(has("Kinds with more than 20 findings are summed up; --all lists each."));
  EXPECT_NE(outcome.out.find("V: split stroke, strokes 1 and 2: "), std::string::npos);
  EXPECT_EQ(outcome.out.find("U: gap too narrow"), std::string::npos);
  ExpectTextFace(outcome.out);
}

TEST_F(ScriptCommand, ListsEachFindingWhereAskedAndInJson) {
  WriteAll(In("f.svg"), FontOfManyFaults());
  const std::string all = RunLine({"script", "check", In("f.svg"), "--all"}).out;
  for (char c = 'A'; c <= 'U'; ++c) {
    EXPECT_NE(all.find(std::string("\n") + c + ": gap too narrow"), std::string::npos) << c;
  }
  EXPECT_EQ(all.find("summed up"), std::string::npos);
  const nlohmann::json json = RunLine({"script", "check", In("f.svg"), "--json"}).Json();
  EXPECT_EQ(json["findings"].size(), 22U);
  EXPECT_EQ(json["counts"], (nlohmann::json{{"narrow-gap", 21}, {"split", 1}}));
  EXPECT_EQ(json["left_out"], 0);
  // Twenty are few enough.
  const std::string few =
      RunLine({"script", "check", In("f.svg"), "--only", "ABCDEFGHIJKLMNOPQRST"}).out;
  EXPECT_NE(few.find("\nT: gap too narrow"), std::string::npos) << few;
}

TEST_F(ScriptCommand, NamesTheNearestAction) {
  EXPECT_EQ(
      RunLine({"script", "lst"}).err,
      "script: unknown action \"lst\": did you mean list? write list, info, check, convert or "
      "picture\n");
  EXPECT_EQ(RunLine({"script", "zzzzzz"}).err,
            "script: unknown action \"zzzzzz\": write list, info, check, convert or picture\n");
}

TEST_F(ScriptCommand, FindsMoreAtSmallerSizes) {
  WriteAll(In("pair.svg"), Font("M0 0L1000 0M0 300L1000 300"));
  EXPECT_EQ(RunLine({"script", "check", In("pair.svg"), "--size-mm", "20"}).code, 0);
  EXPECT_EQ(RunLine({"script", "check", In("pair.svg"), "--size-mm", "4"}).code, 1);
}

TEST_F(ScriptCommand, ConvertsAnyScriptToAFontThatSetsThePage) {
  const Outcome outcome = RunLine({"script", "convert", kKanji, "--to", In("k.svg")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(Lines(outcome.out).back(), In("k.toml"));
  const nlohmann::json page =
      RunLine({"page", "\u65e5\u6728", "--json", "--script", In("k.svg")}).Json();
  EXPECT_EQ(page["signs"], 2);
  EXPECT_EQ(page["pages"][0]["glyphs"][1]["name"], "\u6728");
  ExpectOnly({"k.svg", "k.toml"});
}

TEST_F(ScriptCommand, WritesNoFontThatItCouldNotReadAgain) {
  // XML has no such character.
  WriteAll(In("m.txt"), R"({"character":"\u0001","medians":[[[1,1],[500,500]]]})");
  const Outcome outcome = RunLine({"script", "convert", In("m.txt"), "--to", In("k.svg")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "script convert: not written, it could not be read back (" + In("k.svg") +
                             ": sign 'U+0001' would come back as 'uni0001'): take other or fewer "
                             "signs with --only\n");
  ExpectOnly({"m.txt"});
}

// Nobody named the rules' file: what lies there may be somebody's work.
TEST_F(ScriptCommand, WritesNoRulesOverAnotherFile) {
  const auto convert = [this] {
    return RunLine({"script", "convert", "shapes", "--to", In("z.svg")});
  };
  const auto refused = [&] {
    const Outcome outcome = convert();
    EXPECT_EQ(outcome.code, 4);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err,
              "nothing converted: another file, or one changed by hand, lies where the rules would "
              "go; give --to another name, or remove it: " +
                  In("z.toml") + "\n");
    EXPECT_FALSE(std::filesystem::exists(In("z.svg")));
  };
  WriteAll(In("z.toml"), "title = 'mine'\n");
  refused();
  EXPECT_EQ(ReadAll(In("z.toml")), "title = 'mine'\n");
  ExpectOnly({"z.toml"});
  std::filesystem::rename(In("z.toml"), In("other.toml"));
  std::filesystem::create_symlink(In("other.toml"), In("z.toml"));
  refused();
  EXPECT_EQ(ReadAll(In("other.toml")), "title = 'mine'\n");
  std::filesystem::remove(In("other.toml"));
  refused();  // nor is a file made at the other end of a link
  ExpectOnly({"z.toml"});
  std::filesystem::remove(In("z.toml"));
  ASSERT_EQ(convert().code, 0);
  // the same once more is no other file
  const std::string rules = ReadAll(In("z.toml"));
  EXPECT_EQ(convert().code, 0);
  EXPECT_EQ(ReadAll(In("z.toml")), rules);
  ExpectOnly({"z.svg", "z.toml"});
}

// A drawing of that name may be somebody's work, be it that they changed what was converted.
TEST_F(ScriptCommand, WritesNoFontOverAnotherFile) {
  const auto convert = [this](const std::string& script) {
    return RunLine({"script", "convert", script, "--to", In("note.svg")});
  };
  const auto refused = [&](const std::string& file) {
    const std::string before = ReadAll(In(file));
    const Outcome outcome = convert("shapes");
    EXPECT_EQ(outcome.code, 4);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find("lies where the " +
                               std::string(file == "note.svg" ? "font" : "rules") + " would go"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find(In(file)), std::string::npos);
    EXPECT_EQ(ReadAll(In(file)), before);
  };
  WriteAll(In("note.svg"),
           "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0L9 9\"/></svg>");
  refused("note.svg");
  ExpectOnly({"note.svg"});
  std::filesystem::remove(In("note.svg"));
  ASSERT_EQ(convert("shapes").code, 0);
  // what was converted before is replaced, whatever it was made of
  const std::string shapes = ReadAll(In("note.svg"));
  ASSERT_EQ(convert(kKanji).code, 0);
  EXPECT_NE(ReadAll(In("note.svg")), shapes);
  ASSERT_EQ(convert("shapes").code, 0);
  EXPECT_EQ(ReadAll(In("note.svg")), shapes);
  // but not once somebody worked on it
  for (const std::string file : {"note.svg", "note.toml"}) {
    const std::string written = ReadAll(In(file));
    std::string changed = written;
    changed[changed.find("hapes")] = 'H';
    WriteAll(In(file), changed);
    refused(file);
    WriteAll(In(file), written + "\n");
    refused(file);
    WriteAll(In(file), written);
  }
  EXPECT_EQ(convert("shapes").code, 0);
}

TEST_F(ScriptCommand, JoinsStrokesWhereAsked) {
  WriteAll(In("split.svg"), Font("M0 0L500 0M500 0L1000 0"));
  ASSERT_EQ(RunLine({"script", "convert", In("split.svg"), "--to", In("one.svg"), "--join"}).code,
            0);
  EXPECT_EQ(RunLine({"script", "check", In("one.svg")}).code, 0);
}

TEST_F(ScriptCommand, DrawsATableWithWordsBesideIt) {
  const Outcome outcome = RunLine({"script", "picture", kKanji, "--picture", In("t.svg")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(Lines(outcome.out).at(0), "7 signs drawn.");
  EXPECT_EQ(Lines(outcome.out).back(), In("t.svg"));
  const std::string svg = ReadAll(In("t.svg"));
  EXPECT_NE(svg.find("<title>The signs of Sample kanji</title>"), std::string::npos);
  EXPECT_NE(svg.find(">U+6728</text>"), std::string::npos);
}

TEST_F(ScriptCommand, PartsLongNamesInsteadOfCuttingThem) {
  ASSERT_EQ(RunLine({"script", "picture", "shapes", "--picture", In("t.svg")}).code, 0);
  const std::string svg = ReadAll(In("t.svg"));
  EXPECT_NE(svg.find(">corner-high-</text>"), std::string::npos);
  EXPECT_EQ(svg.find("..."), std::string::npos);
}

TEST_F(ScriptCommand, RefusesWhatItCannotUnderstand) {
  for (const std::vector<std::string>& args : {std::vector<std::string>{"script"},
                                               {"script", "lst"},
                                               {"script", "info"},
                                               {"script", "convert", "moon"},
                                               {"script", "convert", "moon", "--to", "x.txt"},
                                               {"script", "picture", "moon"},
                                               {"script", "info", "moon", "--join"},
                                               {"script", "info", "moon", "--all"},
                                               {"script", "list", "moon"}}) {
    const Outcome outcome = RunLine(args);
    EXPECT_EQ(outcome.code, 2) << outcome.out;
    EXPECT_EQ(Lines(outcome.err).size(), 1U);
  }
  EXPECT_EQ(RunLine({"script", "info", "mon"}).code, 3);
  EXPECT_EQ(RunLine({"script", "info", "moon", "--only", "\u65e5"}).code, 3);
  EXPECT_EQ(RunLine({"script", "convert", "moon", "--to", In("none/x.svg")}).code, 4);
}

}  // namespace
}  // namespace moontrace
