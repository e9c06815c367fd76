#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace moontrace {

/// Bytes of the code point at the front, which is put into `c`; 0 where the bytes are not
/// well-formed UTF-8 or there are none.
std::size_t Decode(std::string_view utf8, char32_t& c) noexcept;

/// Offset of the first byte that does not belong to well-formed UTF-8 (Unicode, table 3-7: no
/// overlong forms, no surrogates, nothing above U+10FFFF); nothing when all of it does.
std::optional<std::size_t> FirstBadUtf8(std::string_view bytes) noexcept;

/// Whether a character is a letter of a word, or a mark on one.
bool IsLetter(char32_t c);

/// Unicode's categories: Mn, Mc and Me (a mark on the character before it), Zs, Cc.
bool IsMark(char32_t c);
bool IsSpaceSeparator(char32_t c);
bool IsControlCode(char32_t c);

/// Code points of valid UTF-8, for the short texts of a script's tables; stops at invalid bytes.
std::u32string ToCodePoints(std::string_view utf8);

/// UTF-8 of one code point.
std::string ToUtf8(char32_t c);

/// Text to show in a message: as it is, but control, format, private and unassigned characters as
/// "U+001B", and nothing behind the first 16 characters.
std::string Shown(std::string_view utf8);

/// Characters that must not pass from foreign text into a line for people: controls, marks that
/// turn the direction of writing, what has no width, line and paragraph separators, tags, and
/// private use, which everybody's font draws otherwise (Unicode's categories Cc, Cf, Zl, Zp, Co,
/// and noncharacters).
bool IsHidden(char32_t code) noexcept;

/// Well-formed UTF-8 has one of them.
bool HasHidden(std::string_view utf8) noexcept;

/// Each of them made a "?". `utf8` is well-formed.
std::string HiddenShown(std::string_view utf8);

/// Text for comparing without regard to capitals: Unicode's full case folding, composed, so that
/// "STRASSE" and "straße" are alike; what is not well-formed UTF-8 as it is.
std::string CaseFolded(std::string_view utf8);

}  // namespace moontrace
