#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moontrace {

/// HTML as it is given to the parser, and what had to be changed.
struct TamedHtml {
  std::string html;
  std::size_t flattened = 0;  ///< elements left out since they were nested too deep
};

/// Bounds what parsing takes in time and memory, which grows with the square of some inputs. Start
/// tags below 400 open elements go, their text stays; attributes behind the 60th of a tag go;
/// elements that only change how letters look (b, i, em, font ...) become `span`, which a parser
/// need not open again in each later element; addresses that hold their picture ("data:") go.
/// In `xhtml` an element that ends in "/>" is empty, which HTML does not know: "<title/>" would
/// take the rest of the file. Linear in the text. Throws InputError (`name`, cause) for more than
/// kMostElements elements.
TamedHtml TameHtml(std::string_view html, const std::string& name, bool xhtml);

/// The encoding that the first 4 KB of a document declare, by `<meta>` or `<?xml`; else empty.
std::string DeclaredEncoding(std::string_view bytes);

}  // namespace moontrace
