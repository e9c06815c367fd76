#pragma once

#include <string_view>
#include <vector>

#include "sim/picture/drawing.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// The print of each sign, for sighted helpers: below the strokes of its line's kind and below
/// its lower rule; under the foot of letters that lean. `source` is the text that was set; the
/// drawing's origin is the sheet's lower left corner. Throws InputError where the line pitch leaves
/// no room for print of 0.5 mm between rules.
std::vector<Mark> PrintMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                             std::string_view source);

}  // namespace moontrace
