#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// A script that can be found by name.
struct ScriptEntry {
  std::string name;  ///< for `--script`: "moon", "rowmans", "hershey:rowmans"
  std::string path;  ///< of its file or folder
};

/// What `--script NAME` finds, by name: shipped scripts; those of the user, in
/// $XDG_DATA_HOME/moontrace/scripts (~/.local/share without the variable), where an SVG font, a
/// .jhf, a .txt of medians or a folder goes by its name; Debian's Hershey fonts as "hershey:NAME".
/// Of two with one name the shipped one counts, so that a file cannot take Moon's place unseen.
std::vector<ScriptEntry> ListScripts();

/// Loads a script of any kind: an SVG font (with a TOML file of its name beside it, or without), a
/// Hershey .jhf, medians (.txt, .json, .jsonl), a folder of KanjiVG or of hanzi-writer-data.
/// `text`, if not empty, is what will be set: scripts of thousands of characters are read only as
/// far as it needs. Throws InputError (file, place, cause, cure).
Script LoadScriptFile(const std::string& path, std::string_view text);

/// Whether it is taken for a path, not for a name: it holds a '/' or ends like a file that can be
/// loaded and does not begin as the names of Hershey's fonts do.
bool IsScriptPath(const std::string& name_or_path);

/// By a name of ListScripts, or by path (IsScriptPath). Throws InputError, for an unknown name with
/// the nearest; LackError: Hershey's fonts are not installed.
Script LoadScriptNamed(const std::string& name_or_path, std::string_view text);

/// Loads `<stem>.svg` and, if it is there, `<stem>.toml`; or any other file or folder that
/// LoadScriptFile takes. Throws InputError (file:line:column, cause, cure).
Script LoadScript(const std::string& path);

/// Loads by name ("moon") from the installed or source `textures/scripts` folder, the user's own or
/// Debian's Hershey fonts, or by path. `text`, if not empty, is what will be
/// set: scripts of thousands of characters are read only as far as it needs. Unknown name:
/// InputError naming the known ones.
Script FindScript(const std::string& name_or_path, std::string_view text = {});

/// Reads from memory, for tests and fuzzing; `svg_name` and `toml_name` stand in messages.
Script ParseScript(std::string_view svg, const std::string& svg_name, std::string_view toml,
                   const std::string& toml_name);

}  // namespace moontrace
