#pragma once

#include "textures/field/paper.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// A strip of rough paper in the margin below the last line, at its right end: a finger that has
/// read the page to its end finds it by going on downwards, and by reaching it turns the page. It
/// is rougher than the paper of headings, quotations and links.
/// Throws InputError: the margin is below 4 mm, and has no room for it.
PaperPatch TurnMark(const PageSpec& page);

}  // namespace moontrace
