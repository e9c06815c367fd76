#pragma once

#include <string>
#include <string_view>

namespace moontrace {

/// Text as it may stand in XML and HTML, in elements and in quoted attributes: & < > and " written
/// as entities. Characters that XML does not allow at all, such as control characters, are left to
/// the caller.
std::string EscapedXml(std::string_view text);

}  // namespace moontrace
