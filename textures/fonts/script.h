#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// What a subpath of a glyph is: an open stroke, a dot (small closed circle) or another filled
/// outline.
enum class StrokeKind { kStroke, kDot, kFill };

/// One subpath, in em (cap-height 1, base line 0, y up). A ring is an open stroke ending where it
/// starts.
struct Stroke {
  StrokeKind kind = StrokeKind::kStroke;
  std::vector<Piece> pieces;  ///< travelled in writing order; for kDot one whole circle
};

struct Glyph {
  std::string name;    ///< SVG glyph-name: "a", "h.arc", "numeral"
  double advance = 0;  ///< [em]
  std::vector<Stroke> strokes;
};

/// A group of letters written as one sign ("th" -> TH), from which grade on, and where.
struct Contraction {
  std::string print;               ///< folded lower-case text it stands for
  std::vector<std::string> signs;  ///< glyph names
  double grade = 1;                ///< used at this grade and above
  /// kPartOfWord: with a letter before or behind it, for a sign that alone means another word.
  enum class Where { kAnywhere, kWholeWord, kPartOfWord, kWordEnd } where = Where::kAnywhere;
};

/// Rules of punctuation that a script had before today's.
struct OlderPunctuation {
  char32_t short_stop = 0;              ///< 0: the script has no such rules
  std::set<char32_t> serves;            ///< marks that the short stop stands for as well
  std::set<std::string> abbreviations;  ///< words whose full stop is a short one, small letters
};

/// A tactile script: glyphs from an SVG 1.1 stroke font, rules from the TOML file of the same name.
struct Script {
  std::string name;  ///< "moon"
  std::string title, author, licence;
  double stroke_width = 0;     ///< [em]
  double space_advance = 0;    ///< [em]
  double size = 0.012;         ///< that letters usually have [m]
  double depth = 0;            ///< of dots and strokes [em]; 0 = follows from the width
  double line_pitch = 1.8;     ///< usual, base line to base line [em]
  std::vector<double> grades;  ///< that the rules know, ascending
  std::vector<Glyph> glyphs;
  std::map<char32_t, std::string> signs;   ///< folded character -> glyph name
  std::map<char32_t, std::string> digits;  ///< '0'..'9' -> glyph name after the numeral sign
  std::string numeral_sign;                ///< glyph name
  std::map<char32_t, std::string>
      folds;  ///< character -> replacement text, before Unicode's own folding
  std::vector<Contraction> contractions;
  std::map<std::string, std::map<std::string, std::string>>
      forms;  ///< "h" -> {"crescent": "h", "arc": "h.arc", ...}
  OlderPunctuation older_punctuation;
  char32_t protect_mark = 0;  ///< written before a group it forbids the contraction; 0 = none

  /// Of Braille: grade -> table of liblouis, which then writes the text in place of the rules
  /// above; the font's glyphs are bound to Unicode's Braille patterns. Empty for other scripts.
  std::map<double, std::string> braille_tables;

  /// For characters that the script has no form of, see fallback.h.
  std::map<char32_t, std::string> transliterations, names;
  std::set<char32_t> borrowed;  ///< characters whose glyph is another script's
  std::string borrowed_from;    ///< that script, name or path
  /// What users of the script should know of how its file was read, one sentence each.
  std::vector<std::string> remarks;

  /// Index of a glyph by name, or npos.
  std::size_t Find(std::string_view glyph_name) const noexcept;
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
};

}  // namespace moontrace
