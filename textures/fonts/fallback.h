#pragma once

#include <string>
#include <string_view>

#include "textures/fonts/script.h"

namespace moontrace {

/// What is written for characters that a script has no form of, before they are left out: another
/// script's glyph if one was named, Unicode's decomposition (fold.h), letters that sound alike, the
/// character's name. Each is reported and counted (Typeset::folded).

/// Reads transliterations and names of characters from a TOML file into the script. Throws
/// InputError (file:line:column, cause, cure).
void ReadFallbacks(std::string_view toml, const std::string& file_name, Script& script);

/// The file that comes with the program, textures/scripts/fallback.toml.
void ReadShippedFallbacks(Script& script);

/// Takes the glyphs of every character that `script` cannot write as it is, in either case, from
/// another script, which was found by `name_or_path`. A glyph's name that is taken already gets
/// that script's name in front. Throws InputError for a script that lends nothing.
void Borrow(Script& script, const Script& other, const std::string& name_or_path);

}  // namespace moontrace
