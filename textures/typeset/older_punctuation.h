#pragma once

#include <string_view>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/typeset/fold.h"

namespace moontrace {

/// Writes one folded line of a text by a script's older punctuation. The full stop of an
/// abbreviation and the marks that the short stop serves for become the short stop; a question mark
/// goes before the first word of its question, within the quotation mark or bracket that it stands
/// in, and the question ends in a short stop. Sentences go on over the lines of a paragraph. A
/// question mark without a word before it, or with a letter or a digit behind it, stays.
///
/// A full stop is of an abbreviation behind a word of the script's list, behind a single letter
/// other than i, and where a letter, a digit, a comma or (behind blanks) a small letter follows:
/// how to tell is ours. Nothing changes in a script without such rules. Linear in the text.
void UseOlderPunctuation(std::string_view text, const Script& script,
                         std::vector<FoldedChar>& line);

}  // namespace moontrace
