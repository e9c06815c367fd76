// Options about how text becomes signs, from the command line to the page.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class WritingOptions : public CliTest {};

nlohmann::json PageJson(const std::vector<std::string>& more, const std::string& text) {
  const Outcome outcome = RunLine(With({"page", text, "--json"}, more));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.Json();
}

std::string Names(const nlohmann::json& page) {
  std::string names;
  for (const auto& glyph : page["pages"][0]["glyphs"]) {
    if (!names.empty()) names += ' ';
    names += glyph["name"].get<std::string>();
  }
  return names;
}

bool HasBraille() { return RunLine({"page", "a", "--script", "braille", "--json"}).code != 4; }

// Unified English Braille: "the" is dots 2346 in grade 2, letter by letter in grade 1.
TEST_F(WritingOptions, BrailleIsWrittenByGradeOrByTable) {
  if (!HasBraille()) GTEST_SKIP() << "built without liblouis";
  EXPECT_EQ(Names(PageJson({"--script", "braille"}, "the")), "dots-2345 dots-125 dots-15");
  EXPECT_EQ(Names(PageJson({"--script", "braille", "--grade", "2"}, "the")), "dots-2346");
  EXPECT_EQ(Names(PageJson({"--script", "braille", "--table", "en-us-comp8-ext.utb"}, "A")),
            "dots-17");
  const nlohmann::json json = PageJson({"--script", "braille"}, "a");
  EXPECT_DOUBLE_EQ(json["size_mm"], 5);
  EXPECT_DOUBLE_EQ(json["width_mm"], 1.5);
  EXPECT_DOUBLE_EQ(json["depth_mm"], 0.5);
  const Outcome missing = RunLine({"page", "a", "--script", "braille", "--table", "en-ueb-g3.ctb"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_NE(missing.err.find("did you mean en-ueb-g1.ctb?"), std::string::npos);
  EXPECT_EQ(RunLine({"page", "a", "--table", "en-ueb-g2.ctb"}).code, 3);  // Moon has no tables
}

TEST_F(WritingOptions, ReadBackSaysWhetherTheSignsAreTheText) {
  const Outcome same = RunLine({"page", "The band", "--read-back"});
  EXPECT_NE(same.out.find("Reads back as the text: 2 words."), std::string::npos) << same.out;
  // every sign reads as meant, and yet it is not the text that was given
  const Outcome less = RunLine({"page", "caf\u00e9 \u2603 b\u2603", "--read-back"});
  EXPECT_NE(less.out.find(
                "Reads back as written, not as given: 2 words, 2 characters left out, 1 replaced."),
            std::string::npos)
      << less.out;
  const nlohmann::json of_less =
      RunLine({"page", "caf\u00e9 \u2603 b\u2603", "--read-back", "--json"}).Json();
  EXPECT_EQ(of_less["read_back"]["left_out"], 2);
  EXPECT_EQ(of_less["read_back"]["replaced"], 1);
  EXPECT_NE(same.out.find("Reads: the band"), std::string::npos);
  const Outcome other = RunLine({"page", "room 3d", "--read-back"});
  EXPECT_NE(other.out.find("Reads back otherwise: 1 word of 2."), std::string::npos) << other.out;
  EXPECT_NE(other.out.find("Reads otherwise: \"3d\" as \"34\"."), std::string::npos);
  ExpectTextFace(other.out);
  const nlohmann::json json = PageJson({"--read-back"}, "room 3d");
  EXPECT_EQ(json["read_back"]["differ"][0]["became"], "34");
}

TEST_F(WritingOptions, OnlyKeepsToTheSignsTaught) {
  const Outcome outcome = RunLine({"page", "the hat sits", "--only", "thea"});
  EXPECT_NE(outcome.out.find("Line 1: t h e, h a t, t"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Not taught, left out: \"s\", 2 times, first in line 1, character 9."),
            std::string::npos);
  EXPECT_EQ(PageJson({"--only", "thea"}, "the hat sits")["counts"]["untaught"], 3);
  EXPECT_EQ(RunLine({"page", "a", "--only", "a+tk"}).code, 3);
}

TEST_F(WritingOptions, FallbacksAreToldByTheirKind) {
  const Outcome outcome = RunLine({"page", "\u0416 5 \u20AC"});
  EXPECT_NE(outcome.out.find("By sound: \"\u0416\" by \"zh\", line 1, character 1."),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("By name: \"\u20AC\" as \"(euro sign)\", line 1, character 5."),
            std::string::npos)
      << outcome.out;
  const nlohmann::json json = PageJson({}, "\u0416 5 \u20AC");
  EXPECT_EQ(json["folded"][0]["how"], "transliterated");
  EXPECT_EQ(json["folded"][1]["how"], "named");
  EXPECT_EQ(json["counts"]["folded"], 2);
}

// moon-script reference, section 6.
TEST_F(WritingOptions, PunctuationIsThatOfTodayOrTheOlder) {
  EXPECT_EQ(Names(PageJson({}, "Is it?")), "i s i t question");
  EXPECT_EQ(Names(PageJson({"--punctuation", "today"}, "Is it?")), "i s i t question");
  const nlohmann::json older = PageJson({"--punctuation", "older"}, "Is it? Mr. A: b");
  EXPECT_EQ(Names(older), "question i s i t comma m r comma a comma b");
  EXPECT_EQ(older["punctuation"], "older");
  EXPECT_EQ(older["counts"]["folded"], 3);
  EXPECT_FALSE(PageJson({}, "a").contains("punctuation"));
  EXPECT_EQ(RunLine({"page", "a", "--punctuation", "new"}).code, 2);
  const Outcome shapes =
      RunLine({"page", "\u25CB", "--script", "shapes", "--punctuation", "older"});
  EXPECT_EQ(shapes.code, 3);
  EXPECT_NE(shapes.err.find("script shapes has no older punctuation"), std::string::npos)
      << shapes.err;
}

TEST_F(WritingOptions, ReadBackCountsWhatIsWrittenAlike) {
  const Outcome other = RunLine({"page", "room 3d", "--read-back"});
  EXPECT_NE(other.out.find("Written alike in both readings: 1 word of these."), std::string::npos)
      << other.out;
  const nlohmann::json json = PageJson({"--read-back"}, "room 3d");
  EXPECT_EQ(json["read_back"]["alike_count"], 1);
  EXPECT_TRUE(json["read_back"]["differ"][0]["alike"].get<bool>());
}

// The first pages are kept and said; the rest are set once more for JSON.
TEST_F(WritingOptions, BooksOfManyPagesAreWholeInJson) {
  std::string text;
  for (int i = 0; i < 150; ++i) text += "ab " + std::to_string(i) + '\n';
  const nlohmann::json book = PageJson({"--page", "180x40"}, text);
  ASSERT_EQ(book["pages"].size(), 150U);
  EXPECT_EQ(book["lines"], 150);
  const nlohmann::json& last = book["pages"][149]["glyphs"];
  ASSERT_EQ(last.size(), 6U);  // a, b, numeral, three digits
  EXPECT_EQ(last[5]["name"], "i");
  EXPECT_EQ(last[5]["source"][1], text.size() - 1);
  const Outcome said = RunLine({"page", text, "--page", "180x40"});
  EXPECT_NE(said.out.find("150 pages, 150 lines, "), std::string::npos);
  EXPECT_NE(said.out.find("Page 100, line 1: a b, numeral i i"), std::string::npos);
  EXPECT_NE(said.out.find("And 50 more lines; --json lists all."), std::string::npos);
}

TEST_F(WritingOptions, LinesRunInEachDirection) {
  const auto x = [](const nlohmann::json& page, std::size_t i) {
    return page["pages"][0]["glyphs"][i]["origin_mm"][0].get<double>();
  };
  const nlohmann::json back = PageJson({"--lines", "right-to-left"}, "AB");
  EXPECT_GT(x(back, 0), x(back, 1));
  const nlohmann::json old = PageJson({"--lines", "alternate", "--page", "100x100"}, "AAAAAAAA");
  EXPECT_NE(Names(old).find("a guide-right a"), std::string::npos);
  const nlohmann::json down = PageJson({"--lines", "vertical"}, "AA");
  EXPECT_DOUBLE_EQ(x(down, 0), x(down, 1));
  EXPECT_EQ(RunLine({"page", "A", "--lines", "up"}).code, 2);
}

TEST_F(WritingOptions, AreKeptByARecord) {
  const std::vector<std::vector<std::string>> all = {
      {"--lines", "alternate", "--page", "70x150", "--only", "ait"},
      {"--lines", "vertical", "--paragraph-gap-mm", "3"},
      {"--punctuation", "older"},
      {"--script", "braille", "--grade", "2"}};
  for (const std::vector<std::string>& more : all) {
    const Outcome trace =
        RunLine(With({"trace", "it?\n\nait", "--record", In("r"), "--quiet"}, more));
    if (trace.code == 4) continue;  // built without liblouis
    ASSERT_EQ(trace.code, 0) << trace.err;
    const Outcome replay = RunLine({"replay", In("r"), "--check"});
    EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
    std::filesystem::remove_all(In("r"));
  }
}

}  // namespace
}  // namespace moontrace
