#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace moontrace {

/// What a hand feels at one moment: where it believes its tip to be, in any frame, and how deep the
/// paper gives way there. No page, no stroke, no size.
struct FeltSample {
  glm::dvec2 place{0, 0};  ///< [m]
  double depth = 0;        ///< share of a groove's
};

/// One thing felt, apart from others by a gap: a picture of where the paper gave way, centred and
/// scaled by its own spread, so that it does not depend on place and size.
struct FeltSign {
  static constexpr std::size_t kCells = 21;      ///< a side
  std::array<float, kCells * kCells> picture{};  ///< of length 1; row by row, from below
  /// Where it lay and how large it was, as shares of the height that the hand explored: this
  /// distinguishes a comma from an apostrophe.
  double height = 0.5, spread = 0;
  double width = 0;  ///< its greatest extent along the line, share of that height
};

/// Parameters by which touch becomes a shape, from `lessons/learner.toml` (our own values).
struct FeelingRule {
  double depth = 0.3;          ///< share of a groove's, counts fully as one; half begins to
  double gap = 0.25;           ///< between signs, share of the height explored
  double least_part = 0.015;   ///< share of the largest sign; a smaller part is no sign
  double blur_cells = 1.6;     ///< of a sign's picture
  double least_spread = 0.12;  ///< for the scale of dots, share of the height explored
};

/// What was felt, sign by sign from the left; empty where nothing gave way: blank paper.
using FeltShape = std::vector<FeltSign>;

/// What a hand felt that explored a line, between the heights that it meant to keep to; what lies
/// beyond them does not count.
struct FeltLine {
  double bottom = 0, top = 0;  ///< in the samples' frame [m]
  std::vector<FeltSample> samples;
};
FeltShape ShapeOf(const FeltLine& line, const FeelingRule& rule);

}  // namespace moontrace
