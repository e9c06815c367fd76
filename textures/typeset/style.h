#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "textures/field/paper.h"
#include "textures/field/texture.h"
#include "textures/fonts/script.h"
#include "textures/typeset/reshape.h"
#include "textures/typeset/structure.h"

namespace moontrace {

/// What groove links join: nothing, the letters of each word, also words across their spaces.
enum class LinkReach { kNone, kLetters, kWords };

/// "none", "letters", "words"; none for other words.
std::optional<LinkReach> LinkReachOf(std::string_view name);
std::string NameOf(LinkReach reach);
inline constexpr const char* kLinkReaches = "none, letters, words";

/// Shallow grooves between letters, so that a line can be traced like cursive (the paper, section
/// 6). Their width is the square root of that share of the letters',
/// so that their curvature is the same and their slope less.
struct LinkStyle {
  LinkReach reach = LinkReach::kNone;
  /// Share of the letters' depth, above 0, at most 1. At 0.4 the shipped hand leaves one in 25 of
  /// the links of 12 mm letters (SlowLinkedTracing), at 0.6 none.
  double depth = 0.6;
  std::optional<double> gap;  ///< kept to strokes, rim to rim [m]; default a quarter of the width
  bool operator==(const LinkStyle&) const = default;
};

/// Raised line rules and a raised margin (the paper, section 6: to deter wandering off text lines).
/// Lengths of zero are a tenth of the letters' size, heights a quarter of the width.
struct RuleStyle {
  bool lines = false;   ///< a ridge on either side of each line of text
  bool margin = false;  ///< a ridge round the text area
  /// The line pitch is not anybody's choice: it grows to what the rules of a text need.
  bool makes_room = false;
  double width = 0;          ///< of a rule, rim to rim [m]
  double height = 0;         ///< of a rule [m]
  double margin_width = 0;   ///< of the margin's ridge [m]
  double margin_height = 0;  ///< of the margin's ridge [m]
};

/// The rough texture of a whole sheet, if it has one.
struct SheetTexture {
  std::optional<PaperTexture> paper;
  std::string file;  ///< the PGM that its array is from; empty if it is none
};

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
  bool older_punctuation = false;  ///< see older_punctuation.h; only of scripts that have it
  std::vector<std::string> only;   ///< names of the signs taught so far; empty = all
  LineDirection lines = LineDirection::kLeftToRight;
  /// In place of the empty line between paragraphs (blank lines of the text) [m]; in alternating
  /// lines, which run on, along the line. Default: an empty line; two word spaces.
  std::optional<double> paragraph_gap;
  std::string hyphenation;    ///< language of patterns ("en_US"); empty: words are not broken
  std::string running_head;   ///< stands on the first line of each page; empty: none
  bool page_numbers = false;  ///< at the end of that line
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

}  // namespace moontrace
