#include "textures/script.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "textures/error.h"
#include "textures/fallback.h"
#include "textures/nearest_word.h"
#include "textures/resources.h"
#include "textures/script_rules.h"
#include "textures/svg_font.h"
#include "textures/text_file.h"

namespace moontrace {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxTomlBytes = 1U << 20U;

std::vector<std::string> KnownScripts(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".svg") names.push_back(it->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::size_t Script::Find(std::string_view glyph_name) const noexcept {
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    if (glyphs[i].name == glyph_name) return i;
  }
  return npos;
}

Script ParseScript(std::string_view svg, const std::string& svg_name, std::string_view toml,
                   const std::string& toml_name) {
  Script script;
  script.name = fs::path(svg_name).stem().string();
  SvgFont font = ParseSvgFont(svg, svg_name);
  script.glyphs = std::move(font.glyphs);
  script.signs = std::move(font.characters);
  ReadRules(toml, toml_name, script);
  return script;
}

Script LoadScript(const std::string& svg_path) {
  const std::string svg = ReadTextFile(svg_path, kMaxSvgBytes);
  const std::string toml_path = fs::path(svg_path).replace_extension(".toml").string();
  std::error_code ignored;
  if (!fs::exists(toml_path, ignored)) {
    ParseSvgFont(svg, svg_path);  // a file that is no font is the first thing to mend
    throw InputError(toml_path + ": missing; a script keeps its rules in a TOML file of its name");
  }
  return ParseScript(svg, svg_path, ReadTextFile(toml_path, kMaxTomlBytes), toml_path);
}

namespace {

Script FindFiles(const std::string& name_or_path) {
  const bool is_path =
      name_or_path.find('/') != std::string::npos || fs::path(name_or_path).extension() == ".svg";
  if (is_path) return LoadScript(name_or_path);
  const std::string folder = ResourcePath("textures/scripts");
  const std::vector<std::string> known = KnownScripts(folder);
  if (std::find(known.begin(), known.end(), name_or_path) != known.end()) {
    return LoadScript((fs::path(folder) / (name_or_path + ".svg")).string());
  }
  const std::string nearest = NearestWord(name_or_path, known);
  std::string message = "unknown script '" + OneLine(name_or_path, 40) + "'; known:";
  for (const std::string& name : known) message += " " + name;
  message +=
      nearest.empty() ? "; or give the path of an SVG font" : "; did you mean '" + nearest + "'?";
  throw InputError(message);
}

}  // namespace

Script FindScript(const std::string& name_or_path) {
  Script script = FindFiles(name_or_path);
  ReadShippedFallbacks(script);
  return script;
}

}  // namespace moontrace
