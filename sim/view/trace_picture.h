#pragma once

#include <string>
#include <vector>

#include "lessons/scoring.h"
#include "sim/app/trial.h"
#include "sim/view/drawing.h"
#include "textures/script.h"
#include "textures/typeset.h"

namespace moontrace {

/// What was traced, the tip's way over it, rings where the tip left, and a legend in words.
/// `result.path` must have been kept. `text` is the page's own text.
Drawing TracePicture(const TextPage& page, const Script& script, const TypeStyle& style, bool blank,
                     const std::string& text, const TrialResult& result);

}  // namespace moontrace
