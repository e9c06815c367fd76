#pragma once

#include <string>
#include <string_view>

#include "textures/fonts/script.h"

namespace moontrace {

/// Fills the rules of `script` from its TOML file: title, author, licence, measures, grades, signs,
/// folds, numerals, contractions, forms. The glyphs and the characters of the font must be there
/// already: every rule is checked against them. Throws InputError (file:line:column, cause, cure).
void ReadRules(std::string_view toml, const std::string& file_name, Script& script);

}  // namespace moontrace
