#include "textures/fonts/fallback.h"

#include <fmt/core.h>
#include <utf8proc.h>

#include <set>
#include <vector>

#include "textures/base/error.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"
#include "textures/base/utf8.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20U;
constexpr std::size_t kLongestName = 100;  // [bytes]; Unicode's longest has 88

std::map<char32_t, std::string> ReadTable(const TomlTable& table) {
  std::map<char32_t, std::string> entries;
  for (const std::string& key : table.Keys()) {
    const std::u32string codes = ToCodePoints(key);
    if (codes.size() != 1) {
      table.Fail(key, fmt::format("'{}' is not one character; give one", OneLine(key, 24)));
    }
    entries[codes[0]] = table.String(key);
    if (entries[codes[0]].size() > kLongestName) table.Fail(key, "too long; shorten it");
  }
  return entries;
}

bool Writes(const Script& script, char32_t c) {
  return script.signs.count(c) > 0 || script.digits.count(c) > 0 || script.folds.count(c) > 0;
}

}  // namespace

void ReadFallbacks(std::string_view toml, const std::string& file_name, Script& script) {
  const TomlTable table = TomlTable::Parse(toml, file_name);
  if (table.Has("letters")) script.transliterations = ReadTable(table.Table("letters"));
  if (table.Has("names")) script.names = ReadTable(table.Table("names"));
  table.FailUnknown();
}

void ReadShippedFallbacks(Script& script) {
  const std::string path = ResourcePath("textures/scripts/fallback.toml");
  ReadFallbacks(ReadTextFile(path, kMostBytes), path, script);
}

void Borrow(Script& script, const Script& other, const std::string& name_or_path) {
  std::set<std::string> names;
  for (const Glyph& glyph : script.glyphs) names.insert(glyph.name);
  std::map<std::string, std::string> taken;  // that script's glyph -> its name here
  for (const auto& [c, name] : other.signs) {
    const auto lower = static_cast<char32_t>(utf8proc_tolower(static_cast<utf8proc_int32_t>(c)));
    const std::size_t glyph = other.Find(name);
    if (Writes(script, c) || Writes(script, lower) || glyph == Script::npos) continue;
    const auto added = taken.emplace(name, name);
    if (added.second) {
      std::string& own = added.first->second;
      while (!names.insert(own).second) own = fmt::format("{}.{}", other.name, own);
      script.glyphs.push_back(other.glyphs[glyph]);
      script.glyphs.back().name = own;
    }
    script.signs[c] = added.first->second;
    script.borrowed.insert(c);
  }
  if (taken.empty()) {
    throw InputError(
        fmt::format("script {} has no sign that script {} lacks: choose another to fall back on",
                    OneLine(other.name, 40), OneLine(script.name, 40)));
  }
  script.borrowed_from = name_or_path;
  script.remarks.insert(script.remarks.end(), other.remarks.begin(), other.remarks.end());
}

}  // namespace moontrace
