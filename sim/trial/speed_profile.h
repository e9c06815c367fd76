#pragma once

#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// How an aim goes along a run of pieces without corners, from rest to rest: the arc length [m]
/// reached every `step` [s], the first 0, the last the run's length. As fast as these allow: at
/// most `speed` [m/s]; at most 0.3 m/s^2 along the run and towards a curve's centre; then averaged
/// over 60 ms, which rounds the changes of acceleration so that a hand does not ring.
std::vector<double> TimeRun(const std::vector<Piece>& run, double speed, double step);

}  // namespace moontrace
