#include "lessons/measure/intended_strokes.h"

#include <algorithm>

#include "lessons/measure/centre_arc.h"

namespace moontrace {
namespace {

std::vector<Piece> PlacedPieces(const Stroke& stroke, double size, glm::dvec2 origin_P) {
  std::vector<Piece> placed;
  for (const Piece& piece : stroke.pieces) placed.push_back(Placed(piece, size, origin_P));
  return placed;
}

/// Half the width of a dot, which is no less than that of a groove.
double DotRadius(const Stroke& dot, double size, double width) {
  Box box;
  for (const Piece& piece : dot.pieces) Include(box, BoundsOf(piece));
  return std::max(size * (box.max.x - box.min.x), width) / 2;
}

}  // namespace

std::vector<IntendedStroke> IntendedStrokes(const TextPage& page, const Script& script,
                                            const TypeStyle& style) {
  std::vector<IntendedStroke> strokes;
  for (std::size_t i = 0; i < page.glyphs.size(); ++i) {
    const PlacedGlyph& placed = page.glyphs[i];
    if (placed.kind == LineKind::kHead) continue;
    const double scale = ScaleOf(placed.kind, style);
    for (const Stroke& stroke : script.glyphs.at(placed.glyph).strokes) {
      if (stroke.pieces.empty()) continue;
      IntendedStroke intended;
      intended.kind = stroke.kind;
      intended.width = scale * style.width;
      intended.spine_P = PlacedPieces(stroke, scale * style.size, placed.origin_P);
      if (stroke.kind == StrokeKind::kFill) intended.outline_P = intended.spine_P;
      if (stroke.kind != StrokeKind::kStroke) {
        intended.spine_P = CentreArc(intended.spine_P, intended.width / 2);
      }
      intended.glyph = i;
      if (stroke.kind == StrokeKind::kDot) {
        intended.dot_radius = DotRadius(stroke, scale * style.size, intended.width);
      }
      if (placed.kind == LineKind::kHeading && style.structure.heading_relief) {
        intended.relief = *style.structure.heading_relief;
      } else {
        intended.relief = style.relief;
      }
      strokes.push_back(intended);
    }
  }
  return strokes;
}

double LengthOf(const IntendedStroke& stroke) {
  return stroke.kind == StrokeKind::kDot ? stroke.width : Length(stroke.spine_P);
}

}  // namespace moontrace
