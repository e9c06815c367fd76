#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "textures/field/piece.h"

namespace moontrace {

/// A line or an arc of a path, made ready for one question a tick: what needs a root or a case
/// distinction is worked out once.
struct PathPart {
  bool is_arc = false;
  double offset = 0;           ///< arc length of the path at its start [m]
  double length = 0;           ///< [m]
  glm::dvec2 anchor{0, 0};     ///< a line's start, an arc's centre [m]
  glm::dvec2 direction{1, 0};  ///< of a line, unit; of one without length along x
  double radius = 0;           ///< of an arc [m]
  double start = 0;            ///< of an arc [rad]
  double sweep = 0;            ///< of an arc, in its own sense: 0 to a turn [rad]
  double sense = 1;            ///< of an arc: 1 counter-clockwise, -1 clockwise
};

/// `offset`: arc length of the path at the piece's start [m].
PathPart PartOf(const Piece& piece, double offset);

/// How far `p` is turned from an arc's start in the arc's own sense: 0 to a turn [rad].
inline double AngleTo(const PathPart& arc, glm::dvec2 p) noexcept {
  return AngleFrom(arc.start, arc.sense, p - arc.anchor);
}

/// Point of an arc at an angle from its start in its own sense [rad].
inline glm::dvec2 PointAtAngle(const PathPart& arc, double angle) noexcept {
  return arc.anchor + arc.radius * DirectionOf(arc.start + arc.sense * angle);
}

/// Unit direction of travel at an angle from an arc's start in its own sense [rad].
inline glm::dvec2 TangentAtAngle(const PathPart& arc, double angle) noexcept {
  const glm::dvec2 outward = DirectionOf(arc.start + arc.sense * angle);
  return arc.sense * glm::dvec2(-outward.y, outward.x);
}

/// Point at an arc length from the part's start [m]; not held to the part.
inline glm::dvec2 PointAt(const PathPart& part, double along) noexcept {
  return part.is_arc ? PointAtAngle(part, along / part.radius)
                     : part.anchor + along * part.direction;
}

/// Unit direction of travel there.
inline glm::dvec2 TangentAt(const PathPart& part, double along) noexcept {
  return part.is_arc ? TangentAtAngle(part, along / part.radius) : part.direction;
}

}  // namespace moontrace
