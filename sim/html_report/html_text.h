#pragma once

#include <string>
#include <string_view>

namespace moontrace {

/// Text as it may stand in HTML and XML, in elements and in quoted attributes. What is no UTF-8 or
/// may not stand in XML (control characters) becomes "?".
std::string HtmlText(std::string_view text);

}  // namespace moontrace
