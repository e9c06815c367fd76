#include "textures/fonts/hanzi.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/source_path.h"
#include "tests/textures/stroke_distance.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

const std::string kFile = SourcePath("tests/data/hanzi/graphics.txt");
const std::string kFolder = SourcePath("textures/scripts/sample-hanzi");

template <typename Load>
std::string ErrorOf(const Load& load) {
  try {
    load();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string MediansError(const std::string& json) {
  return ErrorOf([&] { ParseMedians(json, "a:1"); });
}

class HanziFile : public testing::Test {
 protected:
  HanziFile()
      : path_(testing::TempDir() + "moontrace_" +
              testing::UnitTest::GetInstance()->current_test_info()->name() + ".txt") {}
  ~HanziFile() override { fs::remove(path_); }

  void Write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
  std::string Error(const std::set<char32_t>& needed = {}) const {
    return ErrorOf([&] { LoadHanziFile(path_, needed); });
  }
  std::string path_;
};

TEST(ParseMedians, PutsTheBoxOf1024OnTheEm) {
  const std::vector<Stroke> strokes =
      ParseMedians("{\"medians\":[[[0,-124],[1024,900]]],\"strokes\":[\"M 0 0\"]}", "a");
  ASSERT_EQ(strokes.size(), 1U);
  const Line& line = std::get<Line>(strokes[0].pieces.at(0));
  EXPECT_LT(glm::length(line.from), 1e-12);
  EXPECT_LT(glm::length(line.to - glm::dvec2(1, 1)), 1e-12);
}

TEST(ParseMedians, NamesWhatIsWrong) {
  EXPECT_EQ(MediansError("{\"medians\":[[[0,1"),
            "a:1:18: broken JSON; get the file of medians again");
  EXPECT_EQ(MediansError("{\"medians\":[[[NaN,1]]]}"),
            "a:1:15: broken JSON; get the file of medians again");
  EXPECT_EQ(MediansError("{\"medians\":[[[1e999,1]]]}"),
            "a:1: JSON that cannot be read; get the file of medians again");
  EXPECT_EQ(MediansError("{\"medians\":[[[1e9,1]]]}"),
            "a:1: a median's point lies beyond ten boxes of 1024; mend it");
  EXPECT_EQ(MediansError("{\"medians\":[[[1]]]}"), "a:1: a median's point is not [x, y]; mend it");
  EXPECT_EQ(MediansError("{\"medians\":[7]}"),
            "a:1: a median is no list of at most 4096 points; mend it");
  EXPECT_EQ(MediansError("[]"), "a:1: no \"medians\"; give graphics.txt or hanzi-writer-data");
  EXPECT_EQ(MediansError("\"\xE9\""), "a:1:1:2: this is not UTF-8; save it as UTF-8");
}

TEST(ParseMedians, IsNotHarmedByDeepNesting) {
  EXPECT_NE(MediansError(std::string(500000, '[')).find("broken JSON"), std::string::npos);
}

TEST(LoadHanziFile, ReadsOnlyTheNeededLines) {
  EXPECT_EQ(LoadHanziFile(kFile, {}).glyphs.size(), 7U);
  const Script script = LoadHanziFile(kFile, {U'\u6728'});
  ASSERT_EQ(script.glyphs.size(), 1U);
  EXPECT_EQ(script.glyphs[0].name, "\u6728");
  EXPECT_EQ(script.glyphs[0].strokes.size(), 4U);
  EXPECT_EQ(script.licence, "CC0-1.0");
}

TEST(LoadHanziFile, KeepsEveryStrokeWithinTheMedianOfItsFile) {
  const Script script = LoadHanziFile(kFile, {});
  std::ifstream file(kFile);
  std::size_t glyph = 0;
  for (std::string line; std::getline(file, line); ++glyph) {
    const nlohmann::json medians = nlohmann::json::parse(line)["medians"];
    for (std::size_t s = 0; s < medians.size(); ++s) {
      std::vector<glm::dvec2> points;
      for (const auto& point : medians[s]) {
        points.emplace_back(point[0].get<double>() / 1024, (point[1].get<double>() + 124) / 1024);
      }
      EXPECT_LE(DistanceOf(script.glyphs.at(glyph).strokes.at(s), points), kGlyphTolerance);
    }
  }
  EXPECT_EQ(glyph, 7U);
}

TEST_F(HanziFile, DoesNotParseLinesThatAreNotNeeded) {
  Write(
      "{\"character\":\"\u4e00\",broken\n{\"character\":\"\u4e8c\",\"medians\":[[[0,0],[9,9]]]}\n");
  EXPECT_EQ(LoadHanziFile(path_, {U'\u4e8c'}).glyphs.size(), 1U);
  EXPECT_EQ(Error(), path_ + ":1:20: broken JSON; get the file of medians again");
}

TEST_F(HanziFile, NamesLineAndColumnOfWhatIsNotUtf8) {
  Write("{\"character\":\"\u4e00\",\"medians\":[[[0,0],[9,9]]]}\ncaf\xE9\n");
  EXPECT_EQ(Error(), path_ + ":2:4: this is not UTF-8; save it as UTF-8");
}

TEST_F(HanziFile, RefusesThirtyMegabytesInOneLine) {
  Write("{\"x\":\"" + std::string(std::size_t{30} << 20U, 'x') + "\"}");
  EXPECT_EQ(Error(), path_ + ":1: a line of more than 1 MB; give one character's JSON a line");
}

TEST_F(HanziFile, FindsACharacterAtTheEndOfThirtyMegabytes) {
  std::ofstream file(path_, std::ios::binary);
  const std::string filler(3000, ' ');
  for (int i = 0; i < 10000; ++i) {
    file << "{\"character\":\"\u4e00\"," << filler << "\"medians\":[[[0,0],[9,9]]]}\n";
  }
  file << "{\"character\":\"\u4e8c\",\"medians\":[[[0,0],[9,9]],[[0,9],[9,9]]]}\n";
  file.close();
  EXPECT_EQ(LoadHanziFile(path_, {U'\u4e8c'}).glyphs.at(0).strokes.size(), 2U);
}

TEST_F(HanziFile, SaysWhenNoneOfTheTextIsThere) {
  Write("{\"character\":\"\u4e00\",\"medians\":[[[0,0],[9,9]]]}\n");
  EXPECT_EQ(Error({U'\u9f8d'}), path_ + ": has no sign for '\u9f8d'; use another text or script");
  EXPECT_EQ(Error({U'\u9f8c', U'\u9f8d'}),
            path_ +
                ": has a sign for none of the text's 2 characters, not for '\u9f8c'; use "
                "another text or script");
  Write("");
  EXPECT_EQ(Error(), path_ + ": no character in it has a stroke; get it again");
}

TEST(LoadHanziFolder, ReadsAFileACharacter) {
  EXPECT_TRUE(IsHanziFolder(kFolder));
  EXPECT_FALSE(IsHanziFolder(SourcePath("textures/scripts/sample-kanji")));
  EXPECT_EQ(LoadHanziFolder(kFolder, {}).glyphs.size(), 2U);
  const Script one = LoadHanziFolder(kFolder, {U'\u6728'});
  const Script other = LoadHanziFile(kFile, {U'\u6728'});
  ASSERT_EQ(one.glyphs.size(), 1U);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(one.glyphs[0].strokes.at(s).pieces, other.glyphs.at(0).strokes.at(s).pieces);
  }
}

}  // namespace
}  // namespace moontrace
