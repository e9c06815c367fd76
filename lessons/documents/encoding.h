#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moontrace {

/// Bytes read as text.
struct DecodedText {
  std::string text;      ///< UTF-8, without a byte order mark
  std::string encoding;  ///< "UTF-8", "UTF-16", "Windows-1252", or the declared one
  std::size_t bad = 0;   ///< places that are no character: U+FFFD stands there
};

/// Recognises the encoding: by a byte order mark; by zeros at every second byte (UTF-16); what is
/// UTF-8 as such, some broken places in it allowed; then `declared` (a label as in HTML, may be
/// empty or unknown), which counts before that where its text is ASCII in disguise (ISO-2022);
/// else Windows-1252, of which Latin-1 is a part. Any bytes may be given, see IsBinary.
DecodedText DecodeText(std::string_view bytes, std::string_view declared = {});

/// Whether bytes can hardly be text in any of these: zeros that are not UTF-16's, or more than one
/// in ten of the first 64 KB a control character.
bool IsBinary(std::string_view bytes);

}  // namespace moontrace
