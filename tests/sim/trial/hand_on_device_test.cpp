#include "sim/trial/hand_on_device.h"

#include <gtest/gtest.h>

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "devices/catalogue/catalogue.h"
#include "sim/physics/page_field.h"
#include "sim/trial/metrics_json.h"
#include "sim/trial/record.h"
#include "sim/trial/trial.h"
#include "tests/sim/record_fixture.h"
#include "tests/source_path.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

DeviceProfile Profile(const std::string& name) {
  return LoadProfile(SourcePath("devices/profiles/" + name + ".toml"));
}

/// A line of Moon at 20 mm, traced by the shipped hand.
class HandOnDeviceTest : public testing::Test {
 protected:
  TrialResult Traced(const std::optional<DeviceProfile>& device,
                     const RecordRequest* record = nullptr) {
    TrialSetup setup;
    setup.script = &script_;
    setup.page = &set_.pages.front();
    setup.style = set_.style;
    setup.hand = ShippedHand();
    setup.device = device;
    return RunTrial(setup, record);
  }

  Script script_ = FindScript("moon");
  Typeset set_ = SetText("moon", script_, DefaultStyle(0.020, Relief::kEngraved, script_),
                         {"a4", 0.210, 0.297, 0.015});
};

// Of what the observer counts by positions in steps most is the steps' own: the hand never went
// there. By its true way a line gains less than a millijoule, on every device.
TEST_F(HandOnDeviceTest, GetsLessThanAMillijouleALineByItsTrueWay) {
  int pushing = 0;
  for (const DeviceProfile& profile : LoadProfiles(SourcePath("devices/profiles"))) {
    if (!glm::any(profile.limits.pushes)) continue;
    ++pushing;
    const TrialResult result = Traced(profile);
    ASSERT_TRUE(result.true_energy_out) << profile.name;
    EXPECT_LT(*result.true_energy_out, 1e-3) << profile.name;
    EXPECT_GT(*result.true_energy_out, 0) << profile.name;
    EXPECT_EQ(result.faults, 0U) << profile.name;
    // the page is felt; joysticks, which give the flanks' force alone, hold the tip less
    EXPECT_GT(result.score.total.coverage, profile.limits.measures.z ? 0.99 : 0.5) << profile.name;
    EXPECT_LT(result.score.total.peak_force, profile.limits.peak_force) << profile.name;
  }
  EXPECT_GE(pushing, 7);
}

TEST_F(HandOnDeviceTest, IsReadExactlyWithoutAProfile) {
  const TrialResult result = Traced(std::nullopt);
  EXPECT_FALSE(result.true_energy_out);
  EXPECT_EQ(ResultText(result).find("readings"), std::string::npos);
}

TEST_F(HandOnDeviceTest, RecordsWhatReplaysToTheBit) {
  const test::TempFolder folder;
  RecordRequest request{folder / "run", "{}"};
  const TrialResult result = Traced(Profile("woodenhaptics"), &request);
  const Record record = ReadRecord(request.folder);
  EXPECT_EQ(record.options.coupling_stiffness, CouplingOf(Profile("woodenhaptics")).stiffness);
  const TextureField field = PageField(set_.pages.front(), script_, set_.style, false);
  const ReplayResult replay = Replay(record, field);
  EXPECT_EQ(replay.ticks, result.ticks);
  EXPECT_EQ(replay.first_difference, replay.ticks) << replay.column;
}

/// A hand that rests for a second above the page, or moves there at 20 mm/s.
HandPath Path(double speed) {
  HandPath path;
  path.points = {{0, {0.0512345, 0.0312345, 0.02}, 0},
                 {1, {0.0512345 + speed, 0.0312345, 0.02}, 0}};
  return path;
}

/// What is read of it in the air with no force, tick by tick: the true place and the scene's input.
void Watch(const DeviceProfile& profile, double speed,
           const std::function<void(int, glm::dvec3, const DeviceState&)>& look) {
  const Scene scene = Scene::Load("", SceneOptions());
  const TextureField flat;
  HandOnDevice::Setup setup;
  setup.hand = ShippedHand();
  setup.hand.tremor_rms = 0;
  setup.path = Path(speed);
  setup.profile = &profile;
  HandOnDevice hand(setup, scene.X_WP());
  for (int n = 0; n < 1000; ++n) {
    const DeviceState input = hand.Read(scene, nullptr, flat);
    look(n, hand.p_W(), input);
    hand.Write({0, 0, 0}, 0);
  }
}

TEST(HandOnDevice, ReadsARestingHandToHalfAStep) {
  const DeviceProfile profile = Profile("woodenhaptics");
  Watch(profile, 0, [&](int n, glm::dvec3 p, const DeviceState& input) {
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_LE(std::abs(input.p_D[axis] - p[axis]), 0.5 * profile.position_step + 1e-12) << n;
    }
    ASSERT_EQ(input.v_D, glm::dvec3(0, 0, 0));
  });
}

TEST(HandOnDevice, ReadsAMovingHandAtTheDevicesRate) {
  const DeviceProfile profile = Profile("sidewinder-ff2");  // 125 Hz
  glm::dvec3 last{0, 0, 0};
  int changes = 0;
  Watch(profile, 0.02, [&](int n, glm::dvec3, const DeviceState& input) {
    if (n > 0 && input.p_D.x != last.x) {
      EXPECT_EQ(n % 8, 0);
      ++changes;
    }
    last = input.p_D;
  });
  EXPECT_GT(changes, 100);
}

}  // namespace
}  // namespace moontrace
