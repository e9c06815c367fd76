#pragma once

#include <string>
#include <string_view>

namespace moontrace {

/// The name under which a font file holds a glyph, so that font editors keep it and XML that they
/// write stays sound (fontforge puts & < > " into attributes as they are): the name itself where it
/// is ASCII letters, digits, ".", "_" and "-" behind a letter, else its characters by number, as
/// the Adobe Glyph List Specification (section 6) has them: "uni0022", of several "uni00220023",
/// beyond U+FFFF "u1F600", joined by "_". `name` is UTF-8; what is not is left out.
std::string FontGlyphName(std::string_view name);

/// The characters (UTF-8) that such a name holds by number; empty for all other names, among them
/// those of surrogates, of characters that must not pass into a line for people (IsHidden), and of
/// alternates ("uni0022.alt").
std::string CharactersNamed(std::string_view glyph_name);

}  // namespace moontrace
