#include "sim/page_view/view_look.h"

#include <algorithm>

namespace moontrace {

ViewLayout LayoutOf(int width, int height, int panel_width, int plots_width, int text_height) {
  constexpr int kLeastHeight = 120;
  const int least_width = std::max(200, width * 2 / 5);
  ViewLayout layout;
  const int text = height - text_height >= kLeastHeight ? text_height : 0;
  const int panel = width - panel_width >= least_width ? panel_width : 0;
  const int plots = width - panel - plots_width >= least_width ? plots_width : 0;
  const int middle = std::max(width - panel - plots, 0);
  layout.panel = {0, 0, panel, height};
  layout.page = {panel, text, middle, std::max(height - text, 0)};
  layout.text = {panel, 0, width - panel, text};
  layout.plots = {panel + middle, text, plots, std::max(height - text, 0)};
  return layout;
}

}  // namespace moontrace
