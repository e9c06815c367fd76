#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// Names of the signs that a lesson has taught so far, for TypeStyle::only, from "abc+th+numeral":
/// characters, each for its sign (a digit for its letter), then names of signs. Throws InputError:
/// none, a character without a sign, an unknown name (with the nearest).
std::vector<std::string> TaughtSigns(std::string_view given, const Script& script);

}  // namespace moontrace
