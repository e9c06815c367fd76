#include <gtest/gtest.h>

#include <algorithm>
#include <glm/glm.hpp>

#include "devices/catalogue/catalogue.h"
#include "devices/core/coupling_margin.h"
#include "sim/bench/device_rig.h"
#include "sim/bench/stability.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

const std::string kProfiles = SourcePath("devices/profiles");

HandModel Hand() { return LoadHand(SourcePath("devices/hand.toml")); }

// The bound is derived in sim/bench/stability.cpp: what scene and safety give to the hand, less
// what the damping of hand and device takes, never exceeds what can be stored, however long it goes
// on, because every profile's stiffness is within 2 b / (T + 2 t).
TEST(Passivity, OfEveryShippedProfileOverRandomMotion) {
  int pushing = 0;
  for (const DeviceProfile& profile : LoadProfiles(kProfiles)) {
    if (!glm::any(profile.limits.pushes)) continue;
    ++pushing;
    const double stiffness = SceneFor(profile).coupling_stiffness;
    EXPECT_LE(stiffness, WallLimit(profile.limits.damping, 1 / profile.rate, profile.delay))
        << profile.name;
    for (unsigned seed = 1; seed <= 2; ++seed) {
      const EnergyOut energy = EnergyOverRandomMotion(profile, Hand(), stiffness, 60, seed);
      EXPECT_LE(energy.net, energy.bound) << profile.name << ' ' << seed;
      EXPECT_GT(energy.net, 1e-5) << profile.name;    // there was a page, and it pushed back
      EXPECT_GT(energy.taken, 0.01) << profile.name;  // [J]: the hand went about
    }
  }
  EXPECT_GE(pushing, 7);
}

// Seven times beyond the limit lateness gives more than damping takes, for ever: the bound is one
// that can be missed.
TEST(Passivity, IsLostByADeviceThatAnswersFarTooLate) {
  DeviceProfile profile = LoadProfile(kProfiles + "/woodenhaptics.toml");
  profile.delay = 0.02;
  const EnergyOut minute = EnergyOverRandomMotion(profile, Hand(), 1000, 60, 1);
  EXPECT_GT(minute.net, minute.bound);
  EXPECT_GT(EnergyOverRandomMotion(profile, Hand(), 1000, 120, 1).net, 1.5 * minute.net);
}

// A mass m with damping b moves over a period T by x1 = x + xv v + xf f, v1 = vv v + vf f (exact
// for a held force f = -K x): both eigenvalues lie within the unit circle as long as their product,
// the determinant vv + K (xv vf - xf vv), is below 1 (they are a pair there).
TEST(Stability, BisectionFindsTheWallThatTheEigenvaluesGive) {
  for (const double damping : {1.0, 3.0, 10.0}) {
    for (const double period : {0.00025, 0.001, 0.004}) {
      SampledModel model;
      model.damping = damping;
      model.tick = period;
      const TickMotion m = MotionOver(model.mass, 0, damping, period);
      const double exact = (1 - m.vv) / (m.xv * m.vf - m.xf * m.vv);
      EXPECT_NEAR(GreatestStableWall(model), exact, 0.002 * exact) << damping << ' ' << period;
    }
  }
}

// m s^2 + b s + K exp(-s tau) has its border at K cos(w tau) = m w^2, K sin(w tau) = b w. With
// sin x < x that gives K > b / tau whatever the mass: the closed form is on the safe side, and
// close to the border where the swing is slow against tau.
TEST(Stability, ClosedFormLimitIsWithinWhatIsHeldAndNearIt) {
  for (const int late : {0, 1, 3}) {
    for (const double damping : {1.0, 3.0}) {
      SampledModel model;
      model.damping = damping;
      model.delay = late;
      const double limit = WallLimit(damping, 0.001, 0.001 * late);
      const double held = GreatestStableWall(model);
      EXPECT_GE(held, limit) << damping << ' ' << late;
      EXPECT_LE(held, 1.1 * limit) << damping << ' ' << late;
    }
  }
}

// Two ways to one figure: one period's response in closed form, and a tip let go in simulation.
TEST(Stability, ACouplingsMarginIsTheSameBySimulation) {
  for (const DeviceProfile& profile : LoadProfiles(kProfiles)) {
    if (!glm::any(profile.limits.pushes)) continue;
    const CouplingGains coupling = CouplingOf(profile);
    const double margin = CouplingMargin(profile, coupling, Hand().mass);
    EXPECT_NEAR(SimulatedCouplingMargin(ModelOf(profile, Hand().mass, 0.001), coupling), margin,
                0.005 * margin)
        << profile.name;
  }
}

TEST(Stability, AGrooveLeavesTheTipAtRestOnEveryShippedProfile) {
  for (const DeviceProfile& profile : LoadProfiles(kProfiles)) {
    if (!glm::any(profile.limits.pushes)) continue;
    // a step of the readings either way; 5 um where they are finer
    EXPECT_LE(StirInGroove(profile, Hand()), 5e-6 + 2 * profile.position_step) << profile.name;
  }
}

}  // namespace
}  // namespace moontrace
