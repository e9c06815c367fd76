#pragma once

#include <string>
#include <string_view>

namespace moontrace {

/// Text for comparing without regard to capitals: Unicode's full case folding, composed, so that
/// "STRASSE" and "straße" are alike; what is not well-formed UTF-8 as it is.
std::string CaseFolded(std::string_view utf8);

}  // namespace moontrace
