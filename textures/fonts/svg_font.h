#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// How far a glyph may reach [em].
constexpr double kMaxEms = 100;

/// Whose font it is. kOwn: one that has a TOML file beside it, written for Moontrace. kForeign: any
/// SVG 1.1 font.
enum class SvgFontKind { kOwn, kForeign };

/// What a script takes from its SVG 1.1 font.
struct SvgFont {
  std::string family;                          ///< of the font-face, else the font's id
  std::string metadata;                        ///< text of <metadata>: often author and licence
  double em = 0;                               ///< [units of the file] that glyphs were divided by
  std::string remark;                          ///< one sentence where the em was measured, or empty
  double space_advance = 0;                    ///< [em]; 0 = no glyph for the space
  std::vector<Glyph> glyphs;                   ///< in the file's order, lengths in em
  std::map<char32_t, std::string> characters;  ///< `unicode` attribute -> glyph name
  std::map<std::string, std::string> groups;   ///< the same of several characters ("ffi")
};

/// Reads the first <font> of an SVG document; each <glyph> by `SvgShapes`, the `d` attribute first,
/// filled areas last. Curves become arcs within 0.001 em. A glyph without glyph-name goes by its
/// character; so does one whose glyph-name only numbers it ("uni0022", see glyph_name.h), unless
/// another glyph has that name; one for the space with nothing drawn is left out; <missing-glyph>
/// is not read, since what a script has no sign for is reported and left out.
///
/// One em is the font-face's cap-height. Where that is absent or 0, kOwn takes units-per-em (which
/// our fonts set equal; fontforge drops the cap-height of a font without capitals), kForeign the
/// ascent, else units-per-em, else 1000 units (SVG 1.1, section 20.8.3).
///
/// kForeign looks whether the letters agree, since makers leave figures of other fonts there
/// (Inkscape's have cap-height 500 and capitals of 662). What counts is the top of what is drawn
/// over the base line, of the first glyph that is there: H, else another capital that is flat above
/// (E F I K L M N T U V W X Y Z in this order). Where it differs from the figure above by more than
/// 2 % (ours: 0.4 mm of 20 mm), it is the em, and `remark` says so; not where it lies outside a
/// tenth to three times the units-per-em, as symbols in a letter's place may. A font without these
/// capitals whose x is not as high as its x-height says, by the same measure, has its cap-height
/// scaled by the x.
///
/// Throws InputError (file:line:column, cause, cure): broken XML, not UTF-8, no font, no glyphs,
/// more than 64 MB or 20 000 glyphs, more path commands or pieces than 100 000 and 200 000 and than
/// a quarter of the file's bytes (paths alone hold no more commands, so <use> is bounded), a
/// coordinate beyond 100 em, a broken path, a cycle of <use>. kOwn also: a name or character twice,
/// a glyph without a name, with nothing drawn or for a group of characters. kForeign leaves glyphs
/// out that have no name or character, nothing drawn or no step to the next one (marks set over
/// letters); of two for one character the first counts, as SVG 1.1 (section 20.4) says; a second
/// name gets "#2" behind it.
SvgFont ParseSvgFont(std::string_view svg, const std::string& file_name,
                     SvgFontKind kind = SvgFontKind::kOwn);

}  // namespace moontrace
