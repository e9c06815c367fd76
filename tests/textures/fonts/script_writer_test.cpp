#include "textures/fonts/script_writer.h"

#include <gtest/gtest.h>

#include <numbers>

#include "textures/base/error.h"
#include "textures/fonts/character_script.h"
#include "textures/fonts/script_library.h"
#include "textures/fonts/svg_source.h"

namespace moontrace {
namespace {

Script Back(const WrittenScript& written) {
  return ParseScript(written.svg, "a.svg", written.toml, "a.toml");
}

std::string ErrorOf(const Script& script) {
  try {
    WriteScript(script, "a.svg");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A script of as many characters as are given, from U+4E00, each of three signs of `sample` side
/// by side, moved a little from one to the next: about the strokes of a usual character.
Script StandIn(const Script& sample, std::size_t count) {
  Script script = CharacterScript("stand-in");
  script.title = "Stand-in";
  script.author = "Moontrace";
  script.licence = "CC0-1.0";
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Stroke> strokes;
    for (std::size_t part = 0; part < 3; ++part) {
      const Glyph& from = sample.glyphs[(i + part) % sample.glyphs.size()];
      const glm::dvec2 moved(0.3 * static_cast<double>(part), 0.001 * static_cast<double>(i % 97));
      for (Stroke stroke : from.strokes) {
        for (Piece& piece : stroke.pieces) piece = Placed(piece, 0.4, moved);
        strokes.push_back(std::move(stroke));
      }
    }
    AddCharacter(U'\u4e00' + static_cast<char32_t>(i), std::move(strokes), script);
  }
  return script;
}

TEST(WriteScript, GivesTextsThatBringTheScriptBack) {
  for (const char* name : {"moon", "braille", "shapes", "sample-kanji"}) {
    const Script script = FindScript(name);
    EXPECT_EQ(Back(WriteScript(script, "a.svg")).signs, script.signs) << name;
  }
}

// 2000 characters broke the limit of path commands, 9500 that of the file's size.
TEST(WriteScript, HoldsThousandsOfCharacters) {
  const Script script = StandIn(FindScript("sample-hanzi"), 2000);
  EXPECT_EQ(Back(WriteScript(script, "a.svg")).signs.size(), 2000U);
}

TEST(SlowWriteScript, HoldsAsManyCharactersAsTheCollectionsHave) {
  for (const char* sample : {"sample-hanzi", "sample-kanji"}) {
    const Script script = StandIn(FindScript(sample), 11000);
    const WrittenScript written = WriteScript(script, "a.svg");
    EXPECT_LT(2 * written.svg.size(), kMaxSvgBytes) << sample;
    EXPECT_EQ(Back(written).signs.size(), 11000U) << sample;
  }
}

TEST(WriteScript, SaysWhatWouldNotComeBack) {
  Script script = FindScript("shapes");
  script.glyphs[0].name = std::string(1, '\a');
  script.signs.clear();
  EXPECT_EQ(ErrorOf(script), "a.svg: sign 'U+0007' would come back as 'uni0007'");
  script = FindScript("shapes");
  script.glyphs[0].strokes[0].pieces = {Line{{0, 0}, {101, 0}}};
  EXPECT_NE(ErrorOf(script).find("beyond 100 em"), std::string::npos) << ErrorOf(script);
  script = FindScript("shapes");
  script.glyphs[0].strokes.push_back({StrokeKind::kDot, {Line{{0, 0}, {1, 0}}}});
  EXPECT_EQ(ErrorOf(script),
            "a.svg: sign '" + script.glyphs[0].name + "' would come back with other strokes");
  script = FindScript("shapes");
  script.glyphs.resize(kMostCharacters + 1, script.glyphs[0]);
  for (std::size_t i = 0; i < script.glyphs.size(); ++i) {
    script.glyphs[i].name = "g" + std::to_string(i);
  }
  EXPECT_NE(ErrorOf(script).find("more than 20000 glyphs"), std::string::npos) << ErrorOf(script);
}

}  // namespace
}  // namespace moontrace
