#pragma once

#include <string>
#include <string_view>

namespace moontrace {

/// Text as it may stand in XML and HTML, in elements and in quoted attributes: & < > and " written
/// as entities. What has no place in XML at all, control characters say, is the caller's to mend.
std::string EscapedXml(std::string_view text);

}  // namespace moontrace
