#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "lessons/measure/spine.h"
#include "lessons/measure/trace_metrics.h"
#include "textures/field/fill.h"

namespace moontrace {

/// The path of a tip in bounded memory: points at least a spacing apart; when there are kMost,
/// every second one goes and the spacing doubles.
class TipPath {
 public:
  /// More than along any stroke of Moon, w/8 apart: its shape is compared as it was traced.
  static constexpr std::size_t kMost = 512;

  /// `spacing` [m].
  explicit TipPath(double spacing) : spacing_(spacing) {}
  void Add(glm::dvec2 p);
  /// With the newest one at the end [m].
  std::vector<glm::dvec2> Points() const;

 private:
  double spacing_ = 0;
  std::vector<glm::dvec2> points_;
  glm::dvec2 newest_{0, 0};
};

/// One intended stroke and how it has been traced so far, for scoring.
struct StrokeTrace {
  explicit StrokeTrace(const IntendedStroke& stroke);

  /// Takes what a tip at `p` covers; gives its error [m]. On a line that is the distance to the
  /// centre line, of which all within w/4 is covered. The centre arc of a fill cannot be felt, only
  /// its rim: there the error is what lacks of w/2 from the rim, if that is less, and a tip
  /// covers what lies beside it on the arc once its error is w/4 or less. So in both a tip in the
  /// middle half of a groove covers, and an error above w/2 lies outside.
  double Cover(glm::dvec2 p);

  /// The sums, with coverage and a dot's closest approach added.
  TraceTally Closed() const;
  /// Adds the shape distances, at the cost of some ten thousand steps; nothing for dots and for
  /// strokes that were not followed.
  void AddShape(TraceTally& closed) const;
  /// Followed for a width, or for half its length where that is less; a dot: covered.
  bool visited() const;

  std::vector<Piece> pieces_P;
  std::vector<Piece> outline_P;   ///< of a fill
  std::vector<RisingEdge> edges;  ///< of the outline
  Spine spine;
  CoveredLength covered;
  double width = 0;  ///< [m]
  std::size_t glyph = 0;
  bool is_dot = false;
  bool landed = false;  ///< since the hand last came down on it
  bool out = false;     ///< beyond w/2 and not yet back within w/4
  double closest = std::numeric_limits<double>::infinity();  ///< of a dot [m]
  glm::dvec2 mark{0, 0};  ///< the path along or against it is counted up to here [m]
  std::size_t visit = 0;  ///< its place in the order of visits, from 1; 0: not
  TipPath path;           ///< of the tip while following it
  TraceTally tally;

 private:
  /// How far within the outline of a fill; below zero outside [m].
  double Inside(glm::dvec2 p) const;
};

}  // namespace moontrace
