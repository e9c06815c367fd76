#pragma once

#include "sim/picture/drawing.h"

struct mjUI_;
struct mjrContext_;

namespace moontrace {

/// How the view looks, beside what it shows.
struct ViewLook {
  bool print = true, plots = true, panel = true;  ///< shown
  bool high_contrast = false, large_text = false;
  bool operator==(const ViewLook&) const = default;
};

/// Colours of what stands round the page.
struct ViewColors {
  Color back{0.93, 0.94, 0.95};    ///< of panel, plots and the lower edge
  Color pane{0.99, 0.99, 0.99};    ///< of a plot
  Color text{0.10, 0.11, 0.13};    ///< on these
  Color title{0.20, 0.28, 0.38};   ///< of a part of the panel
  Color button{0.80, 0.85, 0.90};  ///< and what can be moved
  Color chosen{0.35, 0.62, 0.85};
  Color focus{0.84, 0.37, 0.00};
};

inline ViewColors ColorsOf(const ViewLook& look) {
  if (!look.high_contrast) return {};
  return {{0, 0, 0},          {0, 0, 0},         {1, 1, 1},   {0, 0, 0},
          {0.25, 0.25, 0.25}, {0.0, 0.35, 0.75}, {1, 0.85, 0}};
}

/// A rectangle of the picture [points], from the lower left.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
  bool empty() const { return width <= 0 || height <= 0; }
  bool Has(double px, double py) const {
    return px >= x && py >= y && px < x + width && py < y + height;
  }
  bool operator==(const PixelBox&) const = default;
};

/// Which part stands where; empty: not shown.
struct ViewLayout {
  PixelBox page, panel, plots, text;
};

/// Panel at the left, plots at the right, text below, the page in what is left. What leaves the
/// page less than two fifths of the width, 200 or 120 points is left out: first the plots, then the
/// panel, then the text. `panel_width` 0: no panel; `text_height` of the lower edge.
ViewLayout LayoutOf(int width, int height, int panel_width, int plots_width, int text_height);

/// Spacing and colours of MuJoCo's controls for the tutor's panel: labels of 13 letters and choices
/// of 9, two side by side, have room.
void SetTheme(mjUI_& ui, const ViewColors& colors);

/// Width of what may stand behind an item's label [points].
int TextRoom(const mjrContext_& context);

}  // namespace moontrace
