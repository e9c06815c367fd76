#include "sim/view/view_look.h"

#include <mujoco/mujoco.h>

#include <algorithm>

namespace moontrace {

namespace {

constexpr int kWidth = 344, kLabel = 114, kScroll = 10;  // at 100 % [points]

void Set(float (&to)[3], const Color& color) {
  to[0] = static_cast<float>(color.red);
  to[1] = static_cast<float>(color.green);
  to[2] = static_cast<float>(color.blue);
}

}  // namespace

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

int TextRoom(const mjrContext_& context) {
  constexpr int kEdges = 34;  // of an item, left and right, at 100 % [points]
  return (kWidth - kScroll - kLabel - kEdges) * context.fontScale / 100;
}

void SetTheme(mjUI_& ui, const ViewColors& colors) {
  ui.spacing = mjui_themeSpacing(0);
  ui.spacing.total = kWidth;
  ui.spacing.label = kLabel;
  ui.spacing.scroll = kScroll;
  ui.spacing.samples = 0;  // smooth edges cost software rendering dear
  ui.color = mjui_themeColor(0);
  mjuiThemeColor& theme = ui.color;
  Set(theme.master, colors.back);
  Set(theme.sectpane, colors.back);
  Set(theme.secttitle, colors.title);
  Set(theme.sectfont, {1, 1, 1});
  Set(theme.sectsymbol, {1, 1, 1});
  Set(theme.thumb, colors.button);
  Set(theme.fontactive, colors.text);
  Set(theme.fontinactive, colors.text);
  Set(theme.decorinactive, colors.button);
  Set(theme.decorinactive2, colors.button);
  Set(theme.button, colors.button);
  Set(theme.radio, colors.chosen);
  Set(theme.check, colors.chosen);
  Set(theme.select, colors.button);
  Set(theme.select2, colors.back);
  Set(theme.slider, colors.button);
  Set(theme.slider2, colors.chosen);
  Set(theme.edit, colors.pane);
}

}  // namespace moontrace
