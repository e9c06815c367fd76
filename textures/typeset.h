#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "textures/script.h"
#include "textures/texture.h"

namespace moontrace {

/// How text becomes a page. Lengths in metres. `Defaults` fills what follows from the size.
struct TypeStyle {
  double size = 0.012;      ///< base line to top line on stroke centre lines [m]
  double width = 0;         ///< groove width w [m]
  double depth = 0;         ///< D [m]
  double rounding = 0;      ///< r [m]
  double blend_radius = 0;  ///< [m]
  Relief relief = Relief::kEngraved;
  double letter_gap = 0;  ///< added to every advance [m]
  double word_gap = 0;    ///< added to the space's advance [m]
  double line_pitch = 0;  ///< base line to base line [m]
  double grade = 1;       ///< 0.5, 1
  std::string h_form;     ///< "crescent", "arc", "pocket", "reverse-n"; empty = the script's own
};

/// The design's defaults for a size (section 3): w = 0.1165 em, D = w/2, r = 0.2 w; below 8 mm w
/// widens towards 0.2 em and D to w/3; embossed: D = w/4 and blended creases; line pitch 1.8 em.
TypeStyle DefaultStyle(double size, Relief relief, const Script& script);

/// A sheet. Frame P: origin at its lower left corner, x along the text, y up.
struct PageSpec {
  std::string name;       ///< "a4", "a5", "workspace", "custom"
  double width = 0.210;   ///< [m]
  double height = 0.297;  ///< [m]
  double margin = 0.015;  ///< on all sides [m]
};

/// A glyph on a page, and the bytes of the source text that it stands for.
struct PlacedGlyph {
  std::size_t glyph = 0;         ///< index into Script::glyphs
  glm::dvec2 origin_P{0, 0};     ///< of the glyph's em box: left edge on the base line [m]
  std::size_t source_begin = 0;  ///< byte offset in the UTF-8 text
  std::size_t source_end = 0;
  std::size_t line = 0;  ///< on the page, from 0 at the top
  std::size_t word = 0;  ///< running number in the text
};

struct TextPage {
  std::vector<PlacedGlyph> glyphs;
  std::size_t lines = 0;
};

/// Something the script has no sign for, or wrote otherwise.
struct Replacement {
  std::string was;         ///< the character(s) as in the text
  std::string became;      ///< empty: left out
  std::size_t line = 0;    ///< of the source text, from 1
  std::size_t column = 0;  ///< in characters, from 1
};

struct Typeset {
  TypeStyle style;
  PageSpec page;
  std::vector<TextPage> pages;
  std::vector<Replacement> folded;   ///< written by another sign of the same meaning (é -> e)
  std::vector<Replacement> missing;  ///< no form: reported, counted, left out
};

/// Sets UTF-8 text. Throws InputError: invalid UTF-8 (byte offset), empty text, text over 16 MB,
/// sizes that are not positive and finite, a groove wider than a letter, a line that holds no
/// letter, nothing left to set.
Typeset SetText(std::string_view text, const Script& script, const TypeStyle& style,
                const PageSpec& page);

/// The tree of one page: page > line > glyph, glyph groups shared through `cache` order; one layer.
Texture BuildTexture(const TextPage& page, const Script& script, const TypeStyle& style);

/// Elements of one glyph at a size, in the glyph's frame [m]: pieces, a dot at every end and joint,
/// fills.
Group BuildGlyph(const Glyph& glyph, const TypeStyle& style);

}  // namespace moontrace
