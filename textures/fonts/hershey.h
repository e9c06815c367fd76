#pragma once

#include <string>
#include <string_view>

#include "textures/fonts/script.h"

namespace moontrace {

/// Reads a Hershey font in James Hurt's format (`.jhf`), ASCII-addressed as Debian's
/// hershey-fonts-data is: the first record is the space, the next is "!", and so on to "~"; what
/// follows has no character and goes by its number ("#95"). A record: five columns of a number that
/// is not used, three of the count of pairs, the pair of left and right edge, then the points; each
/// coordinate is a letter, "R" is 0, y points down; the pair " R" lifts the pen. Line breaks within
/// a record count for nothing. A record whose edges leave no room (symbolic.jhf has some) steps on
/// by what is drawn and five units.
///
/// Capitals reach from y = 9, the base line, to y = -12: 21 units are one em. Strokes are
/// `RoundedPolyline`s within kPolylineTolerance; a single point is a dot. `name` is the script's,
/// `file_name` stands in messages. Throws InputError (file:line:column, cause, cure): more than
/// 1 MB, more than 4000 records, anything else than that format, nothing drawn.
Script ParseHershey(std::string_view jhf, const std::string& name, const std::string& file_name);

constexpr std::size_t kMaxHersheyBytes = std::size_t{1} << 20U;

}  // namespace moontrace
