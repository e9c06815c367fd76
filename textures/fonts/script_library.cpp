#include "textures/fonts/script_library.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>

#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"
#include "textures/fonts/fallback.h"
#include "textures/fonts/foreign_font.h"
#include "textures/fonts/hanzi.h"
#include "textures/fonts/hershey.h"
#include "textures/fonts/kanjivg.h"
#include "textures/fonts/needed_characters.h"
#include "textures/fonts/script_rules.h"
#include "textures/fonts/script_writer.h"
#include "textures/fonts/svg_font.h"
#include "textures/fonts/svg_source.h"

namespace moontrace {

namespace fs = std::filesystem;

namespace {

constexpr const char* kHersheyFolder = "/usr/share/hershey-fonts";
constexpr std::string_view kHershey = "hershey:";

bool IsMedians(const std::string& ending) {
  return ending == ".txt" || ending == ".json" || ending == ".jsonl";
}

bool IsFile(const std::string& ending) {
  return ending == ".svg" || ending == ".jhf" || IsMedians(ending);
}

std::string EndingOf(const std::string& path) {
  return LowerCase(fs::path(path).extension().string());
}

/// Where the user's own scripts lie; empty when there is no home.
std::string UserFolder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value != nullptr ? value : "");
  };
  if (const std::string data = variable("XDG_DATA_HOME"); !data.empty()) {
    return data + "/moontrace/scripts";
  }
  const std::string home = variable("HOME");
  return home.empty() ? home : home + "/.local/share/moontrace/scripts";
}

/// Appends what lies in a folder, by name; `is_ours` says by path whether it is a script.
template <typename Test>
void AppendFolder(const std::string& folder, const std::string& prefix, const Test& is_ours,
                  std::vector<ScriptEntry>& entries) {
  std::vector<ScriptEntry> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (is_ours(*it)) found.push_back({prefix + it->path().stem().string(), it->path().string()});
  }
  std::sort(found.begin(), found.end(),
            [](const ScriptEntry& a, const ScriptEntry& b) { return a.path < b.path; });
  for (ScriptEntry& entry : found) {
    const auto same = [&](const ScriptEntry& other) { return other.name == entry.name; };
    if (std::none_of(entries.begin(), entries.end(), same)) entries.push_back(std::move(entry));
  }
}

Script LoadSvg(const std::string& path) {
  const std::string toml_path = fs::path(path).replace_extension(".toml").string();
  std::error_code error;
  const std::string svg = ReadTextFile(path, kMaxSvgBytes);
  if (!fs::exists(toml_path, error)) return ParseForeignFont(svg, path);
  return ParseScript(svg, path, ReadTextFile(toml_path, kMaxRulesBytes), toml_path);
}

Script LoadFolder(const std::string& path, const std::set<char32_t>& needed) {
  if (IsKanjiVgFolder(path)) return LoadKanjiVg(path, needed);
  if (IsHanziFolder(path)) return LoadHanziFolder(path, needed);
  throw InputError(path + ": a folder without characters: give KanjiVG's or hanzi-writer-data's");
}

/// The name that was meant, or empty: a Hershey font may be named without its prefix.
std::string NearestScript(const std::string& name, const std::vector<ScriptEntry>& entries) {
  std::vector<std::string> names;
  names.reserve(2 * entries.size());
  const bool prefixed = name.rfind(kHershey, 0) == 0;
  for (const ScriptEntry& entry : entries) {
    const bool hershey = entry.name.rfind(kHershey, 0) == 0;
    if (hershey || !prefixed) names.push_back(entry.name);
  }
  for (const ScriptEntry& entry : entries) {
    const bool hershey = entry.name.rfind(kHershey, 0) == 0;
    if (hershey && !prefixed) names.push_back(entry.name.substr(kHershey.size()));
  }
  const std::string nearest = NearestWord(name, names);
  const std::string with_prefix = std::string(kHershey).append(nearest);
  const auto is = [](const std::string& wanted) {
    return [&wanted](const ScriptEntry& entry) { return entry.name == wanted; };
  };
  const bool known = nearest.empty() || std::any_of(entries.begin(), entries.end(), is(nearest));
  return known ? nearest : with_prefix;
}

/// How to ask for a script at the grade that a name holds, such as "braille-g2", "moon2" or, of
/// Braille, "grade2"; empty for other names.
std::string GradeMeant(const std::string& name, const std::vector<ScriptEntry>& entries) {
  const std::string lower = LowerCase(name);
  const auto begins = [&lower](const ScriptEntry& entry) {
    return lower.rfind(entry.name, 0) == 0;
  };
  const auto script = std::find_if(entries.begin(), entries.end(), begins);
  const bool named = script != entries.end();
  std::string rest = lower.substr(named ? script->name.size() : 0);
  std::erase_if(rest, [](char c) { return c == ' ' || c == '-' || c == '_'; });
  if (rest.empty() || rest.back() < '0' || rest.back() > '9') return {};
  const std::string grade(1, rest.back());
  rest.pop_back();
  if (rest != "grade" && rest != "g" && !(named && rest.empty())) return {};
  return fmt::format("--script {} --grade {}", named ? script->name : "braille", grade);
}

[[noreturn]] void FailUnknown(const std::string& name, const std::vector<ScriptEntry>& entries) {
  std::error_code error;
  if (name.rfind(kHershey, 0) == 0 && !fs::is_directory(kHersheyFolder, error)) {
    throw LackError("no Hershey fonts here: install hershey-fonts-data, or give a font's path");
  }
  if (const std::string meant = GradeMeant(name, entries); !meant.empty()) {
    throw InputError(fmt::format("unknown script '{}', it names a grade; write {}",
                                 OneLine(name, 25), OneLine(meant, 60)));
  }
  const std::string nearest = NearestScript(name, entries);
  if (nearest != std::string(kHershey).append(name) && fs::exists(name, error)) {
    throw InputError(fmt::format("unknown script '{0}'; for the file or folder here give './{0}'",
                                 OneLine(name, 25)));
  }
  if (nearest.empty()) {
    throw InputError(
        fmt::format("unknown script '{}': give a font's path, or see: moontrace script list",
                    OneLine(name, 30)));
  }
  throw InputError(fmt::format("unknown script '{}'; did you mean '{}'?", OneLine(name, 25),
                               OneLine(nearest, 25)));
}

}  // namespace

std::vector<ScriptEntry> ListScripts() {
  std::vector<ScriptEntry> entries;
  AppendFolder(
      ResourcePath("textures/scripts"), "",
      [](const fs::directory_entry& entry) {
        std::error_code error;
        return entry.is_directory(error) || EndingOf(entry.path().string()) == ".svg";
      },
      entries);
  AppendFolder(
      UserFolder(), "",
      [](const fs::directory_entry& entry) {
        std::error_code error;
        return entry.is_directory(error) || IsFile(EndingOf(entry.path().string()));
      },
      entries);
  AppendFolder(
      kHersheyFolder, std::string(kHershey),
      [](const fs::directory_entry& entry) { return EndingOf(entry.path().string()) == ".jhf"; },
      entries);
  return entries;
}

Script LoadScriptFile(const std::string& path, std::string_view text) {
  std::error_code error;
  const auto needed = [text] {
    return text.empty() ? std::set<char32_t>() : NeededCharacters(text);
  };
  const std::string ending = EndingOf(path);
  if (fs::is_directory(path, error))
    return LoadFolder(fs::path(path + "/").parent_path(), needed());
  if (ending == ".jhf") {
    return ParseHershey(ReadTextFile(path, kMaxHersheyBytes), fs::path(path).stem().string(), path);
  }
  if (IsMedians(ending)) return LoadHanziFile(path, needed());
  return LoadSvg(path);
}

bool IsScriptPath(const std::string& name_or_path) {
  const bool hershey = name_or_path.rfind(kHershey, 0) == 0;
  return name_or_path.find('/') != std::string::npos ||
         (!hershey && IsFile(EndingOf(name_or_path)));
}

Script LoadScriptNamed(const std::string& name_or_path, std::string_view text) {
  if (IsScriptPath(name_or_path)) return LoadScriptFile(name_or_path, text);
  const std::vector<ScriptEntry> entries = ListScripts();
  for (const ScriptEntry& entry : entries) {
    if (entry.name == name_or_path) return LoadScriptFile(entry.path, text);
  }
  FailUnknown(name_or_path, entries);
}

Script ParseScript(std::string_view svg, const std::string& svg_name, std::string_view toml,
                   const std::string& toml_name) {
  Script script;
  script.name = fs::path(svg_name).stem().string();
  SvgFont font = ParseSvgFont(svg, svg_name);
  script.glyphs = std::move(font.glyphs);
  script.signs = std::move(font.characters);
  ReadRules(toml, toml_name, font.em, script);
  return script;
}

Script LoadScript(const std::string& path) { return LoadScriptFile(path, ""); }

Script FindScript(const std::string& name_or_path, std::string_view text) {
  Script script = LoadScriptNamed(name_or_path, text);
  ReadShippedFallbacks(script);
  return script;
}

}  // namespace moontrace
