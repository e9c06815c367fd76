#pragma once

#include <string>
#include <string_view>

#include "lessons/documents/markup_elements.h"

namespace moontrace {

/// Parses XHTML as XML and gives its elements to `sink`; false, and nothing given, where it is not
/// well-formed. `xml` is UTF-8. Character references, HTML's names and short internal entities are
/// decoded; an entity that holds others or elements stays as it is, external ones are never read.
/// Linear in the text. Throws InputError (`name`, cause) for more than kMostElements elements.
bool ReadXmlMarkup(std::string_view xml, const std::string& name, MarkupSink& sink);

}  // namespace moontrace
