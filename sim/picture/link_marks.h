#pragma once

#include <vector>

#include "sim/picture/drawing.h"
#include "textures/relief/groove_links.h"

namespace moontrace {

/// Groove links as lines of half the letters' width: shallow beside deep. `from_P` [m] is where the
/// drawing's origin lies on the page.
std::vector<Mark> LinkMarks(const GrooveLinks& links, const Script& script, const TypeStyle& style,
                            glm::dvec2 from_P, Color color);

}  // namespace moontrace
