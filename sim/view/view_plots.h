#pragma once

#include "sim/page_view/canvas.h"
#include "sim/view/view_history.h"

namespace moontrace {

/// Force, error, tick lateness and motor heat over the last 10 s, one figure below the other.
void DrawPlots(const ViewHistory& history, const ViewLook& look, const PixelBox& box,
               Canvas& canvas);

}  // namespace moontrace
