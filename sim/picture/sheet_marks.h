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

/// Line rules and the raised margin in their true width. `from_P` [m] is where the drawing's origin
/// lies on the page.
std::vector<Mark> RuleMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                            glm::dvec2 from_P);

/// Box around the middles of these ridges [m]; empty where there are none.
Box RuleBounds(const TextPage& page, const Script& script, const TypeStyle& style);

}  // namespace moontrace
