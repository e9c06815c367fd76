#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace moontrace {

/// One cell of a translation, and the characters of the input that it stands for: [begin, end). Of
/// several cells for the same characters the last has them, those before (indicators: capital,
/// number) have an empty range at its begin.
struct BrailleCell {
  std::uint8_t dots = 0;  ///< bit 0 is dot 1, bit 7 dot 8; 0 is the blank cell
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// A translation table of liblouis, the library of Braille codes. The only place that knows it.
/// The library has one state for the whole program: calls wait for each other, and what it would
/// print goes into the errors thrown here.
class BrailleTable {
 public:
  /// `name` as liblouis takes it: "en-ueb-g2.ctb", a path, or several joined by commas. Throws
  /// LackError when this build is without liblouis, InputError for a table that is missing (with
  /// the nearest name), broken, over 16 MB, or that includes more than 90 files, or itself.
  explicit BrailleTable(const std::string& name);

  /// Whether the table writes the character, standing alone, as anything.
  bool Has(char32_t c) const;

  /// Cells of one line, none of whose characters is a control character. Characters without a form
  /// give no cell. Lines over 64 Ki characters are translated in parts, parted at spaces. Throws
  /// InputError when the table makes more than 16 cells of a character.
  std::vector<BrailleCell> Translate(std::u32string_view line) const;

  /// What the cells say, UTF-8; nothing for a cell that the table does not read. Braille is read by
  /// rules of its own: it need not be what was written.
  std::string ReadBack(const std::vector<std::uint8_t>& cells) const;

 private:
  std::string name_;
  mutable std::unordered_map<char32_t, bool> has_;
};

}  // namespace moontrace
