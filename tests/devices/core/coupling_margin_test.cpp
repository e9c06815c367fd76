#include "devices/core/coupling_margin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "devices/catalogue/catalogue.h"
#include "devices/core/tick_motion.h"
#include "devices/hand/hand.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

constexpr double kMass = 0.1;

DeviceProfile Exact(double damping, double rate, double delay) {
  DeviceProfile profile;
  profile.limits.damping = damping;
  profile.rate = rate;
  profile.delay = delay;
  return profile;
}

// A spring alone, on time: the tip's two eigenvalues are a pair whose product reaches 1, see
// tests/sim/loop/passivity_profiles_test.cpp.
TEST(CouplingMargin, OfASpringIsThatOfAWall) {
  for (const double damping : {1.0, 3.0, 10.0}) {
    for (const double rate : {125.0, 1000.0, 4000.0}) {
      const TickMotion m = MotionOver(kMass, 0, damping, 1 / rate);
      const double wall = (1 - m.vv) / (m.xv * m.vf - m.xf * m.vv);
      EXPECT_NEAR(CouplingMargin(Exact(damping, rate, 0), {100, 0}, kMass), wall / 100,
                  1e-4 * wall / 100)
          << damping << ' ' << rate;
    }
  }
}

// Without holding, K and B that act t late swing at w lastingly where
// K = m w^2 cos w t + b w sin w t, B = m w sin w t - b cos w t (the equation of motion at s = i w,
// its real and imaginary part). Held for a 50th of t, they act t + T/2 late.
TEST(CouplingMargin, OfSpringAndDamperIsOneOnTheBorderOfALateOne) {
  const double t = 0.005, b = 3, period = t / 50;
  for (const double w : {150.0, 200.0, 250.0}) {
    const double late = t + period / 2;
    const double stiffness = kMass * w * w * std::cos(w * late) + b * w * std::sin(w * late);
    const double damping = kMass * w * std::sin(w * late) - b * std::cos(w * late);
    ASSERT_GT(damping, 0);
    // the difference of two readings is half a period older than they are
    EXPECT_NEAR(CouplingMargin(Exact(b, 1 / period, t), {stiffness, damping}, kMass), 1, 0.02) << w;
  }
}

TEST(CouplingMargin, FallsWithDelayAndWithCoarseReadings) {
  const CouplingGains coupling{800, 8};
  DeviceProfile profile = Exact(3, 1000, 0.001);
  const double exact = CouplingMargin(profile, coupling, kMass);
  profile.delay = 0.003;
  EXPECT_LT(CouplingMargin(profile, coupling, kMass), exact);
  profile.delay = 0.001;
  double last = exact;
  for (const double step : {1e-6, 10e-6, 50e-6, 100e-6}) {
    profile.position_step = step;
    const double margin = CouplingMargin(profile, coupling, kMass);
    EXPECT_LT(margin, last) << step;
    last = margin;
  }
}

TEST(CouplingOf, LeavesEveryShippedProfileItsMargin) {
  const HandModel hand = LoadHand(SourcePath("devices/hand.toml"));
  int pushing = 0;
  for (const DeviceProfile& profile : LoadProfiles(SourcePath("devices/profiles"))) {
    if (!glm::any(profile.limits.pushes)) continue;
    ++pushing;
    const CouplingGains coupling = CouplingOf(profile);
    EXPECT_GE(CouplingMargin(profile, coupling, hand.mass), kLeastCouplingMargin) << profile.name;
    EXPECT_LE(coupling.stiffness, StableStiffness(profile)) << profile.name;
    EXPECT_GE(coupling.stiffness, 290) << profile.name;
  }
  EXPECT_GE(pushing, 7);
}

TEST(CouplingOf, IsStiffWhereReadingsAreFine) {
  const CouplingGains raw =
      CouplingOf(LoadProfile(SourcePath("devices/profiles/moontrace-raw.toml")));
  EXPECT_NEAR(raw.stiffness, 2000, 1e-6);
  EXPECT_NEAR(raw.damping, 14, 1e-6);
  DeviceProfile plugin = Exact(3, 1000, 0.001);
  plugin.limits.stiffness = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(CouplingOf(plugin).stiffness, 1000, 1e-6);
  plugin.limits.damping = 0;  // unknown: the hand's own is there
  EXPECT_NEAR(CouplingOf(plugin).stiffness, 1000, 1e-6);
  plugin.limits.stiffness = 0;  // pushes nothing
  EXPECT_EQ(CouplingOf(plugin).stiffness, 0);
}

}  // namespace
}  // namespace moontrace
