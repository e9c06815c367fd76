#pragma once

#include <glm/vec3.hpp>

namespace moontrace {

/// The tip's velocity from readings that come as the device likes. A device that reads slower than
/// the loop ticks stands still between its readings: differences from tick to tick would be
/// zero, then many times too great, and a damper would beat on the hand with them. Here the
/// distance between two readings is spread over the time between them, and the velocity stands
/// until the next one; where none comes it fades, as the tip can have moved less than that since.
class TipVelocity {
 public:
  /// A tick of `elapsed` [s]; `fresh`: the device gave a new position `p` [m].
  void Advance(double elapsed, bool fresh, glm::dvec3 p) noexcept {
    since_ += elapsed;
    if (fresh) {
      step_ = begun_ ? p - p_ : glm::dvec3(0, 0, 0);
      step_time_ = since_;
      p_ = p;
      since_ = 0;
      begun_ = true;
    }
    const double time = since_ > step_time_ ? since_ : step_time_;
    v_ = time > 0 ? step_ / time : glm::dvec3(0, 0, 0);
  }
  /// The next reading is of another place, not of a movement there.
  void Restart() noexcept { *this = TipVelocity(); }

  glm::dvec3 v() const noexcept { return v_; }  ///< [m/s]

 private:
  glm::dvec3 p_{0, 0, 0};     ///< newest [m]
  glm::dvec3 step_{0, 0, 0};  ///< between the last two readings [m]
  glm::dvec3 v_{0, 0, 0};
  double step_time_ = 0;  ///< of `step_` [s]
  double since_ = 0;      ///< the newest reading [s]
  bool begun_ = false;
};

}  // namespace moontrace
