#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"
#include "textures/typeset/writer.h"

namespace moontrace {

/// A word that reads otherwise.
struct DifferentWord {
  std::string first;   ///< as in the text
  std::string second;  ///< as read
  bool alike = false;  ///< both are written in the same signs: no reader can tell them apart
};

/// What signs say, and what was meant.
struct BackTranslation {
  std::string text;    ///< as read from the signs, UTF-8, line by line of the source
  std::string wanted;  ///< the source text, folded to what the script can write, alike
  std::vector<DifferentWord> differ;  ///< words of `wanted`: the first 1000
  std::size_t differ_count = 0;       ///< of all
  std::size_t alike_count = 0;        ///< of those, the ones that are written alike
  std::size_t words = 0;              ///< of `wanted`
  /// Characters of the source that no sign stands for, and those written otherwise (é as e).
  std::size_t left_out = 0, replaced = 0;
};

/// The signs of pages' rows, in the order in which they are read. Takes the pages as they are set.
class RowSigns {
 public:
  void Add(const TextPage& page);
  /// Those of the text before byte `end`, which no call has given yet.
  std::vector<Sign> Before(std::size_t end);

 private:
  std::vector<Sign> signs_;
  std::size_t word_ = 0, next_ = 0;
};

/// Writes a text in signs, reads the signs by the script's rules alone, and compares.
///
/// By a script's own rules: at each place the contraction of the grade with the most signs that may
/// stand there is read before letters, one for a whole word before one for a part of it; digits
/// follow the numeral sign until another sign. What Moon cannot distinguish is always read as one
/// of the two: a capital as a small letter, a letter a to j directly behind a number as a digit, at
/// grade 2 the word "l" as "like". Braille is read by braille_reader.h, capitals kept where its
/// table writes them.
///
/// `wanted` is what the Folder makes of the text: small letters where the script has no others,
/// without accents that it lacks, and without protect marks and characters that have no sign.
/// Letters that are not among TypeStyle::only are in it, so that they differ. Linear in the text.
///
/// With `rows` the signs are read from those of the text's pages: a hyphen at a row's end that is
/// not of the text is passed over, a number ends with its row, and no group of signs is read across
/// two rows. Braille is read as if no word were broken. Throws as SetText does, but for the page.
BackTranslation TranslateBack(std::string_view text, const Script& script, const TypeStyle& style,
                              RowSigns* rows = nullptr);

}  // namespace moontrace
