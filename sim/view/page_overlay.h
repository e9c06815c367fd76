#pragma once

#include "sim/view/canvas.h"
#include "sim/view/page_renderer.h"

namespace moontrace {

/// What lies over the drawn page, in the part `box` of the picture: print below the letters, and
/// the stylus, a pen whose shadow parts from it as it is lifted (light from the upper left).
void DrawPageOverlay(const ViewMarks& marks, const PageCamera& camera, const PixelBox& box,
                     Canvas& canvas);

}  // namespace moontrace
