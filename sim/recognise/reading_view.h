#pragma once

#include "sim/reader/page_reader.h"
#include "sim/reader/sign_shapes.h"
#include "sim/session/view_panels.h"
#include "textures/fonts/script.h"

namespace moontrace {

/// What a panel shows of who reads: the end of what was read, the likeliest signs for what was felt
/// last, and what the hand is at. `shapes`: the reader's own.
TrialTexts::Reading ReadingTexts(const PageReader& reader, const SignShapes& shapes,
                                 const Script& script);

}  // namespace moontrace
