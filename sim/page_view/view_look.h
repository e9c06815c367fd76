#pragma once

#include <array>

#include "sim/picture/drawing.h"

namespace moontrace {

/// How the view looks, beside what it shows.
struct ViewLook {
  bool print = true, plots = true, panel = true;  ///< shown
  bool high_contrast = false, large_text = false;
  bool operator==(const ViewLook&) const = default;
};

/// Colours of what stands round the page. By WCAG 2.1 AA: text has a contrast of 4.5 and more on
/// all that it stands on, edges, focus and what is chosen have 3 beside what is next to them.
struct ViewColors {
  Color back{0.93, 0.94, 0.95};    ///< of panel, plots and the lower edge
  Color pane{0.99, 0.99, 0.99};    ///< of a plot
  Color text{0.08, 0.09, 0.11};    ///< on these, on buttons and on what is chosen
  Color title{0.16, 0.24, 0.36};   ///< text that begins a part of the panel
  Color button{0.99, 0.99, 0.99};  ///< and what a slider moves on
  Color chosen{0.30, 0.58, 0.83};
  Color edge{0.44, 0.49, 0.55};  ///< of buttons
  Color focus{0.80, 0.30, 0.00};
};

inline ViewColors ColorsOf(const ViewLook& look) {
  if (!look.high_contrast) return {};
  return {{0, 0, 0}, {0, 0, 0},          {1, 1, 1},          {1, 1, 1},
          {0, 0, 0}, {0.10, 0.42, 0.85}, {0.75, 0.75, 0.75}, {1, 0.85, 0}};
}

/// Of the plots' curves, on ViewColors::pane: force, error, lateness, heat.
inline std::array<Color, 4> CurveColors(const ViewLook& look) {
  if (look.high_contrast) {
    return {{{0.34, 0.71, 0.91}, {1.00, 0.60, 0.20}, {0.20, 0.90, 0.65}, {0.95, 0.65, 0.82}}};
  }
  return {{{0.00, 0.45, 0.70}, {0.80, 0.30, 0.00}, {0.00, 0.50, 0.36}, {0.65, 0.30, 0.50}}};
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

}  // namespace moontrace
