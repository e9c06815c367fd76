#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "textures/base/units.h"

/// The words that many sentences share.
namespace moontrace::say {

std::string Counted(std::size_t count, std::string_view one, std::string_view many);
/// "never", "once", "3 times".
std::string Times(std::size_t count);
/// "a, b or c" with `last` = " or ".
std::string Joined(const std::vector<std::string>& words, std::string_view last);
/// At most `decimals`, no needless zeros.
std::string Short(double value, int decimals);
/// Four significant digits, or all of a whole part, without an exponent: "0.01234", "15000000".
std::string Plain(double value);
/// Rounded down to so many decimals, never up to a whole: 99.96 percent is not "100".
std::string Percent(double share, int decimals = 1);

/// A text of several lines within a sentence: line ends as blanks.
std::string Unbroken(std::string_view text);
/// On one line, in double quotes.
std::string Quoted(std::string_view text);
/// "did you mean NEAREST? ", or nothing if there is none.
std::string DidYouMean(std::string_view nearest);
/// The nearest of the words of a list as a sentence has it, "off, rail or bead"; empty if none is
/// near.
std::string NearestListed(std::string_view word, std::string_view list);

}  // namespace moontrace::say
