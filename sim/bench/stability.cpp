#include "sim/bench/stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <random>

#include "sim/bench/device_rig.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

constexpr double kLetter = 0.012;      ///< size of the letters [m]
constexpr double kMeanDepth = 0.0025;  ///< of the random path below the paper [m]

/// One groove of 12 mm letters in the default style, w = 0.1165 em, D = w/2, r = 0.2 w, up the
/// page.
TextureField Groove() {
  const double width = 0.1165 * kLetter;
  Group group;
  group.elements = {{Line{{0, -1}, {0, 1}}, Profile{width, width / 2, 0.2 * width}}};
  Texture texture;
  texture.layers.push_back({Finish(std::move(group)), Relief::kEngraved});
  return TextureField(texture);
}

/// Whether the tip comes back from 1 m off; the model is linear, so the distance does not matter.
bool WallIsQuiet(const SampledModel& model, double stiffness) {
  SampledDevice device(model);
  device.Place({1, 0, 0}, {0, 0, 0});
  // 4000 periods are tens of swings near the limit; growth shows between their quarters
  const int ticks = 4000 * model.period;
  std::array<double, 4> greatest{};
  DeviceState state;
  for (int n = 0; n < ticks; ++n) {
    device.Read(state);
    device.Advance({-stiffness * state.p_D.x, 0, 0}, {0, 0, 0}, {0, 0, 0});
    const double size = std::abs(device.p().x);
    if (!(size < 1e9)) return false;
    double& most = greatest[static_cast<std::size_t>(4 * n / ticks)];
    most = std::max(most, size);
  }
  return greatest[3] < greatest[1];
}

/// A sum of sines: smooth, never twice the same within minutes.
class RandomMotion {
 public:
  RandomMotion(unsigned seed, double size) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    for (Sine& sine : sines_) {
      sine.rate = kTurn * (0.3 + 7.7 * share(random));
      sine.phase = kTurn * share(random);
      sine.size = size / std::sqrt(static_cast<double>(sines_.size()));
    }
  }
  double At(double time) const {
    double sum = 0;
    for (const Sine& s : sines_) sum += s.size * std::sin(s.rate * time + s.phase);
    return sum;
  }
  double Greatest() const { return sines_[0].size * static_cast<double>(sines_.size()); }

 private:
  struct Sine {
    double rate = 0, phase = 0, size = 0;
  };
  std::array<Sine, 8> sines_;
};

}  // namespace

double WallLimit(double damping, double period, double delay) {
  return 2 * damping / (period + 2 * delay);
}

double GreatestStableWall(SampledModel model) {
  model.position_step = 0;
  double low = 1, high = 1e6;
  while (high / low > 1.0001) {
    const double middle = std::sqrt(low * high);
    (WallIsQuiet(model, middle) ? low : high) = middle;
  }
  return low;
}

namespace {

bool CouplingIsQuiet(const SampledModel& model, const CouplingGains& coupling, double factor) {
  SampledModel exact = model;
  exact.position_step = 0;
  SampledDevice device(exact);
  TipEstimate tip(glm::dvec3(model.position_step));
  const double off = 1e-9;  // of a step, or without steps of anything
  DeviceState state;
  const int ticks = 4000 * model.period;
  std::array<double, 4> greatest{};
  for (int n = 0; n < ticks; ++n) {
    const bool fresh = device.Read(state) == DeviceStatus::kOk;
    tip.Advance(model.tick, fresh, state.p_D);
    if (n == 0) device.Place({off, 0, 0}, {0, 0, 0});
    const double force = coupling.stiffness * tip.p().x + coupling.damping * tip.v().x;
    device.Advance({-factor * force, 0, 0}, {0, 0, 0}, {0, 0, 0});
    const double size = std::abs(device.p().x);
    if (!(size < 1e3 * off)) return false;
    double& most = greatest[static_cast<std::size_t>(4 * n / ticks)];
    most = std::max(most, size);
  }
  return greatest[3] < greatest[1];
}

}  // namespace

double SimulatedCouplingMargin(const SampledModel& model, const CouplingGains& coupling) {
  double low = 1e-2, high = 1e4;
  while (high / low > 1.0001) {
    const double middle = std::sqrt(low * high);
    (CouplingIsQuiet(model, coupling, middle) ? low : high) = middle;
  }
  return low;
}

double StirInGroove(const DeviceProfile& profile, const HandModel& hand) {
  const TextureField field = Groove();
  const glm::dvec3 spring(hand.stiffness, hand.stiffness, profile.limits.measures.z ? 0 : 200);
  DeviceRig rig(profile, hand, spring, field, SceneFor(profile));
  // begins beside the groove, above the paper; the hand wants to be on its far rim
  const glm::dvec3 start = ToWorld(rig.X_WP(), {0.0006, 0.05, 0.0005});
  const glm::dvec3 aim = ToWorld(rig.X_WP(), {0.0012, 0.05, 0});
  rig.Place(start);
  glm::dvec3 low = start, high = start;
  for (int n = 0; n < 3000; ++n) {
    rig.Step({0, 0, profile.limits.measures.z ? -hand.press : 0}, aim);
    if (n <= 2700) low = high = rig.device().p();
    low = glm::min(low, rig.device().p());
    high = glm::max(high, rig.device().p());
  }
  return glm::length(high - low);
}

// The bound. The hand follows a path p(t) with velocity v; the rendering answers with a force F
// that is held for a period T and acts t late. Work given to the hand is the integral of F v.
//
// Let f be the force that a passive rendering would give without holding and delay: its work is at
// most what it had stored. F differs from f by what f changes over the lateness tau(t), t to t + T.
// For a spring K, |f(t) - f(t - tau)| is K |p(t) - p(t - tau)|, so the work that lateness adds is
//
//   int K (p(t) - p(t - tau)) v(t) dt <= K (T/2 + t) int v^2 dt:
//
// within one held period the inner integral is |p_{k+1} - p_k|^2 / 2 <= (T/2) int v^2 by Cauchy and
// Schwarz, and the delay adds int int v(s) v(t) ds dt <= t int v^2, by 2 v(s) v(t) <= v(s)^2 +
// v(t)^2. Device and hand take b int v^2 by their damping. So as long as K <= 2 b / (T + 2 t)
// (WallLimit), what is given less what damping took never exceeds what can be stored, however long
// it goes on. Stored at most, the tip d deep at the deepest:
//
//   the page's energy: at most F_cap each metre of depth, F_cap (d + D); a device without a height
//   has instead its press over the groove's depth D;
//   the coupling's spring at the greatest force on it, 2 F_cap allowed: (2 F_cap)^2 / 2 K.
//
// The spring is the coupling; the page's own stiffness in series only makes it softer. What the
// bound leaves out, the proxy's mass (0.05 kg at the hand's speed, below 1 mJ) and the steps of the
// readings, is small compared with the 2 in 2 F_cap.
EnergyOut EnergyOverRandomMotion(const DeviceProfile& profile, const HandModel& hand,
                                 double stiffness, double seconds, unsigned seed) {
  const TextureField field = Groove();
  SceneOptions options = SceneFor(profile);
  options.coupling_stiffness = stiffness;
  DeviceRig rig(profile, hand, {0, 0, 0}, field, options);
  const RandomMotion x(3 * seed, 0.001), y(3 * seed + 1, 0.0002), z(3 * seed + 2, 0.0012);
  const auto at = [&](int n) {
    const double time = n * options.tick;
    return ToWorld(rig.X_WP(), {x.At(time), 0.05 + y.At(time), z.At(time) - kMeanDepth});
  };
  const double groove_depth = 0.1165 * kLetter / 2;
  const double cap = options.surface.force_cap;
  EnergyOut out;
  out.bound = profile.limits.measures.z ? cap * (z.Greatest() + kMeanDepth + groove_depth)
                                        : hand.press * groove_depth;
  out.bound += 4 * cap * cap / (2 * stiffness);
  double given = 0, least = 0;
  const glm::dvec3 moves(1, 1, profile.limits.measures.z ? 1 : 0);
  for (int n = 0; n < static_cast<int>(seconds / options.tick); ++n) {
    const glm::dvec3 p = at(n), next = at(n + 1);
    rig.Follow(p, next);
    const glm::dvec3 travel = moves * (next - p);
    const double taken = profile.limits.damping * glm::dot(travel, travel) / options.tick;
    given += glm::dot(rig.device().felt(), travel) - taken;
    out.taken += taken;
    least = std::min(least, given);
    out.net = std::max(out.net, given - least);
  }
  return out;
}

}  // namespace moontrace
