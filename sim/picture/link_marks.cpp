#include "sim/picture/link_marks.h"

#include <array>
#include <utility>

#include "textures/base/units.h"

namespace moontrace {

std::vector<Mark> LinkMarks(const GrooveLinks& links, const Script& script, const TypeStyle& style,
                            glm::dvec2 from_P, Color color) {
  std::array<PathMark, 2> marks;  // of the text, of headings
  for (const LineKind kind : {LineKind::kPlain, LineKind::kHeading}) {
    PathMark& mark = marks[kind == LineKind::kHeading];
    mark.stroke = color;
    mark.width = kMillimetres * LineStyle(kind, style, script).width / 2;
  }
  for (const GrooveLink& link : links.links) {
    std::vector<Piece> pieces;
    for (const Piece& piece : SpineOf(links, link)) {
      pieces.push_back(Placed(piece, kMillimetres, -kMillimetres * from_P));
    }
    marks[links.shapes[link.shape].kind == LineKind::kHeading].subpaths.push_back(
        std::move(pieces));
  }
  std::vector<Mark> drawn;
  for (PathMark& mark : marks) {
    if (!mark.subpaths.empty()) drawn.emplace_back(std::move(mark));
  }
  return drawn;
}

}  // namespace moontrace
