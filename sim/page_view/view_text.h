#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/page_view/canvas.h"

namespace moontrace {

using TextWidthOf = std::function<int(std::string_view text)>;

/// The rows that words fill, none wider than `room` but for a longer word; where `most` are not
/// enough the last one ends with "...".
std::vector<std::string> RowsOf(std::string_view text, int room, std::size_t most,
                                const TextWidthOf& width);

/// The same of the newest of several texts, the newest last: as many of them as fit wholly, and the
/// newest in any case.
std::vector<std::string> NewestRowsOf(const std::vector<std::string>& texts, int room,
                                      std::size_t most, const TextWidthOf& width);

/// Writes one line with its left lower corner at a point, no wider than `room`: what does not fit
/// is cut off at its end.
void WriteText(std::string_view text, int x, int y, int room, bool big, const Color& color,
               Canvas& canvas);

/// Without its first or last character, in UTF-8.
void DropFirst(std::string& text);
void DropLast(std::string& text);

}  // namespace moontrace
