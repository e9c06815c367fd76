#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// One sign to set, or a space.
struct Sign {
  std::uint32_t glyph = 0;  ///< index into Script::glyphs; unused for a space
  std::uint32_t begin = 0;  ///< bytes of the text that it stands for
  std::uint32_t end = 0;
  bool space = false;
  bool break_after = false;   ///< the line may end behind it: a hyphen within a word, a character
                              ///< of a script that parts no words
  bool keep_next = false;     ///< the next stays on its line: of a numeral sign the first digit, of
                              ///< a mark that opens the letter, of a letter the mark that closes;
                              ///< of a space, no line ends at it
  bool hyphen_after = false;  ///< the line may end behind it, with a hyphen
  bool link = false;          ///< of a link's words
  bool bound = false;         ///< the next stays on its line above all: of a group, the same mark
  bool mark = false;          ///< of punctuation: at a line's end no hyphen stands behind it
  bool in_number = false;     ///< a digit behind a digit: a new line repeats the numeral sign
  bool begins_row = false;    ///< only where signs are read from a page: the first of its row
};

/// Turns folded text into signs: by a script's own rules (signs.h) or by liblouis
/// (braille_writer.h).
class Writer {
 public:
  virtual ~Writer() = default;

  /// Whether the character has a form as it is.
  virtual bool Has(char32_t c) const = 0;

  /// Appends the signs of one line of the text. `typeset` takes note of what was folded, is missing
  /// or doubtful; `line_number` from 1.
  virtual void Write(std::string_view text, std::size_t line_number,
                     const std::vector<FoldedChar>& line, std::vector<Sign>& signs,
                     Typeset& typeset) const = 0;
};

/// Fails with InputError unless the script knows the grade.
void CheckGrade(const Script& script, double grade);

/// Notes what one character of the text became; keeps the first 1000 and counts all.
void Note(std::vector<Replacement>& list, std::size_t& count, std::string_view text,
          std::size_t line_number, const FoldedChar& c, std::string became);

/// What the character at `at` in the line was written as; empty for one without a mark.
std::string Became(const std::vector<FoldedChar>& line, std::size_t at);

}  // namespace moontrace
