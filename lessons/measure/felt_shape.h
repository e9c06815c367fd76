#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace moontrace {

/// What a hand feels at one moment: where it believes its tip to be and the force on it, in any
/// frame whose z points out of the paper. No page, no stroke, no size.
struct FeltSample {
  glm::dvec3 tip{0, 0, 0};    ///< [m]
  glm::dvec3 force{0, 0, 0};  ///< [N]
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
  double least_depth = 1e-4;  ///< a smaller depth is not felt [m]
  /// How far flat paper gives way to a newton, which every hand knows that has pressed on it: a tip
  /// that swings up and down is not in a groove for that [m/N].
  double softness = 0;
  double depth_share = 0.4;    ///< of the deepest, counts fully as a groove; half begins to
  double slope = 0.5;          ///< sideways over outward force that counts fully; likewise
  double least_force = 0.02;   ///< less is not felt [N]
  double gap = 0.25;           ///< between signs, share of the height explored
  double least_part = 0.015;   ///< share of the largest sign; a smaller part is no sign
  double blur_cells = 1.6;     ///< of a sign's picture
  double least_spread = 0.12;  ///< for the scale of dots, share of the height explored
};

/// What was felt, sign by sign from the left; empty where nothing gave way: blank paper.
using FeltShape = std::vector<FeltSign>;
FeltShape ShapeOf(const std::vector<FeltSample>& samples, const FeelingRule& rule);

}  // namespace moontrace
