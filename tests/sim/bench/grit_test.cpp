#include "sim/bench/grit.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>

#include "devices/catalogue/catalogue.h"
#include "tests/source_path.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

const std::string kProfiles = SourcePath("devices/profiles");

HandModel Hand() { return LoadHand(SourcePath("devices/hand.toml")); }

TEST(Grit, IsNoneWhereReadingsAreExact) {
  DeviceProfile profile = LoadProfile(kProfiles + "/woodenhaptics.toml");
  profile.position_step = 0;
  const Grit grit = GritOn(profile, Hand(), SceneFor(profile), {0.02, 0, 0.35, true});
  EXPECT_EQ(grit.rms, 0);
  EXPECT_EQ(grit.peak, 0);
}

// Without a tracker a step of 64 um is 64 mm/s to the damper: 0.5 N rms.
TEST(Grit, OfCoarseStepsIsNotFelt) {
  for (const char* name : {"/woodenhaptics.toml", "/sidewinder-ff2.toml"}) {
    const DeviceProfile profile = LoadProfile(kProfiles + name);
    for (const bool on_paper : {false, true}) {
      for (const double stroke_time : {0.0, 0.35}) {
        const Grit grit = GritOn(profile, Hand(), SceneFor(profile),
                                 {0.0193, 7 * kDegree, stroke_time, on_paper});
        EXPECT_LT(grit.rms, kGreatestGrit.rms) << name << on_paper << stroke_time;
        EXPECT_LT(grit.peak, kGreatestGrit.peak) << name << on_paper << stroke_time;
        EXPECT_GT(grit.rms, 1e-4) << name;  // there are steps
      }
    }
  }
}

TEST(SlowGrit, OfEveryShippedProfileIsNotFelt) {
  int pushing = 0;
  for (const DeviceProfile& profile : LoadProfiles(kProfiles)) {
    if (!glm::any(profile.limits.pushes)) continue;
    ++pushing;
    const Grit worst = WorstGrit(profile, Hand(), SceneFor(profile));
    EXPECT_LT(worst.rms, kGreatestGrit.rms) << profile.name;
    EXPECT_LT(worst.peak, kGreatestGrit.peak) << profile.name;
  }
  EXPECT_GE(pushing, 7);
}

}  // namespace
}  // namespace moontrace
