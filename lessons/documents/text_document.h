#pragma once

#include <string>
#include <string_view>

#include "lessons/documents/document.h"

namespace moontrace {

/// Plain text, UTF-8: blank lines part paragraphs. Lines of a paragraph are joined where each was
/// ended because the next word had no room; others (verse, lists, addresses, what is set in) stay
/// lines. `marks`: "# " to "### " begin a heading and "> " a line of a quotation, as `--structure`
/// reads them. Linear in the text. Throws InputError (`name`, cause): more than kMostBlocks.
Document ReadPlainText(std::string_view text, const std::string& name, bool marks);

}  // namespace moontrace
