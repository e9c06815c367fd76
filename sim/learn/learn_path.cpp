#include "sim/learn/learn_path.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "textures/base/overload.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

int Third(double at, double low, double high) {
  const double third = (high - low) / 3;
  if (third <= 1e-6) return 0;  // a line has no sides
  if (at < low + third) return -1;
  return at > high - third ? 1 : 0;
}

ThirdPlace PlaceIn(const Box& box, glm::dvec2 p) {
  return {Third(p.x, box.min.x, box.max.x), Third(p.y, box.min.y, box.max.y)};
}

PathPiece PieceOf(const Piece& piece) {
  PathPiece path;
  const glm::dvec2 chord = EndOf(piece) - StartOf(piece);
  const double turns = std::atan2(chord.y, chord.x) / kTurn;
  path.eighth = static_cast<int>(std::lround(8 * turns) + 8) % 8;
  const auto set_arc = [&path, chord](const Arc& arc) {
    path.arc = true;
    path.clockwise = arc.sweep < 0;
    path.round = glm::length(chord) < 0.2 * arc.radius;
    if (path.round) path.eighth = 0;
  };
  std::visit(Overload{[](const Line&) {}, set_arc}, piece);
  return path;
}

}  // namespace

std::vector<StrokePath> PathsOf(const std::vector<IntendedStroke>& strokes) {
  Box box;
  for (const IntendedStroke& stroke : strokes) {
    for (const Piece& piece : stroke.spine_P) Include(box, BoundsOf(piece));
  }
  std::vector<StrokePath> paths;
  for (const IntendedStroke& stroke : strokes) {
    if (stroke.spine_P.empty()) continue;
    StrokePath path;
    path.dot = stroke.kind == StrokeKind::kDot;
    path.from = PlaceIn(box, StartOf(stroke.spine_P.front()));
    path.to = PlaceIn(box, EndOf(stroke.spine_P.back()));
    for (const Piece& piece : stroke.spine_P) {
      const PathPiece one = PieceOf(piece);
      if (!path.dot && (path.pieces.empty() || !(path.pieces.back() == one))) {
        path.pieces.push_back(one);
      }
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace moontrace
