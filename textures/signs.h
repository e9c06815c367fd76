#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "textures/fold.h"
#include "textures/script.h"
#include "textures/typeset.h"

namespace moontrace {

/// One sign to set, or a space.
struct Sign {
  std::uint32_t glyph = 0;  ///< index into Script::glyphs; unused for a space
  std::uint32_t begin = 0;  ///< bytes of the text that it stands for
  std::uint32_t end = 0;
  bool space = false;
  bool break_after = false;  ///< a hyphen within a word: the line may end behind it
  bool keep_next = false;    ///< a numeral sign: stays on the line of its first digit
};

/// Turns folded text into signs by a script's rules.
///
/// Numbers: the numeral sign stands once before each run of digits, and again after anything else,
/// so 3.14 has two. The reference is certain of runs only ("1989", "207"); a repeated sign can be
/// read in one way only. The script itself has no mark for the end of a number: letters a to j
/// that follow a digit directly ("3d") read as digits in Moon, here as on paper, and are noted as
/// doubtful.
///
/// Contractions: at each place the longest group of the grade that fits there. Word means letters,
/// and what has no mark in print (a soft hyphen) does not part them; a group at a word's end needs
/// a letter before it, a part of a word one that has a sign before or behind it. A group written as
/// several signs gives its range to the first, the others have an empty range at its end. The
/// script's protect mark before a group (of any grade) keeps it spelled out and is not shown;
/// anywhere else it is a character like others.
class SignWriter {
 public:
  /// Throws InputError: an unknown grade or form of h (naming the known ones), a rule that names a
  /// glyph which the script lacks.
  SignWriter(const Script& script, double grade, const std::string& h_form);

  /// Appends the signs of one line of the text. `typeset` takes note of what was folded, is missing
  /// or doubtful; `line_number` from 1.
  void Write(std::string_view text, std::size_t line_number, const std::vector<FoldedChar>& line,
             std::vector<Sign>& signs, Typeset& typeset) const;

 private:
  struct Group {
    std::u32string print;
    std::vector<std::uint32_t> glyphs;
    Contraction::Where where = Contraction::Where::kAnywhere;
    bool active = false;  // at the grade that is set
  };
  std::uint32_t Glyph(const std::string& name) const;
  const Group* Match(const std::vector<FoldedChar>& line, std::size_t at, bool active_only) const;
  void WriteGroup(const Group& group, const std::vector<FoldedChar>& line, std::size_t at,
                  std::vector<Sign>& signs) const;

  const Script& script_;
  std::string h_glyph_;  // what the sign "h" is drawn as
  std::unordered_map<char32_t, std::uint32_t> signs_, digits_;
  std::unordered_map<std::uint32_t, char32_t> read_as_;  // glyph -> digit, behind a number
  std::vector<Group> groups_;                            // longest first
  std::uint32_t numeral_ = 0;
};

}  // namespace moontrace
