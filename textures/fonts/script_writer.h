#pragma once

#include <cstddef>
#include <string>

#include "textures/fonts/script.h"

namespace moontrace {

/// Greatest size of a script's TOML file [bytes].
constexpr std::size_t kMaxRulesBytes = std::size_t{4} << 20U;

/// A script as two files hold it, each with a comment as its last line by which IsAsWritten knows
/// it.
struct WrittenScript {
  std::string svg;   ///< by WriteSvgFont
  std::string toml;  ///< by WriteRules
};

/// Whether a file holds, to the last byte, what WriteScript once made of any script: nobody has
/// worked on it since. Not of one that is missing or cannot be read.
bool IsAsWritten(const std::string& path);

/// Writes a script and reads it back from the text, so that no file is left that cannot be read.
/// `svg_name`, the path of the font, stands in messages. Throws InputError (what comes back
/// otherwise, or the limit that is met) unless the same script comes back: glyphs in their order
/// with their names, strokes that run the same way within 0.001 em, advances within 0.001 em,
/// characters and rules; other measures within 1e-5 of themselves. Takes the memory of a second
/// script.
WrittenScript WriteScript(const Script& script, const std::string& svg_name);

}  // namespace moontrace
