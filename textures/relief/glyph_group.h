#pragma once

#include "textures/field/texture.h"
#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// The tree of one page: page > line > glyph, in one layer, or two where headings have another
/// relief. A glyph's group is shared by all its places of one size; lines stand at the page's
/// origin.
Texture BuildTexture(const TextPage& page, const Script& script, const TypeStyle& style);

/// Elements of one glyph at a size, in the glyph's frame [m]: the pieces of strokes, then a dot at
/// each of their ends and joints (none for a full circle), then fills. A dot of the script becomes
/// a disc of at least the groove's width, so that it has the full depth.
Group BuildGlyph(const Glyph& glyph, const TypeStyle& style);

}  // namespace moontrace
