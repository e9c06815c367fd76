#pragma once

#include <cstdint>
#include <memory>

#include "devices/core/device.h"
#include "sim/reading/reading_run.h"
#include "textures/fonts/script.h"
#include "textures/typeset/style.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// Completes a setup whose page, field, scene, hand and senses are there: what the reader is told,
/// and, by the seed alone, how the page lies and what is left to chance. The page is turned by up
/// to 3 degrees, the hand put on the text's upper left corner to within half a size, and the range
/// of sizes from half the true one to twice, even in its logarithm.
void CompleteSetup(ReadingSetup& setup, std::shared_ptr<const SignShapes> shapes,
                   const Script& script, const TypeStyle& style, std::uint64_t seed);

/// Whether a device tells its hand of walls: it measures and pushes along the paper. Without a
/// height its hand presses and lifts by other means, a button or a lever say.
bool CanBeReadOn(const DeviceLimits& limits);

/// The greatest sheet, A4 at most, that lies within a device's reach.
PageSpec SheetWithin(const DeviceLimits& limits);

}  // namespace moontrace
