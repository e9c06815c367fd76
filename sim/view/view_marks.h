#pragma once

#include "sim/page_view/page_camera.h"
#include "sim/page_view/page_renderer.h"
#include "sim/page_view/view_page.h"
#include "sim/view/view_history.h"

namespace moontrace {

/// What is drawn over the page: hand, forces, path, current letter and stroke, print letters where
/// they are wanted and there is room for them. `picture_height` of the page's part and
/// `print_height` of a small and a big print letter [points].
ViewMarks MarksOf(const ViewPage& page, const ViewHistory& history, const PageCamera& camera,
                  double aspect, bool print, double picture_height, double print_height,
                  double big_print_height);

/// Where the middle of upright print stands that is `half` a letter high to either side, where its
/// middle and the middle of its upper edge would be seen on a face that leans away: clear of what
/// is above that edge. Any one unit; on a face that is read from the side the middle stays.
glm::dvec2 UprightPrint(glm::dvec2 middle, glm::dvec2 top, double half);

}  // namespace moontrace
