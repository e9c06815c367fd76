#pragma once

#include <cstddef>
#include <string>

#include "sim/session/felt_page.h"
#include "textures/typeset/left_out.h"

namespace moontrace {

/// The words for which a glyph of the page stands as the mark of what was left out (kLeftOutMark):
/// what is to be said as a hand comes to it. Empty: it is another sign.
std::string UnsetWords(const FeltPage& page, std::size_t glyph);

/// Words of all pages of a text, and how many of them are left out.
LeftOutWords CountLeftOut(const TextSetup& text);

}  // namespace moontrace
