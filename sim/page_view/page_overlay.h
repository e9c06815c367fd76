#pragma once

#include "sim/page_view/canvas.h"
#include "sim/page_view/page_renderer.h"

namespace moontrace {

/// What lies over the drawn page, in the part `box` of the picture: the letter and stroke that are
/// meant, the tip's way, print below the letters, and the stylus, a pen whose shadow parts from it
/// as it is lifted (light from the upper left). Lines may reach beyond the box.
void DrawPageOverlay(const ViewMarks& marks, const PageCamera& camera, const PixelBox& box,
                     Canvas& canvas);

}  // namespace moontrace
