#include "sim/learn/learn_way.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

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

WayPiece PieceOf(const Piece& piece) {
  WayPiece way;
  const glm::dvec2 chord = EndOf(piece) - StartOf(piece);
  const double turns = std::atan2(chord.y, chord.x) / (2 * std::numbers::pi);
  way.eighth = static_cast<int>(std::lround(8 * turns) + 8) % 8;
  if (const Arc* arc = std::get_if<Arc>(&piece)) {
    way.arc = true;
    way.clockwise = arc->sweep < 0;
    way.round = glm::length(chord) < 0.2 * arc->radius;
    if (way.round) way.eighth = 0;
  }
  return way;
}

}  // namespace

std::vector<StrokeWay> WaysOf(const std::vector<IntendedStroke>& strokes) {
  Box box;
  for (const IntendedStroke& stroke : strokes) {
    for (const Piece& piece : stroke.spine_P) Include(box, BoundsOf(piece));
  }
  std::vector<StrokeWay> ways;
  for (const IntendedStroke& stroke : strokes) {
    if (stroke.spine_P.empty()) continue;
    StrokeWay way;
    way.dot = stroke.kind == StrokeKind::kDot;
    way.from = PlaceIn(box, StartOf(stroke.spine_P.front()));
    way.to = PlaceIn(box, EndOf(stroke.spine_P.back()));
    for (const Piece& piece : stroke.spine_P) {
      const WayPiece one = PieceOf(piece);
      if (!way.dot && (way.pieces.empty() || !(way.pieces.back() == one))) {
        way.pieces.push_back(one);
      }
    }
    ways.push_back(std::move(way));
  }
  return ways;
}

}  // namespace moontrace
