#pragma once

#include <string>

#include "sim/picture/drawing.h"

namespace moontrace {

/// The drawing as an SVG 1.1 file with <title> and <desc>, 1 user unit = 1 mm, three decimals.
/// Arcs stay arcs. The same drawing gives the same bytes.
std::string ToSvg(const Drawing& drawing);

}  // namespace moontrace
