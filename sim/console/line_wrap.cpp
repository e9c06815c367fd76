#include "sim/console/line_wrap.h"

#include <algorithm>

#include "textures/base/text_file.h"

namespace moontrace {

std::string Wrapped(std::string_view text, std::size_t columns) {
  std::string lines;
  std::size_t used = 0;
  while (!text.empty()) {
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, space);
    text.remove_prefix(std::min(space + 1, text.size()));
    const std::size_t length = CountCharacters(word);
    if (used > 0 && used + 1 + length > columns) {
      lines += '\n';
      used = 0;
    }
    if (used > 0) {
      lines += ' ';
      ++used;
    }
    lines += word;
    used += length;
  }
  return lines + '\n';
}

}  // namespace moontrace
