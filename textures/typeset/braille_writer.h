#pragma once

#include <array>
#include <string>
#include <vector>

#include "textures/typeset/line_ends.h"
#include "textures/typeset/louis.h"
#include "textures/typeset/writer.h"

namespace moontrace {

/// Writes Braille by a table of liblouis, line by line of the text. A cell's range is that of the
/// characters it stands for; indicators before a letter (capital, number) have an empty one and
/// stay on the letter's line. A character that the table lacks but the font has stands as it is.
class BrailleWriter : public Writer {
 public:
  /// `table` by name, or empty for the script's own at the grade. Throws InputError: an unknown
  /// grade, a table that cannot be used; LackError: built without liblouis.
  BrailleWriter(const Script& script, double grade, const std::string& table);

  bool Has(char32_t c) const override;
  void Write(std::string_view text, std::size_t line_number, const std::vector<FoldedChar>& line,
             std::vector<Sign>& signs, Typeset& typeset) const override;

 private:
  void WriteRun(const std::vector<FoldedChar>& run, const std::vector<LineEnd>& ends,
                std::vector<Sign>& signs) const;

  const Script& script_;
  BrailleTable table_;
  std::array<std::uint32_t, 256> cells_{};  // glyph of each cell, kNoGlyph where the font lacks it
};

/// The table that a style asks for: its own, else the script's at its grade. Throws InputError.
std::string BrailleTableOf(const Script& script, double grade, const std::string& table);

}  // namespace moontrace
