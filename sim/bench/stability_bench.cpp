#include <fmt/core.h>

#include <algorithm>
#include <glm/glm.hpp>

#include "devices/catalogue/catalogue.h"
#include "devices/core/coupling_margin.h"
#include "sim/bench/device_rig.h"
#include "sim/bench/grit.h"
#include "sim/bench/row.h"
#include "sim/bench/stability.h"
#include "sim/trial/trial.h"
#include "textures/base/resources.h"

namespace moontrace {

namespace {

/// A wall for each damping and rate, with the force on time and a period late.
void AddWalls(const HandModel& hand, BenchRows& rows) {
  for (const double damping : {1.0, 3.0, 10.0}) {
    for (const double rate : {250.0, 500.0, 1000.0, 4000.0}) {
      for (const int late : {0, 1}) {
        SampledModel model;
        model.mass = hand.mass;
        model.damping = damping;
        model.tick = 1 / rate;
        model.delay = late;
        const double limit = WallLimit(damping, model.tick, late * model.tick);
        rows.push_back(AtLeast(fmt::format("wall, {:g} N s/m, {:g} Hz, {}", damping, rate,
                                           late == 0 ? "on time" : "a period late"),
                               GreatestStableWall(model), "N/m", limit));
      }
    }
  }
}

void AddProfile(const DeviceProfile& profile, const HandModel& hand, BenchRows& rows) {
  const SceneOptions options = SceneFor(profile);
  const std::string& name = profile.name;
  rows.push_back(Shown(name + ": 2 b / (T + 2 t)",
                       WallLimit(profile.limits.damping, 1 / profile.rate, profile.delay), "N/m"));
  if (profile.coulomb_friction > 0 && profile.position_step > 0) {
    rows.push_back(Shown(name + ": 2 f_c / step",
                         2 * profile.coulomb_friction / profile.position_step, "N/m"));
  }
  rows.push_back(Shown(name + ": coupling, spring", options.coupling_stiffness, "N/m"));
  rows.push_back(Shown(name + ": coupling, damper", options.coupling_damping, "N s/m"));
  const CouplingGains coupling = CouplingOf(profile);
  rows.push_back(AtLeast(name + ": coupling's margin", CouplingMargin(profile, coupling, hand.mass),
                         "times", kLeastCouplingMargin));
  const SampledModel model = ModelOf(profile, hand.mass, options.tick);
  rows.push_back(AtLeast(name + ": the same by simulation",
                         SimulatedCouplingMargin(model, coupling), "times", kLeastCouplingMargin));
  const Grit grit = WorstGrit(profile, hand, options);
  rows.push_back(
      AtMost(name + ": grit of steps, 1 to 50 mm/s, rms", grit.rms, "N", kGreatestGrit.rms));
  rows.push_back(
      AtMost(name + ": grit of steps, 1 to 50 mm/s, peak", grit.peak, "N", kGreatestGrit.peak));
  rows.push_back(Shown(name + ": the profile's figure", profile.limits.stiffness, "N/m"));
  rows.push_back(AtLeast(name + ": a wall held quiet",
                         GreatestStableWall(ModelOf(profile, hand.mass, options.tick)), "N/m",
                         StableStiffness(profile)));
  // a tip at rest may waver by a step of its readings, either way, on each axis
  rows.push_back(AtMost(name + ": stir in a groove", 1e6 * StirInGroove(profile, hand), "um",
                        1e6 * (5e-6 + 2 * profile.position_step)));
  const EnergyOut energy = EnergyOverRandomMotion(profile, hand, options.coupling_stiffness, 60, 1);
  rows.push_back(
      AtMost(name + ": energy out, a minute", 1e3 * energy.net, "mJ", 1e3 * energy.bound));
}

}  // namespace

BenchRows BenchStability() {
  BenchRows rows;
  const HandModel hand = ShippedHand();
  AddWalls(hand, rows);
  for (const DeviceProfile& profile : LoadProfiles(ResourcePath("devices/profiles"))) {
    if (glm::any(profile.limits.pushes)) AddProfile(profile, hand, rows);
  }
  return rows;
}

}  // namespace moontrace
