#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "devices/core/device.h"
#include "sim/reading/reading_run.h"
#include "textures/fonts/script.h"
#include "textures/typeset/style.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// Whether a tip can follow the signs: grooves that stand apart, not ridges, Braille's dots or
/// linked letters, whose ends a tip would pass. Those are gone over line by line (HatchReader).
bool IsFollowed(const TypeStyle& style, const Script& script);

/// The signs of a script as a reader knows them. Of Braille the cells of six dots, and those of
/// eight where some page has one: that a text is in eight dots is said before. Its dots are known
/// by their middles, to which slopes lead; wider ones, which stand among strokes, by their floors
/// or tops, where flat paper speaks against them.
std::shared_ptr<const SignShapes> KnownShapes(const Script& script,
                                              const std::vector<TextPage>& pages);

/// The press of a hand that reads, unless another is asked for [N]: light over ridges, from which a
/// firm one slips, and lighter over raised dots, round which it would slide.
double ReadingPress(const HandModel& hand, const TypeStyle& style, const Script& script);

/// What a mind is told of its hand, and of the relief under it: not of the signs, nor of the page.
ReaderKnowledge ToldOf(const LedHandSetup& setup, const TypeStyle& style);

/// Completes a setup whose page, field, scene, hand and senses are there: what the reader is told,
/// and, by the seed alone, how the page lies and what is left to chance. The page is turned by up
/// to 3 degrees, the hand put on the corner where the text begins to within half a size, and the
/// range of sizes from half the true one to twice, even in its logarithm.
void CompleteSetup(ReadingSetup& setup, std::shared_ptr<const SignShapes> shapes,
                   const Script& script, const TypeStyle& style, std::uint64_t seed);

/// Whether a device tells its hand of letters: it measures and pushes along the paper. What is
/// followed can be felt without a height; such a hand presses and lifts by other means, a button or
/// a lever say.
bool CanBeReadOn(const DeviceLimits& limits, bool followed);

/// The greatest sheet, A4 at most, that lies within a device's reach.
PageSpec SheetWithin(const DeviceLimits& limits);

}  // namespace moontrace
