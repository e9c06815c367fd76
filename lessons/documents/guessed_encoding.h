#pragma once

#include <string_view>

namespace moontrace {

/// The likeliest encoding, as iconv names it, of a text that is not UTF-8 and says nothing of it:
/// "SHIFT_JIS" where its pairs of bytes are kana; "KOI8-R" or "WINDOWS-1251" where most letters are
/// Cyrillic; else "Windows-1252", of which Latin-1 is a part.
const char* GuessedEncoding(std::string_view bytes);

}  // namespace moontrace
