#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "textures/field/texture.h"
#include "textures/script/script.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/link_style.h"
#include "textures/typeset/reshape.h"
#include "textures/typeset/rules.h"
#include "textures/typeset/sheet_texture.h"
#include "textures/typeset/structure.h"

namespace moontrace {

/// How lines run.
enum class LineDirection {
  kLeftToRight,
  kRightToLeft,
  kAlternate,  ///< every second line of a page runs right to left, as in old Moon
  kVertical    ///< top to bottom, the next line to the left
};

/// "left-to-right", "right-to-left", "alternate", "vertical"; none for other words.
std::optional<LineDirection> LineDirectionOf(std::string_view name);
std::string NameOf(LineDirection lines);
inline constexpr const char* kLineDirections = "left-to-right, right-to-left, alternate, vertical";

/// How text becomes a page. Lengths in metres. `DefaultStyle` fills what follows from the size.
struct TypeStyle {
  double size = 0.012;      ///< base line to top line on stroke centre lines [m]
  double width = 0;         ///< groove width w [m]
  double depth = 0;         ///< D [m]
  double rounding = 0;      ///< r [m]
  double blend_radius = 0;  ///< [m]
  Relief relief = Relief::kEngraved;
  double letter_gap = 0;  ///< added to every glyph's advance, may be below zero [m]
  double word_gap = 0;    ///< added to the space's advance, may be below zero [m]
  double line_pitch = 0;  ///< base line to base line [m]
  double grade = 1;       ///< that the script knows
  std::string h_form;     ///< "crescent", "arc", "pocket", "reverse-n"; empty = the script's own
  std::string table;      ///< of liblouis, for Braille; empty = the script's own at the grade
  std::vector<std::string> only;  ///< names of the signs taught so far; empty = all
  LineDirection lines = LineDirection::kLeftToRight;
  /// In place of the empty line between paragraphs (blank lines of the text) [m]; in alternating
  /// lines, which run on, along the line. Default: an empty line; two word spaces.
  std::optional<double> paragraph_gap;
  RuleStyle rules;
  SheetTexture texture;
  LetterForm form;  ///< that the script was given by Reshaped
  StructureStyle structure;
  LinkStyle links;
};

/// The design's defaults for a size (section 3): w = 0.1165 em, D = w/2, r = 0.2 w; below 8 mm w
/// widens towards 0.2 em and D to w/3; embossed: D = w/4 and blended creases; line pitch 1.8 em. A
/// script may have its own stroke width, depth and line pitch.
TypeStyle DefaultStyle(double size, Relief relief, const Script& script);

/// Throws InputError when a length is not finite or not positive, the letters are below 1 mm, the
/// groove is wider than half a letter, r is not within 0 < r <= w/4, the flank is steeper than 5,
/// letters would run backwards or lines into each other. Grade and form of h are the script's
/// matter: SetText checks them.
void CheckStyle(const TypeStyle& style, const Script& script);

/// Size of a line's letters over that of the text.
inline double ScaleOf(LineKind kind, const TypeStyle& style) {
  return kind == LineKind::kHeading ? style.structure.heading_scale : 1;
}

/// The style of a line: headings have all lengths in proportion. A relief of their own takes the
/// usual depth of that relief, and ridges their blend, unless the script says how deep it is.
TypeStyle LineStyle(LineKind kind, const TypeStyle& style, const Script& script);

/// A sheet. Frame P: origin at its lower left corner, x along the text, y up.
struct PageSpec {
  std::string name;       ///< "a4", "a5", "workspace", "custom"
  double width = 0.210;   ///< [m]
  double height = 0.297;  ///< [m]
  double margin = 0.015;  ///< on all sides [m]
};

/// "a4", "a5" (margin 15 mm), "workspace" (160 x 120 mm, a desk-top device's reach, margin 10 mm),
/// or a custom page in mm as "120x90" (margin 10 mm). Throws InputError for other names and for
/// pages above 5 m. SetText refuses one that is not larger than its margins.
PageSpec FindPage(const std::string& name);

/// A glyph on a page, and the bytes of the source text that it stands for. The numeral sign stands
/// for none: its range is empty, at the first digit.
struct PlacedGlyph {
  std::size_t glyph = 0;         ///< index into Script::glyphs
  glm::dvec2 origin_P{0, 0};     ///< of the glyph's em box: left edge on the base line [m]
  std::size_t source_begin = 0;  ///< byte offset in the UTF-8 text
  std::size_t source_end = 0;
  std::size_t line = 0;              ///< on the page, from 0 at the top
  std::size_t word = 0;              ///< running number in the text
  LineKind kind = LineKind::kPlain;  ///< of its line: the size it has, see ScaleOf
  bool link = false;                 ///< of a link's words
};

struct TextPage {
  std::vector<PlacedGlyph> glyphs;
  std::size_t lines = 0;
  Box sheet_P;      ///< [m]
  Box text_area_P;  ///< between the margins [m]
};

/// Something the script has no sign for, wrote otherwise, or cannot tell from something else.
struct Replacement {
  std::string was;         ///< the character(s) as in the text; a control character as "U+001B"
  std::string became;      ///< empty: left out
  std::size_t line = 0;    ///< of the source text, from 1
  std::size_t column = 0;  ///< in characters (code points), from 1
  std::string name{};      ///< of `was` by CharacterName, where it has one
  Replaced how = Replaced::kFolded;  ///< of those that became something
};

struct Typeset {
  TypeStyle style;
  PageSpec page;
  std::vector<TextPage> pages;
  /// Written by another sign of the same meaning (é -> e), and those with no form: left out. The
  /// lists keep the first 1000, the counts are of all. Doubtful are letters that the script cannot
  /// tell from digits, as they follow a number directly ("3a" reads 31); became: the digit.
  /// Untaught have a sign that is not among TypeStyle::only: left out.
  std::vector<Replacement> folded, missing, doubtful, untaught;
  std::size_t folded_count = 0, missing_count = 0, doubtful_count = 0, untaught_count = 0;
  StructureCounts structure;
};

/// Sets UTF-8 text, by the rules of fold.h and signs.h, or of liblouis for Braille; the order of
/// lines is that of layout.h. The first base line is one em below the top margin. Lines break as in
/// the text, at spaces and behind hyphens; a word that no line holds is broken between letters. A
/// letter must fit with its strokes' centre lines, its gap may hang over; below the last base line
/// it may hang into the margin. One or several blank lines become one empty line, none at the top
/// of a page. Linear in the text.
/// Throws InputError: invalid UTF-8 (byte offset), empty text, text over 16 MB or more than 16
/// million signs, a style that fails CheckStyle, an unknown grade or form of h, a page that holds
/// no line or not a letter of the text, nothing left to set. LackError: Braille without liblouis.
Typeset SetText(std::string_view text, const Script& script, const TypeStyle& style,
                const PageSpec& page);

/// The tree of one page: page > line > glyph, in one layer, or two where headings have another
/// relief. A glyph's group is shared by all its places of one size; lines stand at the page's
/// origin.
Texture BuildTexture(const TextPage& page, const Script& script, const TypeStyle& style);

/// Elements of one glyph at a size, in the glyph's frame [m]: the pieces of strokes, then a dot at
/// each of their ends and joints (none for a full circle), then fills. A dot of the script becomes
/// a disc of at least the groove's width, so that it has the full depth.
Group BuildGlyph(const Glyph& glyph, const TypeStyle& style);

}  // namespace moontrace
