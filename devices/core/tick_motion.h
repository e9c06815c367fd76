#pragma once

namespace moontrace {

/// Motion of one axis over one tick, exact for a force that is held over it:
/// x1 = xx x + xv v + xf f, v1 = vx x + vv v + vf f.
struct TickMotion {
  double xx = 1, xv = 0, xf = 0;
  double vx = 0, vv = 1, vf = 0;
};

/// Solves m x'' = -k x - b x' + f over `tick` [s] in closed form, for any damping. Needs mass > 0
/// [kg], stiffness >= 0 [N/m], damping >= 0 [N s/m].
TickMotion MotionOver(double mass, double stiffness, double damping, double tick);

/// Moves one axis over the tick under the force `f` [N].
inline void Move(const TickMotion& motion, double& x, double& v, double f) noexcept {
  const double x0 = x;
  x = motion.xx * x0 + motion.xv * v + motion.xf * f;
  v = motion.vx * x0 + motion.vv * v + motion.vf * f;
}

}  // namespace moontrace
