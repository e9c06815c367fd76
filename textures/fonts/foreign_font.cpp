#include "textures/fonts/foreign_font.h"

#include <filesystem>
#include <sstream>

#include "textures/base/text_file.h"
#include "textures/fonts/svg_font.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostWords = 4000;  ///< of the metadata [bytes]: terms may be long

/// Runs of blanks and line breaks become one blank.
std::string Squeezed(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (blank && (result.empty() || result.back() == ' ')) continue;
    result += blank ? ' ' : c;
  }
  if (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

/// What stands behind "License:" in a line of the metadata, empty where no line has it.
std::string LicenceIn(const std::string& metadata) {
  std::istringstream lines(metadata);
  for (std::string line; std::getline(lines, line);) {
    const std::string words = Squeezed(line);
    const std::size_t colon = words.find(':');
    const std::string key = LowerCase(words.substr(0, colon));
    if (colon != std::string::npos && (key == "license" || key == "licence")) {
      return Squeezed(words.substr(colon + 1));
    }
  }
  return {};
}

}  // namespace

Script ParseForeignFont(std::string_view svg, const std::string& svg_name) {
  SvgFont font = ParseSvgFont(svg, svg_name, SvgFontKind::kForeign);
  Script script;
  script.name = std::filesystem::path(svg_name).stem().string();
  script.title = font.family.empty() ? script.name : OneLine(Squeezed(font.family));
  const std::string metadata = OneLine(Squeezed(font.metadata), kMostWords);
  script.author = metadata.empty() ? "not said in the font" : metadata;
  script.licence = OneLine(LicenceIn(font.metadata), kMostWords);
  if (script.licence.empty()) {
    script.licence = metadata.empty() ? "not said in the font" : "see the author's words";
  }
  script.stroke_width = 0.1;
  script.space_advance = font.space_advance > 0 ? font.space_advance : 0.5;
  script.grades = {1};
  script.glyphs = std::move(font.glyphs);
  script.signs = std::move(font.characters);
  if (!font.remark.empty())
    script.remarks.push_back(OneLine(script.title, 40) + ": " + font.remark);
  for (const auto& [print, glyph] : font.groups) {
    script.contractions.push_back({print, {glyph}, 1, Contraction::Where::kAnywhere});
  }
  return script;
}

}  // namespace moontrace
