#pragma once

#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// Centre line of a filled outline (a crescent): the arc through its two tips and the point midway
/// between the middles of its two sides (a line where the three lie straight), as far as it lies
/// `rim` [m] or more inside the outline, where the fill has its full depth; in a fill that is
/// narrower, as far as it lies 0.9 of the middle's depth inside. The tips are the two corners of
/// the outline that are farthest apart. A circle's centre line is its centre, as a Line of length
/// zero. Travelled from the upper tip to the lower, between level tips from the left.
std::vector<Piece> CentreArc(const std::vector<Piece>& outline, double rim);

}  // namespace moontrace
