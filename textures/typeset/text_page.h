#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "textures/field/element.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/style.h"

namespace moontrace {

/// A sheet. Frame P: origin at its lower left corner, x along the text, y up.
struct PageSpec {
  std::string name;       ///< "a4", "a5", "workspace", "custom"
  double width = 0.210;   ///< [m]
  double height = 0.297;  ///< [m]
  double margin = 0.015;  ///< on all sides [m]
};

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
  bool bridge = false;  ///< leads to the next line and is not of the text: a hyphen, a guide line
};

struct GrooveLinks;

struct TextPage {
  std::vector<PlacedGlyph> glyphs;
  std::size_t lines = 0;
  Box sheet_P;      ///< [m]
  Box text_area_P;  ///< between the margins [m]
  /// Grooves between the letters, once they were looked for: see LinkPages of `textures/relief`.
  std::shared_ptr<const GrooveLinks> links;
};

/// Takes a page that is finished.
using TakePage = std::function<void(TextPage&&)>;

/// A character that the script has no sign for, writes by another sign, or cannot distinguish from
/// another.
struct Replacement {
  std::string was;         ///< the character(s) as in the text; a control character as "U+001B"
  std::string became;      ///< empty: left out
  std::size_t line = 0;    ///< of the source text, from 1; 0: of the running head
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

}  // namespace moontrace
