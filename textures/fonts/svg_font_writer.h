#pragma once

#include <string>

#include "textures/fonts/script.h"

namespace moontrace {

/// The SVG 1.1 stroke font of a script as design section 4.7 fixes it: 1000 units an em, y up,
/// lines as L, arcs as A (split at a quarter of a turn, so that no reader can take the arc on the
/// other side), each relative to the place before, an open subpath a stroke, closed ones filled,
/// dots closed circles, rings behind the other strokes of their glyph (fontforge would close them
/// elsewhere). An arc of a radius that readers refuse becomes lines within 1e-4 em of it.
/// Coordinates have four decimals: 1e-7 em. Glyphs have names that font editors keep
/// (FontGlyphName). ParseScript reads the same script back from it and WriteRules; WriteScript
/// (script_writer.h) makes sure that it does.
std::string WriteSvgFont(const Script& script);

/// The TOML file beside it: title, author, licence, measures, rules.
std::string WriteRules(const Script& script);

/// Strokes that meet end to start, one following the other, become one; fills, dots and rings stay.
/// `tolerance` [em] is the greatest gap between them, which a line closes.
void JoinStrokes(Glyph& glyph, double tolerance);

}  // namespace moontrace
