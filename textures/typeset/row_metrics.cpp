#include "textures/typeset/row_metrics.h"

#include <algorithm>

namespace moontrace {
namespace {

Box BoundsOf(const Glyph& glyph) {
  Box box{{0, 0}, {0, 0}};
  for (const Stroke& stroke : glyph.strokes) {
    for (const Piece& piece : stroke.pieces) Include(box, moontrace::BoundsOf(piece));
  }
  return box;
}

// The middle of the lowest stroke or dot, below which only its own width lies [em].
double LowestMiddle(const Glyph& glyph) {
  double lowest = 0;
  for (const Stroke& stroke : glyph.strokes) {
    for (const Piece& piece : stroke.pieces) {
      const Box box = moontrace::BoundsOf(piece);
      const bool dot = stroke.kind == StrokeKind::kDot;
      lowest = std::min(lowest, dot ? (box.min.y + box.max.y) / 2 : box.min.y);
    }
  }
  return lowest;
}

}  // namespace

RowMetrics MeasureRows(const Script& script, const TypeStyle& style, double scale) {
  const bool vertical = style.lines == LineDirection::kVertical;
  const double letter_gap = scale * style.letter_gap;
  RowMetrics row;
  row.size = scale * style.size;
  row.space = script.space_advance * row.size + scale * style.word_gap;
  row.gap = scale * (style.line_pitch - style.size);
  row.bulge = kGuideBulge * (scale * style.line_pitch);
  for (const Glyph& glyph : script.glyphs) {
    const Box bounds = BoundsOf(glyph);
    row.right.push_back(bounds.max.x * row.size);
    row.lowest.push_back(LowestMiddle(glyph) * row.size);
    const double advance = glyph.advance * row.size + letter_gap;
    // Down a column each sign has its whole box, and below it the gap that it has along a line.
    row.extent.push_back(vertical ? row.size : row.right.back());
    row.advance.push_back(vertical ? row.size + std::max(advance - row.right.back(), 0.0)
                                   : advance);
  }
  return row;
}

}  // namespace moontrace
