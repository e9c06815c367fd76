#pragma once

#include <optional>
#include <string>

#include "sim/setup/options.h"

namespace moontrace {

/// `script list|info|check|convert|picture`: which scripts there are, what one holds, what is hard
/// to trace in it; a script in any format as our SVG font; a table of its signs.
struct ScriptOptions {
  OutputOptions output;
  std::string action, script;
  std::string only;            ///< these characters; empty = all
  std::optional<double> size;  ///< [m]
  std::string to;              ///< convert: the SVG font; the TOML file goes beside it
  bool join = false;           ///< convert: strokes that follow each other become one
  std::string picture;         ///< picture: .svg, .png, .pdf
};
void AddOptions(CLI::App& app, ScriptOptions& options);
int Run(const ScriptOptions& options, Console& console);

}  // namespace moontrace
