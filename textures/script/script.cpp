#include "textures/script/script.h"

#include <filesystem>

#include "textures/script/fallback.h"
#include "textures/script/script_library.h"
#include "textures/script/script_rules.h"
#include "textures/script/svg_font.h"

namespace moontrace {

namespace fs = std::filesystem;

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

Script LoadScript(const std::string& path) { return LoadScriptFile(path, ""); }

Script FindScript(const std::string& name_or_path, std::string_view text) {
  Script script = LoadScriptNamed(name_or_path, text);
  ReadShippedFallbacks(script);
  return script;
}

}  // namespace moontrace
