#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/tutor/page_words.h"

/// Sentences about a page that is changed while it is felt.
namespace moontrace::say {

/// What the words want behind them.
std::string PageWordsHelp();
/// The page as it is from now on: "depth 50 % of the usual", without capital and stop.
std::string PageBecomes(const PageCommand& command);
/// "Depth 50 % of the usual."
std::string PageNow(const PageCommand& command);
/// `why`: what forbids it.
std::string PageStays(std::string_view why);
std::string PageStaysWhileScored();
std::string NoTiltInPlane();
/// `least`: the margin that has room [m].
std::string NoRoomForTurnMark(double least);
std::string MorePagesThan(std::size_t pages, std::size_t most);

}  // namespace moontrace::say
