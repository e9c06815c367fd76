#pragma once

#include <string>
#include <vector>

#include "lessons/measure/scoring.h"
#include "sim/picture/drawing.h"
#include "sim/trial/trial.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// What was traced, the tip's path over it, rings where the tip left, and a legend in words.
/// `result.path` must have been kept. `text` is the page's own text.
Drawing TracePicture(const TextPage& page, const Script& script, const TypeStyle& style, bool blank,
                     const std::string& text, const TrialResult& result);

}  // namespace moontrace
