#include "sim/picture/moon_marks.h"

#include <array>
#include <utility>

#include "textures/base/units.h"

namespace moontrace {

namespace {

/// A stroke of a placed glyph in the drawing's millimetres.
std::vector<Piece> InDrawing(const Stroke& stroke, const PlacedGlyph& placed,
                             const TypeStyle& style, glm::dvec2 from_P) {
  std::vector<Piece> pieces;
  const double size = ScaleOf(placed.kind, style) * style.size;
  for (const Piece& piece : stroke.pieces) {
    pieces.push_back(Placed(piece, kMillimetres * size, kMillimetres * (placed.origin_P - from_P)));
  }
  return pieces;
}

/// Headings that stand out of the paper, or into it, unlike the text have a colour of their own.
Color ColorOf(LineKind kind, const TypeStyle& style, Color color) {
  const bool other = style.structure.heading_relief.value_or(style.relief) != style.relief;
  return kind == LineKind::kHeading && other ? palette::kRidge : color;
}

/// Open strokes of one line kind or another, each in its width: the text's, then headings'.
using Lines = std::array<PathMark, 2>;

Lines LinesOf(double width, const TypeStyle& style, Color color) {
  Lines lines;
  for (const LineKind kind : {LineKind::kPlain, LineKind::kHeading}) {
    PathMark& mark = lines[kind == LineKind::kHeading];
    mark.stroke = ColorOf(kind, style, color);
    mark.width = kMillimetres * width * ScaleOf(kind, style);
  }
  return lines;
}

void AppendDrawn(std::vector<Mark>& marks, PathMark mark) {
  if (!mark.subpaths.empty()) marks.emplace_back(std::move(mark));
}

}  // namespace

std::vector<Mark> MoonMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                            glm::dvec2 from_P, Color color) {
  Lines lines = LinesOf(style.width, style, color);
  std::array<PathMark, 2> fills;
  fills[0].fill = ColorOf(LineKind::kPlain, style, color);
  fills[1].fill = ColorOf(LineKind::kHeading, style, color);
  for (const PlacedGlyph& placed : page.glyphs) {
    const bool heading = placed.kind == LineKind::kHeading;
    for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
      PathMark& mark = stroke.kind == StrokeKind::kStroke ? lines[heading] : fills[heading];
      mark.subpaths.push_back(InDrawing(stroke, placed, style, from_P));
    }
  }
  std::vector<Mark> marks;
  for (PathMark& mark : lines) AppendDrawn(marks, std::move(mark));
  for (PathMark& mark : fills) AppendDrawn(marks, std::move(mark));
  return marks;
}

std::vector<Mark> CentreLineMarks(const TextPage& page, const Script& script,
                                  const TypeStyle& style, glm::dvec2 from_P, Color color) {
  Lines lines = LinesOf(style.width / 8, style, color);
  for (const PlacedGlyph& placed : page.glyphs) {
    PathMark& own = lines[placed.kind == LineKind::kHeading];
    own.dashed = true;
    for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
      own.subpaths.push_back(InDrawing(stroke, placed, style, from_P));
    }
  }
  std::vector<Mark> marks;
  for (PathMark& mark : lines) AppendDrawn(marks, std::move(mark));
  return marks;
}

Box InkBounds(const TextPage& page, const Script& script, const TypeStyle& style) {
  Box bounds;
  for (const PlacedGlyph& placed : page.glyphs) {
    const double scale = ScaleOf(placed.kind, style);
    for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
      for (const Piece& piece : stroke.pieces) {
        const Box box = BoundsOf(Placed(piece, scale * style.size, placed.origin_P));
        Include(bounds, Grown(box, scale * style.width / 2));
      }
    }
  }
  if (bounds.min.x > bounds.max.x) Include(bounds, Grown({{0, 0}, {0, 0}}, style.width / 2));
  return bounds;
}

}  // namespace moontrace
