#include "textures/fonts/character_script.h"

#include <fmt/core.h>

#include <filesystem>
#include <system_error>

#include "textures/base/error.h"
#include "textures/base/toml_reader.h"
#include "textures/base/utf8.h"

namespace moontrace {

Script CharacterScript(const std::string& name) {
  Script script;
  script.name = name;
  // Of the 20-stroke characters few have strokes nearer than 0.07 em: a wall is left between them.
  script.stroke_width = 0.04;
  script.space_advance = 1;
  script.size = 0.020;       // smaller ones have gaps below a probe's width
  script.line_pitch = 1.25;  // the box has its own margins
  script.grades = {1};
  return script;
}

void AddCharacter(char32_t c, std::vector<Stroke> strokes, Script& script) {
  if (strokes.empty()) return;
  Glyph glyph;
  glyph.name = ToUtf8(c);
  glyph.advance = 1;
  glyph.strokes = std::move(strokes);
  script.signs[c] = glyph.name;
  script.glyphs.push_back(std::move(glyph));
}

void ReadCredits(const std::string& toml_path, Script& script) {
  std::error_code error;
  if (!std::filesystem::exists(toml_path, error)) return;
  const TomlTable table = TomlTable::Read(toml_path);
  script.title = table.String("title");
  script.author = table.String("author");
  script.licence = table.String("licence");
  script.stroke_width = table.Number("stroke_width_em", script.stroke_width);
  if (!(script.stroke_width > 0 && script.stroke_width <= 1)) {
    table.Fail("stroke_width_em", "not above 0 and up to 1 em; correct it");
  }
  table.FailUnknown();
}

void RequireCharacters(const Script& script, const std::set<char32_t>& needed,
                       const std::string& place) {
  if (!script.glyphs.empty()) return;
  if (needed.empty()) throw InputError(place + ": no character in it has a stroke; get it again");
  const std::string first = Shown(ToUtf8(*needed.begin()));
  const std::string what =
      needed.size() == 1
          ? fmt::format("has no sign for '{}'", first)
          : fmt::format("has a sign for none of the text's {} characters, not for '{}'",
                        needed.size(), first);
  throw InputError(place + ": " + what + "; use another text or script");
}

}  // namespace moontrace
