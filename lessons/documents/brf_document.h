#pragma once

#include <string>
#include <string_view>

#include "lessons/documents/document.h"

namespace moontrace {

/// A Braille file of North American ASCII Braille (BRF): a byte a cell, lines as an embosser writes
/// them, form feeds between pages. Texts are Unicode's Braille patterns, a blank cell is a space.
/// A blank line or an indented one begins a paragraph, the lines of a paragraph are joined; a line
/// in the middle, indented by four cells and more, is a heading. Bytes that are no cell become
/// U+FFFD and are counted. Linear in the text. Throws InputError (`name`, cause): more than
/// kMostBlocks.
Document ReadBrf(std::string_view bytes, const std::string& name);

/// Whether most of what a document shows are Braille patterns.
bool IsBraille(const Document& document);

}  // namespace moontrace
