#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "textures/script.h"

namespace moontrace {

/// What a script takes from its SVG 1.1 font.
struct SvgFont {
  std::vector<Glyph> glyphs;                   ///< in the file's order, lengths in em
  std::map<char32_t, std::string> characters;  ///< `unicode` attribute -> glyph name
};

/// Reads the first <font> of an SVG document. Of each <glyph> the `d` attribute and its children
/// <path d> and <circle cx cy r> are read, in this order; an open subpath is a stroke, a closed one
/// a filled area, a closed circle a dot. One em is the font-face's cap-height, else its
/// units-per-em. Curves become arcs within 0.001 em. A glyph without glyph-name goes by its
/// character; one for the space with nothing drawn is left out. External entities are not read.
/// Throws InputError (file:line:column, cause, cure): broken XML, no font, no glyphs, more than 8
/// MB, 10 000 glyphs or 100 000 path commands, a coordinate beyond 100 em, a broken path, a name
/// twice, a glyph with nothing drawn.
SvgFont ParseSvgFont(std::string_view svg, const std::string& file_name);

/// Greatest size of an SVG font file [bytes].
constexpr std::size_t kMaxSvgBytes = std::size_t{8} << 20U;

}  // namespace moontrace
