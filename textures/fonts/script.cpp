#include "textures/fonts/script.h"

namespace moontrace {

std::size_t Script::Find(std::string_view glyph_name) const noexcept {
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    if (glyphs[i].name == glyph_name) return i;
  }
  return npos;
}

}  // namespace moontrace
