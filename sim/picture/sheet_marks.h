#pragma once

#include <vector>

#include "sim/picture/drawing.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// The roughness of a page's sheet and of its patches, as light areas where it rises above a
/// quarter of the amplitude, in paths of at most some hundred thousand points; nothing if it is too
/// fine to be drawn (CanDraw).
std::vector<Mark> TextureMarks(const std::vector<PaperPatch>& patches);
bool CanDraw(const PaperPatch& patch);

/// Line rules and the raised margin in their true width.
std::vector<Mark> RuleMarks(const TextPage& page, const Script& script, const TypeStyle& style);

}  // namespace moontrace
