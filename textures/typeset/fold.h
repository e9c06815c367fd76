#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// Longest text [bytes] and most folded characters that are taken.
constexpr std::size_t kMostText = std::size_t{16} << 20;
/// A longer line of the text comes in parts, so that memory does not grow with it: each ends behind
/// the first blank after so many characters, or after twice as many [characters].
constexpr std::size_t kLinePart = std::size_t{1} << 16;

/// By what a character that the script has no form of is replaced.
enum class Replaced : std::uint8_t {
  kFolded,          ///< by the script's table or Unicode's decomposition
  kOtherScript,     ///< by the glyph of another script
  kTransliterated,  ///< by letters that sound alike
  kNamed            ///< by its name in brackets
};

/// One character of the text as the script can write it.
struct FoldedChar {
  enum class Kind : std::uint8_t {
    kSign,     ///< `code` is in Script::signs or Script::digits
    kSpace,    ///< a blank of any width
    kNothing,  ///< has no mark in print either (a soft hyphen)
    kMissing   ///< the script has no form; `code` is the character itself
  };
  char32_t code = 0;
  char32_t was = 0;          ///< the character of the text, of a cluster the first
  std::uint32_t begin = 0;   ///< bytes of the text that it stands for; of a character that became
  std::uint32_t end = 0;     ///< several the first has them, the others an empty range at the end
  std::uint32_t column = 0;  ///< in code points, from 1
  Kind kind = Kind::kMissing;
  bool letter = false;   ///< of a word, for contractions
  bool changed = false;  ///< not as in the text (a change of case does not count)
  bool apart = false;    ///< raised, lowered, circled, of a fraction: not of the number beside it
  Replaced replaced = Replaced::kFolded;  ///< where `changed`
};

/// Reads UTF-8 text line by line and folds it to what a script has: the script's own table first
/// (for Braille, the characters that the table of liblouis has), then upper to lower case, then
/// Unicode's compatibility decomposition without combining marks, then the script's
/// transliterations, then its names in square brackets ("[euro sign]"). Marks that no character is
/// composed with stay where a table of Braille writes them. A character of which a part
/// has no sign is missing as a whole. A space at the edge of a replacement (" and " of &) stands
/// only beside a letter or a digit. A byte order mark is skipped; CR, CRLF, form feed and Unicode's
/// own separators end a line. Linear in the text.
class Folder {
 public:
  /// Keeps references to both. Throws InputError: text over kMostText, empty, not UTF-8 (byte
  /// offset from 0, line and column from 1).
  Folder(std::string_view text, const Script& script);

  /// The same, where something other than the script's rules knows which characters have a form.
  Folder(std::string_view text, const Script& script, std::function<bool(char32_t)> has_sign);

  /// Puts the next line of the text, or the next part of a very long one, into `line`; false at the
  /// end. Throws InputError when the script's table makes the line longer than kMostText
  /// characters.
  bool NextLine(std::vector<FoldedChar>& line);
  /// Whether the last call began a line. What it gave else belongs to the one that came before.
  bool begins_line() const { return begins_line_; }
  /// The number of the line that the last call gave, from 1.
  std::size_t line_number() const { return line_number_; }

 private:
  struct Form {
    std::u32string text;
    FoldedChar::Kind kind = FoldedChar::Kind::kMissing;
    bool letter = false, changed = false, apart = false;
    Replaced replaced = Replaced::kFolded;
  };
  char32_t Read(std::size_t at, std::size_t& next) const;
  std::size_t ClusterEnd(std::size_t next, std::size_t& code_points) const;
  const Form& FormOf(char32_t c);
  const Form& FormInQuotation(char32_t c);
  Form Fold(char32_t c) const;
  bool FoldByTable(char32_t c, Form& form) const;
  Form Parted(const Form& form, std::size_t next, const std::vector<FoldedChar>& line);
  bool FoldByUnicode(char32_t c, bool transliterate, Form& form) const;
  bool WriteParts(const std::u32string& parts, bool transliterate, std::u32string& written) const;
  bool Transliterate(char32_t c, std::u32string& text) const;
  bool Name(char32_t c, Form& form) const;
  bool AppendSign(char32_t c, std::u32string& text) const;
  bool HasSign(char32_t c) const { return has_sign_(c); }
  char32_t Composed(std::size_t begin, std::size_t end) const;
  void AppendCluster(char32_t c, std::size_t base_end, FoldedChar first,
                     std::vector<FoldedChar>& line);
  void Append(const Form& form, FoldedChar first, std::vector<FoldedChar>& line) const;

  std::string_view text_;
  const Script& script_;
  std::function<bool(char32_t)> has_sign_;
  std::size_t at_ = 0;
  bool begins_line_ = true, line_ended_ = true;
  std::size_t line_number_ = 0;
  std::size_t column_ = 1;                              // of what is next, in code points
  std::size_t written_ = 0;                             // characters of the line's former parts
  bool in_low_double_ = false, in_low_single_ = false;  // opened by a low mark that has no form
  std::unordered_map<char32_t, Form> forms_;            // by character: each is worked out once
  std::unordered_map<char32_t, Form> closing_;          // of marks that open, where they close
};

}  // namespace moontrace
