#pragma once

#include <string>

#include "sim/picture/drawing.h"
#include "sim/reading/reading_run.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A page that was read by touch: the tip's paths over it, searching and following, and below each
/// place where a sign was found what it was taken for. `result.path` must have been kept.
Drawing ReadingPicture(const TextPage& page, const Script& script, const TypeStyle& style,
                       bool blank, const std::string& text, const ReadingResult& result);

}  // namespace moontrace
