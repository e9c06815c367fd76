#pragma once

#include <glm/vec3.hpp>

#include "devices/core/device.h"

namespace moontrace {

/// A smaller force is hardly felt: silence and sticking count only under more [N].
inline constexpr double kFeltForce = 0.2;

/// Finds a device whose position has stuck: reports keep coming, all of the very same place.
///
/// A hand that rests on a device of coarse steps looks the same, so stillness alone is no fault.
/// What distinguishes them is the response to a change of force. A tip at rest under a force F is
/// held by a hand that presses with F less the friction f_c at least; without F it would have to
/// move, as soon as f_c no longer holds the hand by itself. So:
///
/// - Only a force above kFeltForce and 2 f_c is judged: then the hand presses with more than f_c.
/// - After `DeviceLimits::still` of reports of one place the force is taken back evenly over
///   kYieldTime. The first report of another place brings it back over kReturnTime: a hand feels
///   the page give way by a step of the device, at what friction does not hold.
/// - If all of it is gone and the tip still reports that place, it is stuck until it moves.
///
/// A tip at the edge of the workspace may lie against a stop, which answers no force: not judged.
class StillTip {
 public:
  static constexpr double kYieldTime = 1;     ///< [s]
  static constexpr double kReturnTime = 0.1;  ///< [s]

  explicit StillTip(const DeviceLimits& limits) noexcept;

  /// A tick of `elapsed` [s] in which a report of `p_D` came (`fresh`) or none did. `force` [N] is
  /// the size of what is wanted on the axes that push.
  void Advance(double elapsed, bool fresh, glm::dvec3 p_D, double force) noexcept;
  /// No force is given, for another reason: the tip is not judged.
  void Pause() noexcept;
  /// Another device, or the same elsewhere.
  void Restart() noexcept { *this = StillTip(limits_); }

  double share() const noexcept { return share_; }  ///< of the force that may be given now
  bool stuck() const noexcept { return stuck_; }

 private:
  bool IsAtEdge() const noexcept;

  DeviceLimits limits_;
  double least_force_ = 0;  ///< that is judged [N]
  bool begun_ = false;
  glm::dvec3 p_D_{0, 0, 0};  ///< last reported [m]
  double waited_ = 0;        ///< since the last report [s]
  double still_ = 0;         ///< for how long reports have given `p_D_` under a judged force [s]
  double share_ = 1;
  bool stuck_ = false;
};

}  // namespace moontrace
