#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/view/view_look.h"

struct mjrContext_;

namespace moontrace {

/// Printable ASCII of a text: all that MuJoCo's letters can show; `other` for each character else.
std::string AsciiOf(std::string_view text, std::string_view other);

/// Width of printable ASCII in MuJoCo's letters, normal or big [points].
int TextWidth(const std::string& ascii, bool big, const mjrContext_& context);

/// The rows that words of printable ASCII fill, none wider than `room` but for a longer word; where
/// `most` are not enough the last one ends with "...".
std::vector<std::string> RowsOf(const std::string& ascii, int room, std::size_t most,
                                const mjrContext_& context);

/// Writes printable ASCII with its left lower corner at a point, no wider than `room`: what does
/// not fit is cut off.
void WriteText(const std::string& ascii, int x, int y, int room, bool big, const Color& color,
               const mjrContext_& context);

void FillBox(const PixelBox& box, const Color& color);
/// Round a box, outside it, so many points thick.
void FrameBox(const PixelBox& box, int thick, const Color& color);

}  // namespace moontrace
