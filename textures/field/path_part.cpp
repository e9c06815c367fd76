#include "textures/field/path_part.h"

#include <glm/geometric.hpp>

#include "textures/base/overload.h"

namespace moontrace {

PathPart PartOf(const Piece& piece, double offset) {
  PathPart part;
  part.offset = offset;
  part.length = Length(piece);
  const auto set_line = [&part](const Line& line) {
    part.anchor = line.from;
    part.direction = TangentAt(line, 0);
  };
  const auto set_arc = [&part](const Arc& arc) {
    part.is_arc = true;
    part.anchor = arc.center;
    part.radius = arc.radius;
    part.start = arc.start;
    part.sweep = std::abs(SweepOf(arc));
    part.sense = arc.sweep < 0 ? -1 : 1;
  };
  std::visit(Overload{set_line, set_arc}, piece);
  return part;
}

}  // namespace moontrace
