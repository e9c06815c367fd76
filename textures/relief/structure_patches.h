#pragma once

#include <vector>

#include "textures/field/texture.h"
#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// The rough paper below headings, quotations and links: one patch a row, from its first sign to
/// its last, reaching over half the gap between lines. A row with links has theirs on top of its
/// own. Empty unless the style asks for it.
std::vector<PaperPatch> StructurePatches(const TextPage& page, const Script& script,
                                         const TypeStyle& style);

/// Adds them to a page's tree.
void AddStructurePatches(const TextPage& page, const Script& script, const TypeStyle& style,
                         Texture& texture);

}  // namespace moontrace
