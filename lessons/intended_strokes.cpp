#include "lessons/intended_strokes.h"

#include "lessons/centre_arc.h"

namespace moontrace {
namespace {

std::vector<Piece> SpineOf(const Stroke& stroke, const TypeStyle& style, glm::dvec2 origin_P) {
  std::vector<Piece> placed;
  for (const Piece& piece : stroke.pieces) placed.push_back(Placed(piece, style.size, origin_P));
  return stroke.kind == StrokeKind::kStroke ? placed : CentreArc(placed, style.width / 2);
}

}  // namespace

std::vector<IntendedStroke> IntendedStrokes(const TextPage& page, const Script& script,
                                            const TypeStyle& style) {
  std::vector<IntendedStroke> strokes;
  for (std::size_t i = 0; i < page.glyphs.size(); ++i) {
    const PlacedGlyph& placed = page.glyphs[i];
    for (const Stroke& stroke : script.glyphs.at(placed.glyph).strokes) {
      if (stroke.pieces.empty()) continue;
      IntendedStroke intended;
      intended.kind = stroke.kind;
      intended.spine_P = SpineOf(stroke, style, placed.origin_P);
      intended.width = style.width;
      intended.glyph = i;
      strokes.push_back(intended);
    }
  }
  return strokes;
}

}  // namespace moontrace
