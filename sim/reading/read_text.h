#pragma once

#include <string>
#include <vector>

#include "sim/reader/page_reader.h"
#include "textures/fonts/script.h"

namespace moontrace {

/// What was read as text, a line each: characters of the signs, digits behind the numeral sign up
/// to a space, the letters of a contraction, U+FFFD for what was felt and not known. A sign that
/// stands for no text is given by its name in angle brackets.
std::string TextRead(const std::vector<ReadToken>& tokens, const Script& script);

/// What one sign stands for, as above; `alone`: as a word of its own, where it may stand for more.
std::string TextOfSign(std::size_t glyph, const Script& script, bool alone = false);

}  // namespace moontrace
