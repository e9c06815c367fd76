#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "textures/fonts/script.h"
#include "textures/typeset/louis.h"
#include "textures/typeset/style.h"

namespace moontrace {

/// Reads lines of Braille cells. liblouis reads first; a reading counts when the table writes it in
/// these very cells again. Where it does not, the line is read word by word: by the script's
/// uncontracted table too, in parts ("(it's)" as bracket, word, bracket), with other capitals, and
/// with passages of capitals taken apart, until a reading counts. Of readings that are written
/// alike, typewriter marks are taken: ' for ’, ... for …. A word that none of this reads stays as
/// liblouis has it. Keeps a bounded memory of words.
class BrailleReader {
 public:
  /// Throws as BrailleWriter does.
  BrailleReader(const Script& script, const TypeStyle& style);

  /// What the cells of one line say, UTF-8; blank cells are spaces.
  std::string Read(const std::vector<std::uint8_t>& cells);

 private:
  using Cells = std::vector<std::uint8_t>;
  bool Writes(const std::string& text, const Cells& cells) const;
  std::optional<std::string> Confirmed(const std::string& text, const Cells& cells) const;
  std::optional<std::string> ConfirmedWord(const std::string& text, const Cells& cells) const;
  std::optional<std::string> InParts(const Cells& word) const;
  std::string ReadWord(const Cells& word);
  std::string ReadCapitalWord(const Cells& word, bool& in_passage);
  std::string ReadByWords(const Cells& cells);

  BrailleTable table_;
  std::optional<BrailleTable> plain_;  // uncontracted, where the script names another
  std::unordered_map<std::string, std::string> words_;  // read so far, by their cells
  std::size_t read_in_parts_ = 0, unread_ = 0;          // words that liblouis misread
};

}  // namespace moontrace
