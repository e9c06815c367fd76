#pragma once

#include <string>
#include <string_view>

namespace moontrace {

/// A name to be said aloud, of one character (UTF-8) that cannot be seen or that screen readers
/// pass over: "zero width space (U+200B)", "apostrophe"; those of ASCII without their number. For
/// other control, format and private characters and lone marks the number only, "U+001B"; empty
/// for all else, and for anything but one character. Names are Unicode's, in lower case.
std::string CharacterName(std::string_view utf8);

}  // namespace moontrace
