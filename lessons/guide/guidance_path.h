#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "textures/field/path_part.h"

namespace moontrace {

/// One stroke of a path; without gaps.
struct GuidanceStroke {
  std::vector<PathPart> parts;  ///< at least one; a dot's has no length
  double length = 0;            ///< [m]
  double width = 0;             ///< of the groove [m]
  Box letter;                   ///< of all strokes of its letter, one width larger
};

/// Where a push leads: the centre lines of strokes in writing order, cut into lines and arcs with
/// arc lengths, made ready so that a tick searches only near the last arc length. Frame P.
struct GuidancePath {
  std::vector<GuidanceStroke> strokes;  ///< in writing order
  /// Of a recorded path: where its bead is when. Times ascend from 0 [s]; otherwise empty.
  std::vector<double> times;
  std::vector<glm::dvec2> points;

  bool recorded() const noexcept { return !times.empty(); }
};

/// Strokes as the path of a push; the bead moves at the gains' even speed.
std::shared_ptr<const GuidancePath> MakeGuidancePath(const std::vector<IntendedStroke>& strokes);
/// The recorded path of a hand, one tip a time [s, ascending]: the bead is led along it at its own
/// times; the tutor's stroke. `width` [m] of the groove gives dead zone and leash. What is not
/// finite or does not ascend is left out.
std::shared_ptr<const GuidancePath> MakeRecordedPath(const std::vector<double>& times,
                                                     const std::vector<glm::dvec3>& tips_P,
                                                     double width);

/// The stroke's point at arc length `s`, held to the stroke.
glm::dvec2 PointAt(const GuidanceStroke& stroke, double s) noexcept;
/// Unit direction of travel there.
glm::dvec2 TangentAt(const GuidanceStroke& stroke, double s) noexcept;

/// The nearest point of the stroke between two arc lengths (held to the stroke, from <= to): exact
/// for lines and arcs. Of several the one that is nearest along the stroke to `s`, as far as it is
/// among those that stand out by 1e-12 m.
struct NearestPlace {
  double s = 0;         ///< arc length [m]
  double distance = 0;  ///< [m]
};
NearestPlace NearestWithin(const GuidanceStroke& stroke, glm::dvec2 p, double s, double from,
                           double to) noexcept;

/// Where the bead of a recorded path is at `time` from its beginning [s], held to its ends.
glm::dvec2 RecordedPointAt(const GuidancePath& path, double time) noexcept;

}  // namespace moontrace
