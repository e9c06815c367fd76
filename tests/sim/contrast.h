#pragma once

#include <algorithm>
#include <cmath>

#include "sim/picture/drawing.h"

namespace moontrace {

/// Contrast ratio of two colours by WCAG 2.1, 1 to 21: relative luminance of sRGB, with 0.05 of
/// flare.
inline double Contrast(const Color& a, const Color& b) {
  const auto linear = [](double share) {
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  const auto luminance = [&](const Color& color) {
    return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
  };
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

inline constexpr double kContrastOfText = 4.5, kContrastOfGraphics = 3;  // WCAG AA

}  // namespace moontrace
