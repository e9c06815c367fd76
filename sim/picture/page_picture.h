#pragma once

#include <cstddef>
#include <string_view>

#include "sim/picture/drawing.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A sheet in its true size: its edge, its strokes and, with `print_letters`, the source text in
/// small print below each sign. `source` is the text that was set.
Drawing PagePicture(const Typeset& set, std::size_t page, const Script& script,
                    std::string_view source, bool print_letters);

}  // namespace moontrace
