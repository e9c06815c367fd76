#pragma once

#include <cstdint>
#include <memory>

#include "sim/reading/reading_run.h"
#include "textures/fonts/script.h"
#include "textures/typeset/style.h"

namespace moontrace {

/// Completes a setup whose page, field, scene, hand and senses are there: what the reader is told,
/// and, by the seed alone, how the page lies and what is left to chance. The page is turned by up
/// to 3 degrees, the hand put on the text's upper left corner to within half a size, and the range
/// of sizes from half the true one to twice, even in its logarithm.
void CompleteSetup(ReadingSetup& setup, std::shared_ptr<const SignShapes> shapes,
                   const Script& script, const TypeStyle& style, std::uint64_t seed);

}  // namespace moontrace
