#include "sim/bench/grit.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "devices/core/tick_motion.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

constexpr double kDuration = 2;  // [s]
constexpr double kPress = 1;     // onto the paper [N]
constexpr double kAir = 0.01;    // above it [m]

/// Where the tip is after each tick along its way, from rest [m]: a mass on a spring and a damper
/// whose other end is the aim.
std::vector<double> WayOf(const HandModel& hand, const GritPath& path, double tick) {
  const TickMotion motion = MotionOver(hand.mass, hand.stiffness, hand.damping, tick);
  std::vector<double> way = {0};
  double x = 0, v = 0, aim = 0;
  for (double time = 0; time < kDuration; time += tick) {
    const bool back =
        path.stroke_time > 0 && static_cast<long>((time + 0.5 * tick) / path.stroke_time) % 2 == 1;
    const double speed = back ? -path.speed : path.speed;
    double behind = x - aim, rate = v - speed;
    Move(motion, behind, rate, 0);
    aim += speed * tick;
    x = aim + behind;
    v = speed + rate;
    way.push_back(x);
  }
  return way;
}

}  // namespace

Grit GritOn(const DeviceProfile& profile, const HandModel& hand, const SceneOptions& options,
            const GritPath& path) {
  DeviceProfile exact = profile;
  exact.position_step = 0;
  const TextureField flat;
  DeviceRig stepped(profile, hand, {0, 0, 0}, flat, options);
  DeviceRig smooth(exact, hand, {0, 0, 0}, flat, options);
  const double depth = kPress * (1 / options.surface.stiffness + 1 / options.coupling_stiffness);
  const double height = path.on_paper ? -depth : kAir;
  // no round number of any step, so that no axis begins in the middle of one
  const glm::dvec3 start(0.0712345, 0.0543217, height);
  const glm::dvec3 along(std::cos(path.angle), std::sin(path.angle), 0);
  const std::vector<double> way = WayOf(hand, path, options.tick);
  Grit grit;
  for (std::size_t n = 0; n + 1 < way.size(); ++n) {
    const glm::dvec3 p = ToWorld(stepped.X_WP(), start + way[n] * along);
    const glm::dvec3 next = ToWorld(stepped.X_WP(), start + way[n + 1] * along);
    stepped.Follow(p, next);
    smooth.Follow(p, next);
    const glm::dvec2 more(stepped.scene_result().force_P - smooth.scene_result().force_P);
    grit.rms += glm::dot(more, more);
    grit.peak = std::max(grit.peak, glm::length(more));
  }
  grit.rms = std::sqrt(grit.rms / static_cast<double>(way.size() - 1));
  return grit;
}

Grit WorstGrit(const DeviceProfile& profile, const HandModel& hand, const SceneOptions& options) {
  Grit worst;
  for (const double speed : {0.001, 0.002, 0.005, 0.0193, 0.05}) {
    for (const double angle : {0.0, 7 * kDegree, 30 * kDegree, 45 * kDegree}) {
      for (const double stroke_time : {0.0, 0.35}) {
        for (const bool on_paper : {false, true}) {
          const Grit grit = GritOn(profile, hand, options, {speed, angle, stroke_time, on_paper});
          worst.rms = std::max(worst.rms, grit.rms);
          worst.peak = std::max(worst.peak, grit.peak);
        }
      }
    }
  }
  return worst;
}

}  // namespace moontrace
