#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/console/line_wrap.h"
#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

class PageCommand : public CliTest {};

nlohmann::json PageJson(const std::vector<std::string>& more, const std::string& text = "HELLO") {
  const Outcome outcome = RunLine(With({"page", text, "--json"}, more));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.Json();
}

double X(const nlohmann::json& page, std::size_t glyph) {
  return page["pages"][0]["glyphs"][glyph]["origin_mm"][0];
}
double Y(const nlohmann::json& page, std::size_t glyph) {
  return page["pages"][0]["glyphs"][glyph]["origin_mm"][1];
}

TEST_F(PageCommand, SaysTheOutcomeFirstAndEachLineOfSigns) {
  const Outcome outcome = RunLine({"page", "HELLO MOON\nA CAT", "--size-mm", "8"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<std::string> lines = Lines(outcome.out);
  EXPECT_EQ(lines.front(), "1 page, 2 lines, 13 signs.");
  EXPECT_NE(std::find(lines.begin(), lines.end(), "Line 1: h e l l o, m o o n"), lines.end())
      << outcome.out;
  EXPECT_NE(std::find(lines.begin(), lines.end(), "Line 2: a, c a t"), lines.end());
  ExpectTextFace(outcome.out);
}

TEST_F(PageCommand, SaysWhatWasReplacedAndLeftOutWithItsPlace) {
  const Outcome outcome = RunLine({"page", "caf\xC3\xA9 \xE2\x98\x83"});
  EXPECT_NE(outcome.out.find("Replaced: \"\xC3\xA9\" by \"e\", line 1, character 4."),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("Left out: \"\xE2\x98\x83\", no sign for it, line 1, character 6."),
            std::string::npos)
      << outcome.out;
  const nlohmann::json json = PageJson({}, "caf\xC3\xA9 \xE2\x98\x83");
  EXPECT_EQ(json["folded"][0]["became"], "e");
  EXPECT_EQ(json["missing"][0]["column"], 6);
}

TEST_F(PageCommand, SaysWhatWasReplacedInTheRunningHeadAsInTheText) {
  const Outcome outcome = RunLine({"page", "moon\xc3\xa9", "--running-head", "caf\xc3\xa9"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("running head, character 4"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("line 1, character 5"), std::string::npos) << outcome.out;
  ExpectTextFace(outcome.out);
  const auto json = RunLine({"page", "moon", "--running-head", "caf\xc3\xa9", "--json"}).Json();
  ASSERT_EQ(json["folded"].size(), 1U);
  EXPECT_EQ(json["folded"][0]["line"], "running head");
  EXPECT_EQ(json["counts"]["folded"], 1);
}

TEST_F(PageCommand, SaysInWordsWhatCannotBeSeenOrHeard) {
  const Outcome outcome = RunLine({"page",
                                   "a \xE2\x80\x98"
                                   "b\xE2\x80\x8B"
                                   "c\x01"});
  for (const char* line :
       {"Replaced: left single quotation mark (U+2018) by apostrophe, line 1, character 3.",
        "Left out: zero width space (U+200B), line 1, character 5.",
        "Left out: U+0001, no sign for it, line 1, character 7."}) {
    EXPECT_NE(outcome.out.find(Wrapped(line)), std::string::npos) << outcome.out;
  }
}

TEST_F(PageCommand, SaysWhichLettersReadAsDigits) {
  const Outcome outcome = RunLine({"page", "3a"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(
      outcome.out.find("Doubtful: \"a\" directly after a number reads as 1, line 1, character 2."),
      std::string::npos)
      << outcome.out;
  EXPECT_EQ(PageJson({}, "3a")["doubtful"][0]["became"], "1");
  EXPECT_TRUE(PageJson({}, "3 a")["doubtful"].empty());
  EXPECT_NE(RunLine({"trace", "3a"}).err.find("Doubtful: \"a\""), std::string::npos);
}

TEST_F(PageCommand, TellsOfEachReplacedCharacterOnceHowOften) {
  const std::string out = RunLine({"page", "\xC3\xA9 \xC3\xBC b\xC3\xA9"}).out;
  EXPECT_NE(out.find("Replaced: \"\xC3\xA9\" by \"e\", 2 times, first in line 1, character 1.\n"
                     "Replaced: \"\xC3\xBC\" by \"u\", line 1, character 3.\n"),
            std::string::npos)
      << out;
}

TEST_F(PageCommand, CountsReplacementsBeyondTheThousandThatAreKept) {
  std::string text;
  for (int i = 0; i < 1500; ++i) text += "\xC3\xA9";
  const std::string out = RunLine({"page", text}).out;
  EXPECT_NE(out.find("1000 times, first in"), std::string::npos) << out;
  EXPECT_NE(out.find("And 500 more like these;"), std::string::npos) << out;
}

TEST_F(PageCommand, ListsTwentyReplacedCharactersAndCountsTheRest) {
  std::string text;  // from the dotted circle on the script has no sign for any of these shapes
  for (char last = '\x80'; last < '\xA0'; ++last) text += std::string("\xE2\x96") + last;
  const Outcome outcome = RunLine({"page", "a" + text});
  EXPECT_NE(outcome.out.find("And 12 more like these;"), std::string::npos) << outcome.out;
}

TEST_F(PageCommand, TakesPapersAndEndingsInCapitals) {
  EXPECT_EQ(PageJson({"--page", "A5"})["paper"], PageJson({"--page", "a5"})["paper"]);
  EXPECT_EQ(PageJson({"--page", "120X80"})["paper"], PageJson({"--page", "120x80"})["paper"]);
  ASSERT_EQ(RunLine({"page", "I", "--picture", In("P.SVG")}).code, 0);
  EXPECT_EQ(ReadAll(In("P.SVG")).rfind("<?xml", 0), 0U);
}

TEST_F(PageCommand, JsonGivesEachGlyphItsPlaceAndSource) {
  const nlohmann::json json = PageJson({});
  EXPECT_EQ(json["signs"], 5);
  EXPECT_EQ(json["lines"], 1);
  EXPECT_EQ(json["size_mm"], 12.0);
  const nlohmann::json& glyphs = json["pages"][0]["glyphs"];
  ASSERT_EQ(glyphs.size(), 5U);
  EXPECT_EQ(glyphs[1]["name"], "e");
  EXPECT_EQ(glyphs[1]["source"], nlohmann::json({1, 2}));
  EXPECT_DOUBLE_EQ(X(json, 0), 15.0);  // at the margin
  EXPECT_GT(X(json, 1), X(json, 0));
}

TEST_F(PageCommand, TextComesFromAFileOrStandardInput) {
  WriteAll(In("text"), "MOON");
  EXPECT_EQ(RunLine({"page", "--json", "--file", In("text")}).Json()["signs"], 4);
  EXPECT_EQ(RunLine({"page", "--json", "--file", "-"}, "MOONS").Json()["signs"], 5);
  EXPECT_EQ(RunLine({"page", "-", "--json"}, "MOO").Json()["signs"], 3);
}

TEST_F(PageCommand, LetterOptionsReachThePage) {
  const nlohmann::json size = PageJson({"--size-mm", "24"});
  EXPECT_NEAR(size["size_mm"], 24.0, 1e-9);
  EXPECT_NEAR(size["width_mm"], 0.1165 * 24, 1e-9);  // the design's default
  // A width given alone takes depth (w/2) and rounding (0.2 w) with it.
  const nlohmann::json width = PageJson({"--width-mm", "2"});
  EXPECT_NEAR(width["width_mm"], 2.0, 1e-12);
  EXPECT_NEAR(width["depth_mm"], 1.0, 1e-12);
  EXPECT_NEAR(width["rounding_mm"], 0.4, 1e-12);
  EXPECT_NEAR(PageJson({"--depth-mm", "0.5"})["depth_mm"], 0.5, 1e-12);
  EXPECT_NEAR(PageJson({"--rounding-mm", "0.2"})["rounding_mm"], 0.2, 1e-12);
  const nlohmann::json embossed = PageJson({"--embossed"});
  EXPECT_EQ(embossed["embossed"], true);
  EXPECT_NEAR(embossed["depth_mm"], 0.1165 * 12 / 4, 1e-9);
  EXPECT_EQ(PageJson({"--grade", "0.5"}, "THE")["signs"], 3);
  EXPECT_EQ(PageJson({"--h-form", "arc"})["pages"][0]["glyphs"][0]["name"], "h.arc");
  const std::string script = SourcePath("textures/scripts/moon.svg");
  EXPECT_EQ(PageJson({"--script", script}), PageJson({"--script", "moon"}));
}

TEST_F(PageCommand, LayoutOptionsReachThePage) {
  const std::string text = "I I\nI";
  const nlohmann::json plain = PageJson({}, text);
  EXPECT_NEAR(X(PageJson({"--margin-mm", "20"}, text), 0), 20.0, 1e-9);
  EXPECT_NEAR(X(PageJson({"--word-gap-mm", "3"}, text), 1), X(plain, 1) + 3, 1e-9);
  EXPECT_GT(X(PageJson({"--letter-gap-mm", "2"}, text), 1), X(plain, 1) + 1.9);
  const nlohmann::json pitch = PageJson({"--line-pitch-mm", "40"}, text);
  EXPECT_NEAR(Y(pitch, 0) - Y(pitch, 2), 40.0, 1e-9);
  EXPECT_EQ(PageJson({"--page", "a5"})["paper"]["width_mm"], 148.0);
  EXPECT_EQ(PageJson({"--page", "workspace"})["paper"]["height_mm"], 120.0);
  const nlohmann::json custom = PageJson({"--page", "120x80", "--margin-mm", "5"});
  EXPECT_NEAR(custom["paper"]["width_mm"], 120.0, 1e-9);
  EXPECT_NEAR(custom["paper"]["height_mm"], 80.0, 1e-9);
}

TEST_F(PageCommand, MeasuresAPageByTheMarginThatIsGiven) {
  const std::vector<std::string> small{"page", "a", "--page", "20x20", "--size-mm", "8"};
  EXPECT_EQ(RunLine(With(small, {"--margin-mm", "2"})).code, 0);
  const Outcome usual = RunLine(small);
  EXPECT_EQ(usual.code, 3);
  EXPECT_EQ(usual.err,
            "page 20 x 20 mm, margins 10 mm: give sides above twice that, or smaller margins\n");
  EXPECT_NE(RunLine({"page", "a", "--page", "3000x2000"}).err.find("from 1 to 1000"),
            std::string::npos);
}

TEST_F(PageCommand, NamesTheFileThatIsNotUtf8) {
  WriteAll(In("lat1.txt"), "caf\xE9\n");
  const Outcome outcome = RunLine({"page", "--file", In("lat1.txt")});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, In("lat1.txt") + ":1:4: this is not UTF-8; save it as UTF-8\n");
}

TEST_F(PageCommand, KeepsItsRefusalOnOneLineWhateverThePathHolds) {
  const Outcome outcome = RunLine({"page", "a", "--texture", "x\ny.pgm"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(Lines(outcome.err).size(), 1U);
  EXPECT_EQ(outcome.err.substr(0, 9), "x?y.pgm: ");
}

TEST_F(PageCommand, ATableWithoutBrailleIsToldTheScriptThatTakesIt) {
  const Outcome outcome = RunLine({"page", "moon", "--table", "en"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err,
            "script moon is not Braille: choose script braille, or leave out Braille's table "
            "'en'\n");
}

TEST_F(PageCommand, LeavesAPictureThatSaysInWordsWhatItShows) {
  const Outcome outcome = RunLine({"page", "MOON", "--picture", In("p.svg")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(Lines(outcome.out).back(), In("p.svg"));
  const std::string svg = ReadAll(In("p.svg"));
  EXPECT_NE(svg.find("<title>A page in "), std::string::npos);
  EXPECT_NE(svg.find("<desc>4 signs in 1 line,"), std::string::npos);
  EXPECT_NE(svg.find("width=\"210mm\" height=\"297mm\""), std::string::npos);
  EXPECT_EQ(svg.find("<text"), std::string::npos);
  ExpectOnly({"p.svg"});
}

TEST_F(PageCommand, PrintsLettersBelowTheSignsOnRequest) {
  ASSERT_EQ(RunLine({"page", "MOON", "--picture", In("p.svg"), "--letters"}).code, 0);
  const std::string svg = ReadAll(In("p.svg"));
  EXPECT_NE(svg.find(">M</text>"), std::string::npos);
  EXPECT_NE(svg.find(">N</text>"), std::string::npos);
  EXPECT_EQ(RunLine({"page", "MOON", "--letters"}).code, 2);
}

TEST_F(PageCommand, NumbersThePicturesOfSeveralPages) {
  const Outcome outcome = RunLine({"page", "ONE\nTWO\nTEN", "--json", "--page", "100x40",
                                   "--margin-mm", "5", "--picture", In("p.svg")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = outcome.Json();
  ASSERT_GT(json["pages"].size(), 1U);
  EXPECT_EQ(json["pictures"][1], In("p-2.svg"));
  EXPECT_EQ(json["pictures"].size(), json["pages"].size());
  EXPECT_TRUE(std::filesystem::exists(In("p-1.svg")));
  EXPECT_FALSE(std::filesystem::exists(In("p.svg")));
}

TEST_F(PageCommand, ListsAHundredLinesAndCountsTheRest) {
  std::string text;
  for (int i = 0; i < 130; ++i) text += "A\n";
  const Outcome outcome = RunLine({"page", text});
  const std::vector<std::string> lines = Lines(outcome.out);
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines[lines.size() - 2], "And 30 more lines; --json lists all.");
  EXPECT_EQ(lines.back(), "To see or print it, add --picture page.pdf.");
}

TEST_F(PageCommand, StopsWhenAskedTo) {
  const std::atomic<bool> stop{true};
  EXPECT_EQ(RunLine({"page", "-"}, "A", &stop).code, 130);
  EXPECT_EQ(RunLine({"page", "--file", In("none")}, "", &stop).code, 130);
  EXPECT_EQ(RunLine({"page", "A", "--json"}, "", &stop).code, 130);
  EXPECT_EQ(RunLine({"page", "A", "--picture", In("p.svg")}, "", &stop).code, 130);
  ExpectOnly({});
}

TEST_F(PageCommand, QuietLeavesTheResults) {
  EXPECT_EQ(RunLine({"page", "A", "--quiet"}).out, RunLine({"page", "A"}).out);
}

}  // namespace
}  // namespace moontrace
