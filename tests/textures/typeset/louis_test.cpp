#include "textures/typeset/louis.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/source_path.h"
#include "textures/base/error.h"
#include "textures/base/utf8.h"
#include "textures/typeset/fold.h"

namespace moontrace {
namespace {

bool BuiltWithLouis() {
  try {
    BrailleTable("en-ueb-g1.ctb");
    return true;
  } catch (const LackError&) {
    return false;
  }
}

class Louis : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!BuiltWithLouis()) GTEST_SKIP() << "built without liblouis";
    folder_ =
        std::filesystem::temp_directory_path() / ("moontrace-louis-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::filesystem::path folder_;
};

std::string Cells(const BrailleTable& table, std::u32string_view text) {
  std::string cells;
  for (const BrailleCell& cell : table.Translate(text)) cells += ToUtf8(0x2800U + cell.dots);
  return cells;
}

// Lines of prose, lists and tables that are at hand wherever the tests are built: the project's own
// pages.
std::vector<std::string> Corpus(const BrailleTable& table) {
  std::vector<std::string> lines;
  for (const char* page :
       {"README.md", "CONTRIBUTING.md", "CHANGELOG.md", "lessons/README.md", "sim/README.md"}) {
    std::ifstream in(SourcePath(page));
    for (std::string line; std::getline(in, line);) {
      bool has_all = line.find('\\') == std::string::npos;  // lou_translate reads those as its own
      // What a table lacks, lou_translate writes as an escape sequence.
      for (const char32_t c : ToCodePoints(line)) has_all = has_all && table.Has(c);
      if (has_all) lines.push_back(line);
    }
  }
  return lines;
}

std::string Output(const std::string& command) {
  std::string output;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  std::array<char, 4096> block{};
  for (std::size_t got = 0; (got = std::fread(block.data(), 1, block.size(), pipe)) > 0;) {
    output.append(block.data(), got);
  }
  ::pclose(pipe);
  return output;
}

bool HasLouTranslate() { return std::system("command -v lou_translate >/dev/null 2>&1") == 0; }

// The outside source: the program of liblouis itself, which reads the lines from `file`. Compared
// line by line, so that a failure shows one.
void ExpectAsLouTranslate(const std::string& name, const std::vector<std::string>& lines,
                          const std::string& file) {
  const BrailleTable table(name);
  const std::string output = Output("lou_translate unicode.dis," + name + " < '" + file + "'");
  std::string ours;
  for (const std::string& line : lines) ours += Cells(table, ToCodePoints(line)) + '\n';
  for (std::size_t at = 0, line = 0; at < ours.size(); ++line) {
    const std::size_t end = ours.find('\n', at);
    ASSERT_EQ(ours.substr(at, end - at), output.substr(at, end - at)) << lines[line];
    at = end + 1;
  }
  EXPECT_EQ(ours.size(), output.size());
}

class LouisTables : public Louis, public ::testing::WithParamInterface<const char*> {};

TEST_P(LouisTables, GiveTheCellsOfLouTranslate) {
  if (!HasLouTranslate()) GTEST_SKIP() << "lou_translate is missing: install liblouis-bin";
  const std::vector<std::string> lines = Corpus(BrailleTable(GetParam()));
  ASSERT_GT(lines.size(), 200U);
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  ExpectAsLouTranslate(GetParam(), lines, Write("corpus.txt", text));
}

INSTANTIATE_TEST_SUITE_P(Tables, LouisTables,
                         ::testing::Values("en-ueb-g1.ctb", "en-ueb-g2.ctb", "en-us-g2.ctb",
                                           "de-g0.utb", "de-g2.ctb", "fr-bfu-comp8.utb",
                                           "en-us-comp8-ext.utb"));

struct WordList {
  const char* table;
  const char* file;
  const char* package;
  std::size_t words;  // 16,000 of three languages in all
};

class SlowLouisWords : public Louis, public ::testing::WithParamInterface<WordList> {};

// Words all over a dictionary of Debian, each standing alone, where contractions depend on both
// ends.
TEST_P(SlowLouisWords, AreWrittenInTheCellsOfLouTranslate) {
  const WordList& list = GetParam();
  if (!HasLouTranslate()) GTEST_SKIP() << "lou_translate is missing: install liblouis-bin";
  const std::string path = std::string("/usr/share/dict/") + list.file;
  if (!std::ifstream(path)) GTEST_SKIP() << "no list of words: install " << list.package;
  std::vector<std::string> all, words;
  std::ifstream in(path);
  for (std::string word; std::getline(in, word);) all.push_back(word);
  ASSERT_GE(all.size(), list.words);
  std::string text;
  for (std::size_t i = 0; i < list.words; ++i) {
    words.push_back(all[i * all.size() / list.words]);
    text += words.back() + '\n';
  }
  ExpectAsLouTranslate(list.table, words, Write("words.txt", text));
}

INSTANTIATE_TEST_SUITE_P(
    Words, SlowLouisWords,
    ::testing::Values(WordList{"en-ueb-g1.ctb", "american-english", "wamerican", 4000},
                      WordList{"en-ueb-g2.ctb", "american-english", "wamerican", 4000},
                      WordList{"de-g1.ctb", "ngerman", "wngerman", 2000},
                      WordList{"de-g2.ctb", "ngerman", "wngerman", 2000},
                      WordList{"fr-bfu-comp6.utb", "french", "wfrench", 4000}),
    [](const auto& list) {
      std::string name = list.param.table;
      std::replace_if(
          name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
      return name;
    });

// Unified English Braille, Rules of Unified English Braille 2013: dot 6 is the capital indicator
// (section 8), the word "the" in grade 2 is dots 2346 (section 10.3), numbers begin with dots 3456
// (section 6).
TEST_F(Louis, WritesTheRulesOfUnifiedEnglishBraille) {
  const BrailleTable contracted("en-ueb-g2.ctb");
  EXPECT_EQ(Cells(contracted, U"the"), "\u282E");
  EXPECT_EQ(Cells(contracted, U"The"), "\u2820\u282E");
  EXPECT_EQ(Cells(contracted, U"12"), "\u283C\u2801\u2803");
  EXPECT_EQ(Cells(BrailleTable("en-ueb-g1.ctb"), U"the"), "\u281E\u2813\u2811");
}

TEST_F(Louis, TellsWhichCharactersACellStandsFor) {
  const std::vector<BrailleCell> cells = BrailleTable("en-ueb-g2.ctb").Translate(U"The 12");
  ASSERT_EQ(cells.size(), 6U);
  const std::vector<std::pair<unsigned, unsigned>> ranges{{0, 0}, {0, 3}, {3, 4},
                                                          {4, 4}, {4, 5}, {5, 6}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(cells[i].begin, ranges[i].first) << i;
    EXPECT_EQ(cells[i].end, ranges[i].second) << i;
  }
}

TEST_F(Louis, KnowsWhatATableLacks) {
  const BrailleTable table("en-ueb-g2.ctb");
  EXPECT_TRUE(table.Has(U'a'));
  EXPECT_TRUE(table.Has(U'\u20AC'));
  EXPECT_FALSE(table.Has(U'\u65E5'));
  EXPECT_FALSE(table.Has(U'\1'));
  EXPECT_EQ(Cells(table, U"\u65E5"), "");
}

// A line is translated whole, so cutting it where it is very long must not show: outside capitals'
// passages no rule of this table reaches over a space.
TEST_F(Louis, TakesLinesOfAnyLength) {
  std::u32string line;
  while (line.size() < 200000) line += U"the quick fox, ";
  const BrailleTable table("en-ueb-g1.ctb");
  const std::vector<BrailleCell> cells = table.Translate(line);
  EXPECT_EQ(cells.size(), line.size());
  EXPECT_EQ(cells.back().end, line.size());
}

std::string ErrorOf(const std::string& table) {
  try {
    BrailleTable{table};
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST_F(Louis, NamesATableThatIsMissingOrBrokenInOneLine) {
  EXPECT_EQ(ErrorOf("en-ueb-g3.ctb"),
            "no Braille table 'en-ueb-g3.ctb': did you mean en-ueb-g1.ctb?");
  EXPECT_EQ(ErrorOf("en-ueb-g2"), "no Braille table 'en-ueb-g2': did you mean en-ueb-g2.ctb?");
  // not "as.tbl", of another language, for the ending that they share
  EXPECT_EQ(ErrorOf("xx.ctb"),
            "no Braille table 'xx.ctb': give one of liblouis, like en-ueb-g2.ctb");
  EXPECT_NE(ErrorOf("").find("give a liblouis table"), std::string::npos);
  EXPECT_NE(ErrorOf("a\nb").find("Braille table 'a?b'"), std::string::npos);
  EXPECT_NE(ErrorOf(std::string(5000, 'a')).find("give a liblouis table"), std::string::npos);
  EXPECT_NE(ErrorOf(folder_.string()).find("no Braille table"), std::string::npos);
  const std::string broken = ErrorOf(Write("broken.ctb", "sign a 1\nfoo bar\n"));
  // one plain line of ours: where, what, how to mend it, and no word of liblouis
  EXPECT_NE(broken.find("broken.ctb:2: this Braille table is broken: mend it or use another"),
            std::string::npos)
      << broken;
  EXPECT_EQ(broken.find('\n'), std::string::npos);
}

// liblouis alone follows such a table until the stack ends.
TEST_F(Louis, RefusesATableThatIncludesItself) {
  const std::string error = ErrorOf(Write("round.ctb", "include round.ctb\n"));
  EXPECT_NE(error.find("includes itself, or more than 90 files"), std::string::npos) << error;
}

TEST_F(Louis, TakesATableByItsPath) {
  const BrailleTable table(Write("own.utb", "include en-chardefs.cti\nalways a 123456\n"));
  EXPECT_EQ(Cells(table, U"a"), "\u283F");
}

}  // namespace
}  // namespace moontrace
