#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "textures/field/path_part.h"

namespace moontrace {

/// The union of intervals of a line's arc length: which parts of it have been covered. Exact;
/// keeps disjoint intervals only, so that covering the same part again costs nothing.
class CoveredLength {
 public:
  /// Allocates nothing until more than `capacity` disjoint intervals are held.
  explicit CoveredLength(std::size_t capacity) { intervals_.reserve(capacity); }

  /// Adds [begin, end] [m]; nothing when end < begin.
  void Add(double begin, double end);

  /// Length of the union [m].
  double Total() const noexcept;

 private:
  struct Interval {
    double begin = 0, end = 0;
  };
  std::vector<Interval> intervals_;  ///< ascending, none touching the next
};

/// The centre line of an intended stroke, made ready for one question a sample.
class Spine {
 public:
  explicit Spine(const std::vector<Piece>& pieces);

  double length() const noexcept { return length_; }    ///< [m]
  glm::dvec2 start() const noexcept { return start_; }  ///< [m]

  /// The nearest point of the spine: its direction there, and where `p` lies from it.
  struct Foot {
    glm::dvec2 point{0, 0};    ///< [m]
    glm::dvec2 tangent{1, 0};  ///< unit, in the sense of writing
    double aside = 0;          ///< of `p` from it along the normal, > 0 to the left [m]
  };
  Foot FootOf(glm::dvec2 p) const noexcept;

  /// Distance of `p` to the nearest point of the spine [m]; adds to `covered` the arc length that
  /// lies within `radius` of `p`. Exact for lines and arcs. Infinite for a spine without pieces.
  double Cover(glm::dvec2 p, double radius, CoveredLength& covered) const;

 private:
  struct Part {
    PathPart path;
    glm::dvec2 from{0, 0}, to{0, 0};  ///< ends
  };
  static glm::dvec2 NearestOn(const Part& part, glm::dvec2 p, glm::dvec2& tangent) noexcept;
  static double CoverLine(const PathPart& part, glm::dvec2 p, double radius,
                          CoveredLength& covered);
  /// Exact only where it is below `nearest`; otherwise some value not below it.
  static double CoverArc(const Part& part, glm::dvec2 p, double radius, double nearest,
                         CoveredLength& covered);

  std::vector<Part> parts_;
  double length_ = 0;
  glm::dvec2 start_{0, 0};
};

}  // namespace moontrace
