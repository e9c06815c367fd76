#include "sim/view/moon_marks.h"

#include <utility>

namespace moontrace {

namespace {

constexpr double kMillimetres = 1e3;

/// A stroke of a placed glyph in the drawing's millimetres.
std::vector<Piece> InDrawing(const Stroke& stroke, const PlacedGlyph& placed,
                             const TypeStyle& style, glm::dvec2 from_P) {
  std::vector<Piece> pieces;
  for (const Piece& piece : stroke.pieces) {
    pieces.push_back(
        Placed(piece, kMillimetres * style.size, kMillimetres * (placed.origin_P - from_P)));
  }
  return pieces;
}

}  // namespace

std::vector<Mark> MoonMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                            glm::dvec2 from_P, Color color) {
  PathMark lines;
  lines.stroke = color;
  lines.width = kMillimetres * style.width;
  PathMark fills;
  fills.fill = color;
  for (const PlacedGlyph& placed : page.glyphs) {
    for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
      PathMark& mark = stroke.kind == StrokeKind::kStroke ? lines : fills;
      mark.subpaths.push_back(InDrawing(stroke, placed, style, from_P));
    }
  }
  std::vector<Mark> marks;
  if (!lines.subpaths.empty()) marks.emplace_back(std::move(lines));
  if (!fills.subpaths.empty()) marks.emplace_back(std::move(fills));
  return marks;
}

std::vector<Mark> CentreLineMarks(const TextPage& page, const Script& script,
                                  const TypeStyle& style, glm::dvec2 from_P, Color color) {
  PathMark lines;
  lines.stroke = color;
  lines.width = kMillimetres * style.width / 8;
  lines.dashed = true;
  for (const PlacedGlyph& placed : page.glyphs) {
    for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
      lines.subpaths.push_back(InDrawing(stroke, placed, style, from_P));
    }
  }
  std::vector<Mark> marks;
  if (!lines.subpaths.empty()) marks.emplace_back(std::move(lines));
  return marks;
}

Box InkBounds(const TextPage& page, const Script& script, const TypeStyle& style) {
  Box bounds;
  for (const PlacedGlyph& placed : page.glyphs) {
    for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
      for (const Piece& piece : stroke.pieces) {
        Include(bounds, BoundsOf(Placed(piece, style.size, placed.origin_P)));
      }
    }
  }
  if (bounds.min.x > bounds.max.x) Include(bounds, glm::dvec2(0, 0));
  return Grown(bounds, style.width / 2);
}

}  // namespace moontrace
