#include "devices/core/tick_motion.h"

#include <cmath>

namespace moontrace {
namespace {

/// Without a spring: velocity decays, position keeps what it has travelled.
TickMotion SpringlessMotion(double mass, double damping, double tick) {
  TickMotion motion;
  const double rate = damping / mass;
  motion.vv = std::exp(-rate * tick);
  motion.xv = damping > 0 ? -std::expm1(-rate * tick) / rate : tick;
  motion.vf = motion.xv / mass;
  motion.xf = damping > 0 ? (tick - motion.xv) / damping : tick * tick / (2 * mass);
  return motion;
}

}  // namespace

TickMotion MotionOver(double mass, double stiffness, double damping, double tick) {
  if (stiffness <= 0) return SpringlessMotion(mass, damping, tick);
  const double decay = damping / (2 * mass);
  const double square = stiffness / mass - decay * decay;  // of the damped angular frequency
  const double omega = std::sqrt(std::abs(square));
  double even = 1;    // cos, cosh or their common limit
  double odd = tick;  // sin / omega, sinh / omega or their common limit
  if (omega * tick > 1e-8) {
    even = square > 0 ? std::cos(omega * tick) : std::cosh(omega * tick);
    odd = (square > 0 ? std::sin(omega * tick) : std::sinh(omega * tick)) / omega;
  }
  const double fade = std::exp(-decay * tick);
  TickMotion motion;
  motion.xx = fade * (even + decay * odd);
  motion.xv = fade * odd;
  motion.vx = -stiffness / mass * motion.xv;
  motion.vv = fade * (even - decay * odd);
  motion.xf = (1 - motion.xx) / stiffness;
  motion.vf = motion.xv / mass;
  return motion;
}

}  // namespace moontrace
