#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim/reader/line_belief.h"

namespace moontrace {

/// What a line's frame can be: how large its letters are, how they lie and where.
struct FrameRange {
  glm::dvec2 met{0, 0};           ///< a place on the line [m]
  double from = 0, to = 0;        ///< which lies so high above its base line [em]
  std::vector<double> sizes;      ///< [m]; where there are several, the answer may lie between them
  std::vector<double> turns;      ///< [rad]; the same
  glm::dvec2 felt_to{0, 0};       ///< left of it all of the line was felt [m]
  double unsure = 0;              ///< rms error of places [m]
  double before = 0, behind = 0;  ///< its first sign begins so far left or right of its ink [em]
  /// Between letters of a size; null: they stand apart.
  std::function<std::shared_ptr<const LinkShapes>(double)> links;
};

struct FrameFit {
  SignPlace frame;            ///< its origin at the line's first ink, on the base line
  double log_likelihood = 0;  ///< of what was felt on the line, against flat paper
};

/// The frame that explains best what was felt: all of the range coarsely by the first half of what
/// was felt, the likeliest of those by all of it, then finely about the best. Takes some thousand
/// likelihoods, seconds of a core for a page whose size is not known.
FrameFit FitFrame(const LineBelief& belief, const std::vector<HatchPoint>& points,
                  const FrameRange& range);

/// The frame near by another that explains best what was felt, of which there may be more by now.
/// Of `range` neither sizes nor turns nor heights matter.
FrameFit RefineFrame(const LineBelief& belief, const std::vector<HatchPoint>& points,
                     const FrameRange& range, const SignPlace& about);

}  // namespace moontrace
