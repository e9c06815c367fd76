#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lessons/documents/markup_elements.h"

namespace moontrace {

/// Whether this build can parse HTML (libgumbo). Without, ReadHtmlMarkup throws LackError.
bool CanReadHtml();

/// Parses HTML as browsers do, whatever is wrong with it, and gives its elements to `sink`. `html`
/// is UTF-8 and was tamed (TameHtml). Nothing is ever fetched.
void ReadHtmlMarkup(std::string_view html, MarkupSink& sink);

/// The characters that a name between "&" and ";" stands for in HTML; nothing for unknown names,
/// and without libgumbo.
std::optional<std::string> NamedCharacters(std::string_view name);

}  // namespace moontrace
