#pragma once

#include <cstddef>
#include <string>

#include "sim/session/felt_page.h"

namespace moontrace {

/// The words of which not all letters are set (TypeStyle::only) up to and with the word of a glyph
/// of the page, from the word before it that has one: what is to be said as a hand comes to that
/// word. Behind the text's last letter also the rest. Words apart by single blanks; empty: none.
std::string UnsetWords(const FeltPage& page, std::size_t glyph);

}  // namespace moontrace
