#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "devices/core/profile.h"
#include "sim/bench/device_rig.h"
#include "sim/bench/row.h"
#include "sim/trial/trial.h"
#include "textures/base/resources.h"

namespace moontrace {

namespace {

constexpr double kSeconds = 120;  ///< six time constants of the profile
constexpr double kSettled = 1;    ///< the ramp-in is over and the hand has come to rest [s]

/// What a hand that rests on a page does to the motors.
struct Rest {
  double press = 0;     ///< along the page's normal, before the motors rest [N]
  double motor = 0;     ///< of it on the warmest motor [N]
  double until = 0;     ///< the motors must rest [s]; infinite if they need not
  double greatest = 0;  ///< heat, 1 is the modelled limit
};

/// A hand aims at a point below the page, straight down, and its spring draws it there, the same in
/// every direction. Nothing holds it on a slope: what it rests with along the slope makes it slide
/// until the spring is straight again. `force` [N] is what it presses with on a level page; the
/// page and the coupling give way like springs in series with it.
Rest RestOn(const DeviceProfile& profile, double force, double tilt) {
  const HandModel hand = ShippedHand();
  const TextureField paper;
  SceneOptions options = SceneFor(profile);
  options.tilt = tilt;
  options.surface.force_cap = 2 * force;  // the hand must not break through
  DeviceRig rig(profile, hand, glm::dvec3(hand.stiffness), paper, options);
  const glm::dvec3 start = ToWorld(rig.X_WP(), {0.1, 0.15, 0});
  const double depth =
      force * (1 / hand.stiffness + 1 / options.surface.stiffness + 1 / options.coupling_stiffness);
  const glm::dvec3 aim = start - glm::dvec3(0, 0, depth);
  rig.Place(start);
  Rest rest;
  rest.until = std::numeric_limits<double>::infinity();
  const auto resting = 1U << static_cast<unsigned>(SafetyEvent::kResting);
  for (int n = 0; n * options.tick < kSeconds; ++n) {
    rig.Step({0, 0, 0}, aim);
    const double time = n * options.tick;
    const SafetyResult& safe = rig.safety_result();
    rest.greatest = std::max({rest.greatest, safe.heat.x, safe.heat.y, safe.heat.z});
    if (std::abs(time - kSettled) < 0.5 * options.tick) {
      rest.press = glm::length(safe.force);
      rest.motor = std::max({std::abs(safe.force.x), std::abs(safe.force.y), safe.force.z});
    }
    if (std::isinf(rest.until) && (safe.events & resting) != 0) rest.until = time;
  }
  return rest;
}

}  // namespace

BenchRows BenchHeat() {
  DeviceProfile profile = LoadProfile(ResourcePath("devices/profiles/moontrace-raw.toml"));
  profile.position_step = 0;  // half a step's force, 10 mN, would hide what is compared
  const double continuous = profile.limits.continuous_force;
  const double tilt = 20 * std::numbers::pi / 180;
  BenchRows rows;
  for (const double share : {2.0, 1.0}) {
    const std::string hand = fmt::format("hand of {:g} N", share * continuous);
    const std::string sloped = hand + ", page tilted 20 degrees";
    const Rest level = RestOn(profile, share * continuous, 0);
    const Rest tilted = RestOn(profile, share * continuous, tilt);
    rows.push_back(Shown(hand + ", page level: presses", level.press, "N"));
    rows.push_back(AtMost(sloped + ": presses", tilted.press, "N", level.press));
    rows.push_back(Shown(hand + ", page level: warmest motor", level.motor, "N"));
    rows.push_back(AtMost(sloped + ": warmest motor", tilted.motor, "N", level.motor));
    if (std::isfinite(level.until)) {
      rows.push_back(Shown(hand + ", page level: motors rest after", level.until, "s"));
    }
    if (std::isfinite(tilted.until)) {
      rows.push_back(Shown(sloped + ": motors rest after", tilted.until, "s"));
    }
    rows.push_back(AtMost(hand + ", page level: heat", level.greatest, "of the limit", 1));
    rows.push_back(AtMost(sloped + ": heat", tilted.greatest, "of the limit", 1));
  }
  return rows;
}

}  // namespace moontrace
