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
};

/// By the marks' Unicode categories and their places: quotation marks open before a word and close
/// behind it, whatever their form, since languages use the same ones both ways („so“, »so«). Marks
/// of any kind before the first letter of a word stay with it. Linear in the line.
std::vector<LineEnd> LineEndsOf(const std::vector<FoldedChar>& line);

}  // namespace moontrace
