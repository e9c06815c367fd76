#include "devices/core/tip_estimate.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace moontrace {

static_assert(std::is_trivially_copyable_v<TipEstimate>);

namespace {

/// Share of what lies beyond the band that the velocity takes. Ours: with all of it a reading that
/// comes every 8 ms kicks, with a third a sudden stop is followed for 10 ms.
constexpr double kBeyond = 0.5;

}  // namespace

// Kalata 1984: with the tracking index l = q T^2 / s (q of acceleration, s of the readings, both
// rms) the steady gains are alpha = 1 - r^2, beta = 2 (1 - r)^2, r = (4 + l - sqrt(8 l + l^2)) / 4.
TrackingGains TrackingGainsFor(double step, double period) noexcept {
  if (!(step > 0)) return {};
  const double index = kHandAcceleration * period * period * std::sqrt(12.0) / step;
  const double r = std::max(0.0, (4 + index - std::sqrt(8 * index + index * index)) / 4);
  return {1 - r * r, std::min(1.0, 2 * (1 - r) * (1 - r))};
}

/// A reading in steps, `travel_time_` after the one before.
void TipEstimate::Track(int axis, double reading) noexcept {
  const double step = step_[axis];
  const TrackingGains gains = TrackingGainsFor(step, travel_time_);
  const double predicted = p_[axis] + travel_[axis];
  const double beside = reading - predicted;
  const double beyond = beside - std::clamp(beside, -kBand * step, kBand * step);
  p_[axis] = std::clamp(predicted + gains.position * beside, reading - kBand * step,
                        reading + kBand * step);
  travel_[axis] += gains.velocity * beside + kBeyond * beyond;
}

void TipEstimate::Restart() noexcept {
  const glm::dvec3 p = p_;
  *this = TipEstimate(step_);
  p_ = p;
}

void TipEstimate::Advance(double elapsed, bool fresh, glm::dvec3 p) noexcept {
  since_ += elapsed;
  if (fresh) {
    // the velocity of before over the time that has passed
    if (travel_time_ > 0) travel_ *= since_ / travel_time_;
    travel_time_ = since_;
    for (int axis = 0; axis < 3; ++axis) {
      if (begun_ && step_[axis] > 0) {
        Track(axis, p[axis]);
      } else {
        travel_[axis] = begun_ ? p[axis] - p_[axis] : 0;
        p_[axis] = p[axis];
      }
    }
    since_ = 0;
    begun_ = true;
  }
  const double time = std::max(since_, travel_time_);
  v_ = time > 0 ? travel_ / time : glm::dvec3(0, 0, 0);
}

}  // namespace moontrace
