#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

#include "sim/physics/scene_impl.h"
#include "sim/trial/record.h"
#include "sim/trial/record_columns.h"
#include "tests/sim/record_fixture.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace::test {
namespace {

class ReplayTest : public testing::Test {
 protected:
  TempFolder temp_;
  TextureField field_ = GrooveField();
  std::string folder_ = temp_ / "trial";

  /// Rubs over the groove for 5 s and reads the record back.
  Record Recorded(const SceneOptions& options) {
    Scene scene = SceneAtRest(field_, options);
    RecordTicks(folder_, field_, scene, 0, 5000);
    return ReadRecord(folder_);
  }

  /// The same, but recording begins when 1.5 s have gone: everything is in motion.
  Record RecordedFromMidway() {
    Scene scene = SceneAtRest(field_, RubbingOptions());
    for (std::size_t tick = 0; tick < 1500; ++tick) scene.Tick(InputAt(tick, scene.X_WP()));
    RecordTicks(folder_, field_, scene, 1500, 2500);
    return ReadRecord(folder_);
  }
};

/// Ticks in which the page answers: without them equality would say little.
std::size_t TicksInContact(const Record& record) {
  return static_cast<std::size_t>(std::count_if(
      record.rows.begin(), record.rows.end(),
      [](const RecordRow& row) { return row.output.depth > 0 && row.output.page_force_P.z > 0; }));
}

TEST_F(ReplayTest, IsEqualToTheBitOverFiveSeconds) {
  for (const Rendering rendering : {Rendering::kProxy, Rendering::kDirect}) {
    SceneOptions options = RubbingOptions();
    options.rendering = rendering;
    folder_ = temp_ / (rendering == Rendering::kProxy ? "proxy" : "direct");
    const Record record = Recorded(options);
    const ReplayResult result = Replay(record, field_);
    EXPECT_EQ(result.ticks, 5000U);
    EXPECT_EQ(result.first_difference, 5000U) << result.column;
    EXPECT_EQ(result.column, "");
    EXPECT_GT(TicksInContact(record), 2000U);
  }
}

TEST_F(ReplayTest, IsEqualToTheBitFromMidway) {
  const Record record = RecordedFromMidway();
  EXPECT_GT(TicksInContact(record), 400U);
  const ReplayResult result = Replay(record, field_);
  EXPECT_EQ(result.first_difference, 1000U) << result.column;
}

TEST_F(ReplayTest, NamesTickAndColumnOfAFlippedBit) {
  Recorded(RubbingOptions());
  for (std::size_t column = kFirstOutput; column + 1 < kAfterOutputs; ++column) {
    const std::size_t byte = 3217 * kRowBytes + column * 8;
    FlipBit(folder_ + "/samples.f64", byte, 0);
    const ReplayResult result = Replay(ReadRecord(folder_, true), field_);
    EXPECT_EQ(result.first_difference, 3217U);
    EXPECT_EQ(result.column, kRecordColumns[column]);
    FlipBit(folder_ + "/samples.f64", byte, 0);
  }
}

TEST_F(ReplayTest, NamesTheTickOfAnAlteredInput) {
  Recorded(RubbingOptions());
  FlipBit(folder_ + "/samples.f64", 3217 * kRowBytes + 8 + 5, 0);  // device_x_m, bit 40
  const ReplayResult result = Replay(ReadRecord(folder_, true), field_);
  EXPECT_EQ(result.first_difference, 3217U);
  EXPECT_EQ(result.column, "tip_x_m");
}

TEST_F(ReplayTest, NoticesOtherOptions) {
  const Record record = Recorded(RubbingOptions());
  const auto differs = [&](void (*change)(SceneOptions&)) {
    Record other = record;
    change(other.options);
    return Replay(other, field_).first_difference < 5000;
  };
  EXPECT_FALSE(differs([](SceneOptions&) {}));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.coupling_stiffness = 999; }));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.coupling_damping = 9; }));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.friction = 0.11; }));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.presliding_stiffness = 1999; }));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.surface.stiffness = 999; }));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.surface.force_cap = 0.5; }));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.surface.law = ForceLaw::kPaper; }));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.rendering = Rendering::kDirect; }));
  EXPECT_TRUE(differs([](SceneOptions& o) { o.tilt = 0.21; }));
}

// Guards the guard: a record begun midway must depend on its initial state, else the equality above
// would not show that the state is complete.
TEST_F(ReplayTest, NoticesAnInitialStateAtRest) {
  Record record = RecordedFromMidway();
  Scene scene = SceneAtRest(field_, RubbingOptions());
  record.state = scene.State();
  EXPECT_EQ(Replay(record, field_).first_difference, 0U);
}

/// A page on a box that stands loose on a floor: MuJoCo's contact solver takes part, and it starts
/// from the accelerations of the step before.
constexpr const char* kLooseBox = R"(<mujoco>
  <custom><text name="moontrace:box" data="{at_mm = [-105, -150]}"/></custom>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 0.1"/>
    <body pos="0 0 0.02"><freejoint/><geom name="box" type="box" size="0.105 0.15 0.02" mass="2"/></body>
  </worldbody>
</mujoco>)";

/// Where parts of Scene::State begin, the warm start of the model's own joints (scene.cpp's order:
/// time, positions, velocities, activations, warm start, ..., and the tick's memory last).
std::size_t WarmstartOf(const Scene& scene) {
  const mjModel& m = *scene.model();
  return static_cast<std::size_t>(1 + m.nq + m.nv + m.na + kInserted);
}
std::size_t FrictionOf(const Scene& scene) {
  return scene.State().size() - (sizeof(TickMemory) - offsetof(TickMemory, friction)) / 8;
}

TEST_F(ReplayTest, NeedsWarmStartAndFrictionOfTheInitialState) {
  SceneOptions options = RubbingOptions();
  options.tilt = 0;
  Scene scene = Scene::FromXml(kLooseBox, "loose box", options);
  scene.SetField(&field_);
  const Pose X_WP = scene.X_WP();  // inputs stay in the world while the box gives way
  scene.Reset(FromWorld(X_WP, InputAt(0, X_WP).p_D));
  for (std::size_t tick = 0; tick < 500; ++tick) scene.Tick(InputAt(tick, X_WP));
  RecordTicks(folder_, field_, scene, 500, 1500);
  const Record record = ReadRecord(folder_);
  ASSERT_EQ(Replay(record, field_).first_difference, 1000U);
  EXPECT_GT(TicksInContact(record), 400U);

  for (const std::size_t part : {WarmstartOf(scene), FrictionOf(scene)}) {
    Record without = record;
    const auto begin = without.state.begin() + static_cast<std::ptrdiff_t>(part);
    const auto end = begin + 3;  // the box's linear accelerations; the bristle's stretch
    ASSERT_TRUE(std::any_of(begin, end, [](double value) { return value != 0; })) << part;
    std::fill(begin, end, 0.0);
    EXPECT_LT(Replay(without, field_).first_difference, 1000U) << part;
  }
}

TEST_F(ReplayTest, RefusesAnotherPage) {
  const Record record = Recorded(RubbingOptions());
  const std::string line = LineOf<InputError>([&] { Replay(record, TextureField()); });
  EXPECT_NE(line.find("page digest 0x"), std::string::npos) << line;
}

TEST_F(ReplayTest, RefusesAStateOfAnotherProgram) {
  Record record = Recorded(RubbingOptions());
  record.state.pop_back();
  const std::string line = LineOf<InputError>([&] { Replay(record, field_); });
  EXPECT_NE(line.find("replay it with moontrace "), std::string::npos) << line;
}

}  // namespace
}  // namespace moontrace::test
