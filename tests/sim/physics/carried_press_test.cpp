// How firmly a page can be pressed, and what happens beyond: the hand here is a mass that only
// presses, so nothing but the page holds it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sim/loop/device_feel.h"
#include "sim/physics/coupling.h"
#include "tests/sim/scene_fixture.h"
#include "tests/textures/sample_page.h"

namespace moontrace {
namespace {

/// A mass of 100 g with 3 N s/m on the page, pressed down; it feels a force one tick late.
class PressingHand {
 public:
  explicit PressingHand(glm::dvec3 p_W) : p_W_(p_W) {}
  TickResult Press(Scene& scene, double press) {
    const TickResult result = scene.Tick(TipAt(p_W_));
    constexpr double kTick = 0.001, kMass = 0.1, kDamping = 3;
    v_ += kTick / kMass * (felt_ - press - kDamping * v_);
    p_W_.z += kTick * v_;
    felt_ = result.force_W.z;
    return result;
  }
  double z() const { return p_W_.z; }

 private:
  glm::dvec3 p_W_;
  double v_ = 0, felt_ = 0;
};

struct Felt {
  double lowest = 0;    ///< of the tip [m]
  double greatest = 0;  ///< force [N]
  bool through = false;
};

Felt PressFor(Scene& scene, PressingHand& hand, double press, int ticks) {
  Felt felt;
  for (int i = 0; i < ticks; ++i) {
    // within a third of a second, as a hand presses; at once it would fall
    const TickResult result = hand.Press(scene, press * std::min(1.0, (i + 1) / 300.0));
    felt.lowest = std::min(felt.lowest, hand.z());
    felt.greatest = std::max(felt.greatest, glm::length(result.force_W));
    felt.through = felt.through || result.through;
  }
  return felt;
}

TEST(CarriedPress, IsHeldForLongOnPaperAndInAGrooveAtEverySize) {
  for (const double size : {0.005, 0.012, 0.04}) {
    const SamplePage page = MakePage("i", size, Relief::kEngraved);
    const TextureField field(page.texture);
    const glm::dvec2 groove =
        page.typeset.pages.front().glyphs.front().origin_P + glm::dvec2(0, size / 2);
    Scene scene = Scene::Load("", {});
    scene.SetField(&field);
    const double carried = CarriedPress(scene.options().surface, field);
    EXPECT_GT(carried, 3);
    for (const double press : {0.3, 1.0, 2.0, carried}) {
      for (const glm::dvec2 place : {glm::dvec2(0.1, 0.05), groove}) {
        scene.Reset({place, 0.001});
        PressingHand hand({place, 0.001});
        const Felt felt = PressFor(scene, hand, press, 20000);
        EXPECT_FALSE(felt.through) << size << " " << press;
        EXPECT_LE(felt.greatest, ForceBound(scene.options(), scene.proxy_mass(),
                                            {.acceleration = 30}, scene.substeps()));
      }
    }
  }
}

// A plate of a millimetre carries what a page of its stiffness does: what is behind it is not felt.
TEST(CarriedPress, IsHeldByAPlateThinnerThanItIsDeep) {
  const std::string plate =
      "<mujoco><custom><text name='moontrace:plate' data='{}'/></custom><worldbody>"
      "<geom name='plate' type='box' size='0.06 0.03 0.0005' pos='0 0 -0.0005' contype='0' "
      "conaffinity='0'/></worldbody></mujoco>";
  const TextureField field = GrooveAlongY();
  for (const double x : {0.0, 0.02}) {
    Scene scene = Scene::FromXml(plate, "plate", {});
    scene.SetField(&field);
    const double carried = scene.carried_press();
    EXPECT_NEAR(carried, CarriedPress(scene.options().surface, field), 1e-12);
    for (const double press : {1.0, 2.0, carried}) {
      scene.Reset({x, 0.01, 0.001});
      PressingHand hand({x, 0.01, 0.001});
      EXPECT_FALSE(PressFor(scene, hand, press, 3000).through) << press;
      EXPECT_NEAR(hand.Press(scene, press).force_W.z, press, 0.01) << press;
    }
    PressingHand hand({x, 0.01, 0.001});
    scene.Reset({x, 0.01, 0.001});
    EXPECT_TRUE(PressFor(scene, hand, 5, 600).through);
  }
}

// A press above it: once through, no force, no throw on the way back, and the page is felt again.
TEST(CarriedPress, BeyondItTheTipIsThroughAndComesBackWithoutAPush) {
  const SamplePage page = MakePage("i", 0.012, Relief::kEngraved);
  const TextureField field(page.texture);
  Scene scene = Scene::Load("", {});
  scene.SetField(&field);
  const double bound = ForceBound(scene.options(), scene.proxy_mass(), {.acceleration = 30});
  scene.Reset({0.1, 0.05, 0.001});
  PressingHand hand({0.1, 0.05, 0.001});
  EXPECT_FALSE(PressFor(scene, hand, 1.0, 1000).through);
  EXPECT_LE(PressFor(scene, hand, 5.0, 300).greatest, bound);
  EXPECT_TRUE(hand.Press(scene, 5.0).through);
  PressFor(scene, hand, 5.0, 40);
  EXPECT_EQ(PressFor(scene, hand, 5.0, 40).greatest, 0);
  double greatest = 0;
  bool above = false;
  for (int i = 0; i < 20000 && !above; ++i) {
    const TickResult result = hand.Press(scene, -0.3);  // lifted
    greatest = std::max(greatest, result.force_W.z);
    above = !result.through;
  }
  ASSERT_TRUE(above);
  EXPECT_LT(greatest, 0.1);
  EXPECT_LT(hand.Press(scene, 0).energy_out, 1e-3);  // dropped, not handed out
  EXPECT_GT(hand.z(), -0.0005);
  EXPECT_FALSE(PressFor(scene, hand, 1.0, 3000).through);
  EXPECT_NEAR(hand.Press(scene, 1.0).force_W.z, 1.0, 1e-3);
}

// A force that ramps in lets the hand sink: the page comes back under it, it has not been pressed
// through.
TEST(CarriedPress, AHandThatSinksWhileTheForceIsHeldBackIsPushedUpAgain) {
  Scene scene = Scene::Load("", {});
  scene.Reset({0.1, 0.05, -0.001});
  for (int i = 0; i < 200; ++i) {
    const DeviceState tip = TipAt({0.1, 0.05, -0.001 - 1e-4 * i});
    EXPECT_FALSE(scene.Tick(tip, false).through);
  }
  const TickResult pushed = Hold(scene, {0.1, 0.05, -0.021}, 500);
  EXPECT_FALSE(pushed.through);
  EXPECT_NEAR(pushed.force_W.z, 0.835 * 4, 1e-6);
  EXPECT_NEAR(Hold(scene, {0.1, 0.05, -0.001}, 1000).force_W.z, 0.5, 1e-6);
}

TEST(CarriedPress, OfADeviceIsAtLeastSixTenthsOfItsPeak) {
  for (const double peak : {1.0, 3.0, 3.8, 5.0, 10.0}) {
    for (const double stiffness : {300.0, 800.0, 1000.0}) {
      DeviceLimits limits;
      limits.pushes = {true, true, true};
      limits.peak_force = peak;
      limits.stiffness = stiffness;
      const SceneOptions options = HeldBy(limits, SceneOptions{}, 0.05);
      EXPECT_NEAR(ForceBound(options, 0.05), peak, 1e-9 * peak);
      EXPECT_GE(CarriedPress(options.surface, TextureField()), 0.6 * peak) << stiffness;
      limits.pushes.z = false;
      EXPECT_NEAR(ForceBound(HeldBy(limits, SceneOptions{}, 0.05), 0.05, {.pushes_height = false}),
                  peak, 1e-9 * peak);
    }
  }
}

}  // namespace
}  // namespace moontrace
