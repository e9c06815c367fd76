#pragma once

#include <string>
#include <string_view>

#include "textures/fonts/script.h"

namespace moontrace {

/// A script from an SVG 1.1 stroke font alone, without a TOML file: signs from the `unicode`
/// attributes, groups of characters as contractions of grade 1, the font's family as title, its
/// <metadata> (one line of at most 4000 bytes) as author, and as licence what stands there behind
/// "License:" at the beginning of a line. Strokes are 0.1 em wide; the
/// space is as wide as the font's own, else half an em. Where the font's figures contradict its
/// letters, a remark says what was taken. `svg_name` gives the name and stands in
/// messages. Throws like ParseSvgFont.
Script ParseForeignFont(std::string_view svg, const std::string& svg_name);

}  // namespace moontrace
