#include "sim/html_report/html_text.h"

#include "textures/base/text_file.h"
#include "textures/base/xml_text.h"

namespace moontrace {

std::string HtmlText(std::string_view text) {
  std::string html = EscapedXml(OneLine(text, text.size() + 1));
  // no characters in XML: U+FFFE and U+FFFF
  for (const char* none : {"\xef\xbf\xbe", "\xef\xbf\xbf"}) {
    for (std::size_t at = html.find(none); at != std::string::npos; at = html.find(none, at)) {
      html.replace(at, 3, 1, '?');  // GCC 12 warns of a text here
    }
  }
  return html;
}

}  // namespace moontrace
