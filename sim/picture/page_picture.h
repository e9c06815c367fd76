#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/picture/drawing.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// Which page of how many, from 0.
struct PageNumber {
  std::size_t page = 0, pages = 1;
};

/// A sheet in its true size: its edge, its strokes and, with `print_letters`, the source text in
/// small print below each sign. Of `set` style and page's size count, `source` is the text that was
/// set.
Drawing PagePicture(const TextPage& page, PageNumber number, const Typeset& set,
                    const Script& script, std::string_view source, bool print_letters);

/// A sheet for swell paper, which rises where it is black: strokes are, and nothing else is drawn.
Drawing SwellPage(const TextPage& page, const Typeset& set, const Script& script,
                  const std::string& title);

}  // namespace moontrace
