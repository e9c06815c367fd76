#pragma once

#include <glm/vec3.hpp>

#include "devices/core/device.h"

namespace moontrace {

/// Gains of a tracker of position and velocity: shares of what a reading lies beside its prediction
/// that the position takes, and, over the time between readings, the velocity.
struct TrackingGains {
  double position = 1;  ///< alpha
  double velocity = 1;  ///< beta
};

/// Gains for readings rounded to `step` [m], every `period` [s]: of the steady Kalman filter for a
/// step's even spread (rms step / sqrt 12) and a hand of kHandAcceleration (Kalata 1984, tracking
/// index), the velocity's at most 1, which is the plain difference that exact readings (0) get.
TrackingGains TrackingGainsFor(double step, double period) noexcept;

/// Unrest of a hand's velocity that the gains reckon with, rms [m/s^2]. Ours, by measurement: of
/// 0.1 to 1.5, the lower ones lag more and the higher ones are grittier (`bench --stability`).
inline constexpr double kHandAcceleration = 0.85;

/// Where the tip is and how fast, from readings that come as the device likes, in steps: what the
/// coupling is given, in simulation and in the real loop alike.
///
/// Exact readings (step 0) are taken as they are, and the velocity is the distance between two of
/// them over the time between them. A device that reads slower than the loop ticks stands still
/// between its readings: differences from tick to tick would be zero, then many times too great,
/// and a damper would beat on the hand with them. So the velocity stands until the next reading;
/// where none comes it fades, as the tip can have moved less than that since.
///
/// Readings in steps would beat on it as well: a step of 55 um in 1 ms is 55 mm/s. There a tracker
/// goes on evenly and lets each reading draw it by TrackingGainsFor. It lags behind a hand that
/// speeds up by a [m/s^2] by a / w^2 in place and 1.4 a / w in velocity, w = (kHandAcceleration
/// sqrt(12) / step)^(1/2), and by nothing behind one that moves evenly. A hand that leaves it by
/// more than kBand steps is no longer what the gains reckon with: the place follows it at that
/// distance, and the velocity takes half of what is beyond at each reading.
///
/// Trivially copyable; nothing here allocates.
class TipEstimate {
 public:
  TipEstimate() = default;
  /// `step` of the readings on each axis [m]; 0 where they are exact, or it is unknown.
  explicit TipEstimate(glm::dvec3 step) noexcept : step_(step) {}
  /// For a device's readings: on the axes that it measures, its step.
  explicit TipEstimate(const DeviceLimits& limits) noexcept
      : step_(glm::dvec3(limits.measures) * limits.position_step) {}

  /// A tick of `elapsed` [s]; `fresh`: the device gave a new position `p` [m].
  void Advance(double elapsed, bool fresh, glm::dvec3 p) noexcept;
  /// The next reading is of another place, not of a movement there; until it comes the tip rests.
  void Restart() noexcept;

  glm::dvec3 p() const noexcept { return p_; }  ///< [m]
  glm::dvec3 v() const noexcept { return v_; }  ///< [m/s]

  /// Furthest that the place is from the newest reading, in steps.
  static constexpr double kBand = 3;

 private:
  void Track(int axis, double reading) noexcept;

  glm::dvec3 step_{0, 0, 0};    ///< [m]
  glm::dvec3 p_{0, 0, 0};       ///< [m]
  glm::dvec3 v_{0, 0, 0};       ///< as given out [m/s]
  glm::dvec3 travel_{0, 0, 0};  ///< over `travel_time_` at the velocity of the newest reading [m]
  double travel_time_ = 0;      ///< between the last two readings [s]
  double since_ = 0;            ///< the newest reading [s]
  bool begun_ = false;
};

}  // namespace moontrace
