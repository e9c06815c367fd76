#include "devices/core/coupling_margin.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "devices/core/tick_motion.h"
#include "devices/core/tip_estimate.h"

namespace moontrace {

// Over one period T the hand moves as x' = A x + g f with x = (place, velocity) and f the force
// that acts. A force is computed from the reading at a period's beginning and acts a delay later:
// after n whole periods, and in the next, for what is left of the delay, the force before it acts
// still. So, with z the shift by a period and g_a, g_b the response at its end to a force over its
// first and its last part,
//
//   P(z) = c (z - A)^-1 (g_a / z + g_b) z^-n,  c = (1, 0)
//
// is the place, for a force computed from it. The tracker gives place and velocity by
// s_k = (1 - k c) E s_(k-1) + k y_k with E even motion over T and k = (alpha, beta / T): X(z), V(z)
// of the reading y. With the force -m (K X + B V) y a swing of z = exp(i w T) lasts where
//
//   1 + m L(z) = 0,  L = P (K X + B V),
//
// so the margin is the least m > 0 over all w where L is real and below zero. (At m near zero the
// hand's own damping lets nothing swing.)
namespace {

using Complex = std::complex<double>;

class CouplingLoop {
 public:
  CouplingLoop(const DeviceProfile& profile, const CouplingGains& coupling, double mass)
      : coupling_(coupling),
        period_(1 / profile.rate),
        gains_(TrackingGainsFor(profile.position_step, period_)),
        whole_(std::floor(profile.delay / period_ + 1e-9)) {
    const double damping = profile.limits.damping;
    const double rest = std::max(0.0, profile.delay - whole_ * period_);
    motion_ = MotionOver(mass, 0, damping, period_);
    const TickMotion first = MotionOver(mass, 0, damping, rest);
    const TickMotion last = MotionOver(mass, 0, damping, period_ - rest);
    before_ = {first.xf + last.xv * first.vf, last.vv * first.vf};
    now_ = {last.xf, last.vf};
  }

  /// L for a swing of `turn` [rad] a period.
  Complex At(double turn) const {
    const Complex z = std::polar(1.0, turn);
    const Response tracked = Tracked(z);
    return Place(z) * (coupling_.stiffness * tracked.x + coupling_.damping * tracked.v);
  }

 private:
  struct Response {
    Complex x, v;
  };
  struct Kick {
    double x = 0, v = 0;
  };

  Complex Place(Complex z) const {
    const Complex late = std::pow(z, -whole_);
    const Complex x = late * (before_.x / z + now_.x), v = late * (before_.v / z + now_.v);
    return (x + motion_.xv * v / (z - motion_.vv)) / (z - 1.0);
  }

  Response Tracked(Complex z) const {
    if (gains_.position == 1) return {1, (1.0 - 1.0 / z) / period_};
    const double a = gains_.position, b = gains_.velocity / period_;
    // 1 - (1 - k c) E / z, row by row
    const Complex xx = 1.0 - (1 - a) / z, xv = -(1 - a) * period_ / z;
    const Complex vx = b / z, vv = 1.0 - (1 - b * period_) / z;
    const Complex det = xx * vv - xv * vx;
    return {(a * vv - xv * b) / det, (xx * b - vx * a) / det};
  }

  CouplingGains coupling_;
  double period_ = 0;  ///< [s]
  TrackingGains gains_;
  double whole_ = 0;  ///< periods of delay
  TickMotion motion_;
  Kick before_, now_;  ///< by the force before and by this one, at a period's end
};

/// m where L crosses the negative real axis between two swings; infinite if it is the positive one.
double FactorBetween(const CouplingLoop& loop, double low, double high) {
  const bool below = loop.At(low).imag() < 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    ((loop.At(middle).imag() < 0) == below ? low : high) = middle;
  }
  const double real = loop.At(high).real();
  return real < 0 ? -1 / real : std::numeric_limits<double>::infinity();
}

}  // namespace

double CouplingMargin(const DeviceProfile& profile, const CouplingGains& coupling,
                      double moving_mass) {
  constexpr double kSlowest = 1e-4, kRatio = 1.02;  // swings that are tried [rad a period]
  const CouplingLoop loop(profile, coupling, moving_mass);
  double least = std::numeric_limits<double>::infinity();
  double last = kSlowest;
  bool was_below = loop.At(last).imag() < 0;
  while (last < std::numbers::pi) {
    const double next = std::min(last * kRatio, std::numbers::pi);
    const bool is_below = loop.At(next).imag() < 0;
    if (is_below != was_below) least = std::min(least, FactorBetween(loop, last, next));
    was_below = is_below;
    last = next;
  }
  return least;
}

}  // namespace moontrace
