#pragma once

#include <vector>

#include "textures/script/script.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// What a row of letters of one size needs. Lengths in metres.
struct RowMetrics {
  double size = 0, space = 0;
  double gap = 0;                       ///< between one row and the next: line pitch less size
  double bulge = 0;                     ///< of guide lines
  std::vector<double> advance, extent;  ///< by glyph, along the line
  std::vector<double> right, lowest;    ///< by glyph, of its strokes
};

/// Guide lines bulge by this share of the line pitch.
constexpr double kGuideBulge = 0.3;

/// Metrics of rows in a style, all lengths times `scale`.
RowMetrics MeasureRows(const Script& script, const TypeStyle& style, double scale);

}  // namespace moontrace
