#pragma once

#include <vector>

#include "lessons/measure/intended_strokes.h"

namespace moontrace {

/// A place in a letter's box, by thirds: -1 left or bottom, 0 middle, 1 right or top.
struct ThirdPlace {
  int x = 0, y = 0;
  bool operator==(const ThirdPlace&) const = default;
};

/// One piece of a stroke's path, roughly.
struct PathPiece {
  bool arc = false;
  int eighth = 0;          ///< direction from its start to its end: 0 right, 2 up, 4 left, 6 down
  bool clockwise = false;  ///< of an arc
  bool round = false;      ///< of an arc: a whole turn
  bool operator==(const PathPiece&) const = default;
};

/// How a stroke runs, for words where nothing can lead the hand.
struct StrokePath {
  bool dot = false;
  ThirdPlace from, to;
  std::vector<PathPiece> pieces;
};

/// Paths of a page's strokes, in writing order; places are within the box of all of them. Pieces
/// that go on in the same manner are one.
std::vector<StrokePath> PathsOf(const std::vector<IntendedStroke>& strokes);

}  // namespace moontrace
