#pragma once

#include <vector>

#include "textures/typeset/fold.h"

namespace moontrace {

/// Where a word may be broken when no line holds it: for each character of a line, what stands
/// behind it.
struct LineEnd {
  /// The next sign stays on its line: a mark that closes (.,!?) and quotation marks behind a word),
  /// or any sign behind a mark that opens; also what follows an apostrophe within a word.
  bool keep_next = false;
  /// The next sign is the same mark again, of an ellipsis say: kept even before `keep_next`.
  bool bound = false;
  /// No hyphen behind it shows that the word goes on: it is a mark.
  bool mark = false;
  /// A line may end behind it in every word: a character of a script that parts no words.
  bool may_end = false;
};

/// By the marks' Unicode categories and their places: quotation marks open before a word and close
/// behind it, whatever their form, since languages use the same ones both ways („so“, »so«); by
/// their form beside characters of East Asian width, before which no blank stands. Marks of any
/// kind before the first letter of a word stay with it.
///
/// No line ends at a no-break space, nor at any space behind a mark that opens or before one that
/// closes, where such marks stand alone: « so ! » (as UAX #14 has it, rules LB13 and LB14). A line
/// may end behind each character of East Asian width. Linear in the line.
std::vector<LineEnd> LineEndsOf(const std::vector<FoldedChar>& line);

}  // namespace moontrace
