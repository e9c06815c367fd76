#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moontrace {

/// Bytes read as text.
struct DecodedText {
  std::string text;  ///< UTF-8, without a byte order mark
  /// "UTF-8", "UTF-16", "UTF-32", the declared one, or one that was guessed.
  std::string encoding;
  std::size_t bad = 0;   ///< places that are no character: U+FFFD stands there
  bool guessed = false;  ///< by what characters came of it alone
};

/// Recognises the encoding: by a byte order mark; UTF-16 by zeros at every second byte; what is
/// UTF-8 as such, some broken places in it allowed; then `declared` (a label as in HTML, may be
/// empty or unknown), which counts before that where its text is ASCII in disguise (ISO-2022);
/// else it is guessed (GuessedEncoding). Any bytes may be given, see IsBinary.
DecodedText DecodeText(std::string_view bytes, std::string_view declared = {});

/// Whether bytes can hardly be text in any of these: zeros that are not UTF-16's, or more than one
/// in ten of the first 64 KB a control character.
bool IsBinary(std::string_view bytes);

/// The likeliest encoding, as iconv names it, of a text that is not UTF-8 and says nothing of it:
/// "SHIFT_JIS" where its pairs of bytes are kana; "KOI8-R" or "WINDOWS-1251" where most letters are
/// Cyrillic; else "Windows-1252", of which Latin-1 is a part.
const char* GuessedEncoding(std::string_view bytes);

}  // namespace moontrace
