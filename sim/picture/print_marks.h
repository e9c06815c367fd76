#pragma once

#include <string_view>
#include <vector>

#include "sim/picture/drawing.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// Where the print of a sign may stand, up the page [m]: `top` is below its line's strokes and
/// lower rule, `bottom` above the strokes and the upper rule of a next line, or the sheet's edge.
/// Where the lower edge of a raised margin leaves too little of that, it lies below this, as far as
/// the sheet goes.
struct PrintRoom {
  double top = 0, bottom = 0;
};

/// One a glyph of the page, in its order. Without rules `bottom` may lie above `top`: strokes of
/// two lines may overlap.
std::vector<PrintRoom> PrintRooms(const TextPage& page, const Script& script,
                                  const TypeStyle& style);

/// The print of each sign, for sighted helpers: below the strokes of its line's kind and below
/// its lower rule, on no raised margin; under the foot of letters that lean. `source` is the text
/// that was set; the drawing's origin is the sheet's lower left corner. Throws InputError where the
/// line pitch leaves no room for print of 0.5 mm between rules.
std::vector<Mark> PrintMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                             std::string_view source);

}  // namespace moontrace
