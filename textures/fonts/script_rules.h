#pragma once

#include <string>
#include <string_view>

#include "textures/fonts/script.h"

namespace moontrace {

/// Fills the rules of `script` from its TOML file: title, author, licence, measures, grades, signs,
/// folds, numerals, contractions, forms. The glyphs and the characters of the font must be there
/// already: every rule is checked against them. Where `em_units` stands there, one em is so many
/// units of the font, and the glyphs, made with `font_em` units an em, are scaled: editors write a
/// cap-height of their own that follows the letters. They may differ tenfold at most. Throws
/// InputError (file:line:column, cause, cure).
void ReadRules(std::string_view toml, const std::string& file_name, double font_em, Script& script);

}  // namespace moontrace
