// The tick allocates nothing: every way to the heap is counted. An executable of its own, since it
// replaces malloc for the whole process. Sanitizers replace it too: with them there is nothing to
// count.

#include <mujoco/mujoco.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <string>

#include "sim/loop/button.h"
#include "sim/safety/safety.h"
#include "tests/counted_memory.h"
#include "tests/sim/scene_fixture.h"

#ifdef MOONTRACE_COUNTED_MEMORY

namespace {
std::atomic<long> allocations{0};
}

void OnAllocation() noexcept { ++allocations; }

namespace moontrace {
namespace {

long AllocationsOf(Scene& scene) {
  const long before = allocations.load();
  for (int i = 0; i < 2000; ++i) {
    // in and out of contact, across the groove, and broken input now and then
    const double z = i % 500 == 499 ? NAN : 0.001 * std::sin(0.02 * i) - 0.0005;
    scene.Tick(TipAt({0.002 * std::sin(0.01 * i), 0.01, z}));
  }
  return allocations.load() - before;
}

TEST(NoAllocation, TheCounterCounts) {
  const long before = allocations.load();
  const std::unique_ptr<std::string> text = std::make_unique<std::string>(1000, 'x');
  EXPECT_GE(allocations.load() - before, 2);
}

TEST(NoAllocation, InAnyTick) {
  const TextureField field = GrooveAlongY();
  const std::string ball =
      "<geom type='plane' size='1 1 1' pos='0 0 -0.5'/>"
      "<body pos='0.05 0 -0.4'><freejoint/><geom size='0.05' mass='0.2'/></body>";
  for (const Rendering rendering : {Rendering::kProxy, Rendering::kDirect}) {
    for (const ForceLaw law : {ForceLaw::kPotential, ForceLaw::kPaper}) {
      SceneOptions options;
      options.rendering = rendering;
      options.surface.law = law;
      options.friction = 0.3;
      Scene scene = Scene::FromXml(ModelWith("", ball), "ball", options);
      scene.SetField(&field);
      EXPECT_EQ(AllocationsOf(scene), 0);
    }
  }
}

TEST(NoAllocation, OnLabelsOfEveryKindThatFloat) {
  std::string labels, bodies;
  const char* kinds[] = {"type='box' size='0.02 0.02 0.001'", "type='sphere' size='0.02'",
                         "type='cylinder' size='0.02 0.02'", "type='capsule' size='0.02 0.01'",
                         "type='ellipsoid' size='0.03 0.02 0.015'"};
  char letter = 'a';
  for (const char* kind : kinds) {
    const std::string name(1, letter++);
    labels += "<text name='moontrace:" + name + "' data='{}'/>";
    bodies += "<body><freejoint/><geom name='" + name +
              "' mass='0.3' contype='0' conaffinity='0' " + kind + "/></body>";
  }
  const std::string xml = "<mujoco><option gravity='0 0 0'/><custom>" + labels +
                          "</custom><worldbody>" + bodies + "</worldbody></mujoco>";
  const auto field = std::make_shared<const TextureField>(GrooveAlongY());
  for (const Rendering rendering : {Rendering::kProxy, Rendering::kDirect}) {
    SceneOptions options;
    options.rendering = rendering;
    options.friction = 0.2;
    Scene scene = Scene::FromXml(xml, "all", options);
    for (std::size_t i = 1; i < scene.labels().size(); ++i) scene.SetLabel({i, field, {}});
    scene.SetField(field.get());
    EXPECT_EQ(AllocationsOf(scene), 0);
  }
}

TEST(NoAllocation, InSafetyWhateverHappens) {
  DeviceLimits limits;
  limits.continuous_force = 1;
  limits.heat_time = 1;
  Safety safety(limits, 0.001);
  ButtonState buttons;
  const long before = allocations.load();
  for (int i = 0; i < 5000; ++i) {
    SafetyInput input;
    input.time = 0.001 * i;
    input.force = {i % 1000 == 999 ? NAN : 4.0, i % 7 - 3.0, 2.0};
    input.device.p_D.x = i % 1500 == 1499 ? 0.02 : 0;
    input.stop = AdvanceButtons(buttons, i / 900 % 2 == 1 ? 1U : 0U, input.time, false) ==
                 ButtonAction::kStop;
    input.go_on = i % 2000 == 0;
    safety.Advance(input);
  }
  EXPECT_EQ(allocations.load() - before, 0);
}

TEST(NoAllocation, WhenMujocoResetsItself) {
  const std::string ball = "<body pos='1 0 0'><freejoint/><geom size='0.1' mass='1'/></body>";
  Scene scene = Scene::FromXml(ModelWith("", ball), "ball", {});
  scene.Tick(TipAt({0, 0, 0}));
  const long before = allocations.load();
  scene.data()->qvel[0] = NAN;
  const bool fault = scene.Tick(TipAt({0, 0, 0})).fault;
  const long after = allocations.load();
  EXPECT_TRUE(fault);
  EXPECT_EQ(after - before, 0);
}

}  // namespace
}  // namespace moontrace

#endif  // MOONTRACE_COUNTED_MEMORY
