#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "textures/fonts/script.h"

namespace moontrace {

/// Distance of `p` to a polyline, by projection on each of its segments.
double DistanceToPolyline(glm::dvec2 p, const std::vector<glm::dvec2>& points);

/// Greatest distance of either from the other (Hausdorff), by 64 points a piece and a segment.
double DistanceOf(const Stroke& stroke, const std::vector<glm::dvec2>& points);

/// Greatest distance of a stroke's points from the other stroke, 32 a piece.
double DistanceOf(const Stroke& from, const Stroke& to);

/// What a glyph may lie off the path in its file: 0.05 mm at 20 mm [em].
constexpr double kGlyphTolerance = 0.05 / 20;

}  // namespace moontrace
