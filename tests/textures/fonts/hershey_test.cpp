#include "textures/fonts/hershey.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "tests/textures/stroke_distance.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

// Space, "!" and '"' in the format as published, drawn by hand: a bar with a dot, two bars.
const std::string kSmall =
    "    1  1JZ\n"
    "    2  5MWRFRT RR[\n"
    "    3  6JZNFNM RVFVM\n";

std::string ErrorOf(const std::string& jhf) {
  try {
    ParseHershey(jhf, "a", "a.jhf");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParseHershey, PutsTheBaseLineAtNineAndCapitalsAtOneEm) {
  const Script script = ParseHershey(kSmall, "a", "a.jhf");
  ASSERT_EQ(script.glyphs.size(), 2U);
  EXPECT_DOUBLE_EQ(script.space_advance, 16.0 / 21);  // from J to Z
  const Glyph& mark = script.glyphs[0];
  EXPECT_EQ(mark.name, "!");
  EXPECT_EQ(script.signs.at(U'!'), "!");
  EXPECT_DOUBLE_EQ(mark.advance, 10.0 / 21);
  ASSERT_EQ(mark.strokes.size(), 2U);
  const Line& bar = std::get<Line>(mark.strokes[0].pieces.at(0));
  EXPECT_LT(glm::length(bar.from - glm::dvec2(5.0 / 21, 1.0)), 1e-12);  // F is 12 above R
  EXPECT_LT(glm::length(bar.to - glm::dvec2(5.0 / 21, 7.0 / 21)), 1e-12);
  EXPECT_EQ(mark.strokes[1].kind, StrokeKind::kDot);  // a single point, on the base line
  EXPECT_LT(glm::length(std::get<Arc>(mark.strokes[1].pieces[0]).center - glm::dvec2(5.0 / 21, 0)),
            1e-12);
}

TEST(ParseHershey, ReadsRecordsThatAreBrokenIntoLines) {
  std::string wrapped = kSmall;
  wrapped.insert(wrapped.find("FRT"), "\r\n");
  EXPECT_EQ(ParseHershey(wrapped, "a", "a.jhf").glyphs[0].strokes[0].pieces,
            ParseHershey(kSmall, "a", "a.jhf").glyphs[0].strokes[0].pieces);
}

TEST(ParseHershey, StepsBehindTheDrawingWhereTheEdgesLeaveNoRoom) {
  const Script script = ParseHershey("    1  1JZ\n    2  3RRRFTT\n", "a", "a.jhf");
  EXPECT_DOUBLE_EQ(script.glyphs.at(0).advance, (2.0 + 5.0) / 21);
}

TEST(ParseHershey, NamesPlaceCauseAndCure) {
  EXPECT_EQ(ErrorOf("    1  1JZ\n    2  xMWRF"),
            "a.jhf:2:8: 'x' where a number must stand; give a Hershey .jhf file");
  EXPECT_EQ(ErrorOf("    1  9JZRF"),
            "a.jhf:1:13: the record ends in its middle; get the whole .jhf file");
  EXPECT_EQ(ErrorOf("    1  2JZ\xC3\xA9"),
            "a.jhf:1:11: a byte that is no printed ASCII; give a Hershey .jhf file");
  EXPECT_EQ(ErrorOf(""), "a.jhf: nothing is drawn in it; give a Hershey .jhf file");
  EXPECT_EQ(ErrorOf("<svg/>"),
            "a.jhf:1:1: '<' where a number must stand; give a Hershey .jhf file");
  EXPECT_EQ(ErrorOf(std::string((1U << 20U) + 1, ' ')),
            "a.jhf: holds more than 1 MB; give a Hershey .jhf file");
}

/// The polylines of record `index` [em], read the plain way: one record a line, as Debian has them.
std::vector<std::vector<glm::dvec2>> PolylinesOf(const std::string& line) {
  std::vector<std::vector<glm::dvec2>> polylines(1);
  for (std::size_t i = 10; i + 1 < line.size(); i += 2) {
    if (line.compare(i, 2, " R") == 0) {
      polylines.emplace_back();
    } else {
      polylines.back().emplace_back((line[i] - line[8]) / 21.0, ('[' - line[i + 1]) / 21.0);
    }
  }
  return polylines;
}

TEST(ParseHershey, KeepsEveryGlyphOfDebiansFontsWithinThePathInItsFile) {
  const std::string folder = "/usr/share/hershey-fonts";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "hershey-fonts-data is not installed";
  std::size_t fonts = 0, strokes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string jhf = ReadTextFile(entry.path().string(), kMaxHersheyBytes);
    const Script script = ParseHershey(jhf, "x", entry.path().string());
    ++fonts;
    std::size_t record = 0, begin = 0;
    for (std::size_t end = jhf.find('\n'); end != std::string::npos; end = jhf.find('\n', begin)) {
      const std::string line = jhf.substr(begin, end - begin);
      begin = end + 1;
      const std::string name =
          record < 95 ? std::string(1, static_cast<char>(32 + record)) : fmt::format("#{}", record);
      ++record;
      const std::size_t index = script.Find(name);
      if (index == Script::npos) {
        EXPECT_LE(line.size(), 10U) << entry.path() << " " << name;  // nothing is drawn
        continue;
      }
      std::size_t s = 0;
      for (const auto& polyline : PolylinesOf(line)) {
        if (polyline.empty()) continue;
        const Stroke& stroke = script.glyphs[index].strokes.at(s++);
        if (stroke.kind == StrokeKind::kDot) continue;
        EXPECT_LE(DistanceOf(stroke, polyline), kGlyphTolerance) << entry.path() << " " << name;
        ++strokes;
      }
      EXPECT_EQ(s, script.glyphs[index].strokes.size());
    }
  }
  EXPECT_EQ(fonts, 32U);
  EXPECT_GT(strokes, 10000U);
}

}  // namespace
}  // namespace moontrace
