#pragma once

#include <vector>

#include "sim/view/canvas.h"
#include "sim/view/view_history.h"

namespace moontrace {

/// Where the numbers of an axis stand, from 0: steps of 1, 2 or 5 times a power of ten, at most
/// four of them, the last not below `most` and `least` (above 0).
std::vector<double> RoundAxis(double most, double least);

/// Force, error, tick lateness and motor heat over the last 10 s, one figure below the other.
void DrawPlots(const ViewHistory& history, const ViewLook& look, const PixelBox& box,
               Canvas& canvas);

}  // namespace moontrace
