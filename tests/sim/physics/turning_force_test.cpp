// A line rule turns a pushed tip back below the force that the program states, and lets it pass
// above: in MuJoCo, with the proxy and its coupling as the hand.
#include <gtest/gtest.h>

#include <glm/vec3.hpp>
#include <string>

#include "tests/sim/scene_fixture.h"
#include "textures/typeset/rules.h"

namespace moontrace {
namespace {

/// The rule of 10 mm letters: a tenth of the size wide, a quarter of that high.
constexpr Profile kRule{1e-3, 0.25e-3, 0.2e-3};

/// Pushes the tip with a slowly rising force along x from the foot of a ridge along y, pressed down
/// with `press` [N]; where it is after the push was held for a second [m].
double PushedTo(double push, double press) {
  Group ridge;
  ridge.elements.push_back({Line{{0, -0.05}, {0, 0.05}}, kRule});
  Texture texture;
  texture.layers.push_back({Finish(std::move(ridge)), Relief::kEmbossed});
  const TextureField field(texture);
  const SceneOptions options;
  Scene scene = Scene::FromXml(ModelWith("", ""), "ridge", options);
  scene.SetField(&field);
  const double k = options.coupling_stiffness, foot = -0.5 * kRule.width;
  // the coupling is stretched by push and press; its far end follows the tip slowly, so that its
  // damper still acts on the tip
  constexpr double kRise = 4, kHold = 1, kTick = 1e-3, kFollow = 0.05;  // [s]
  glm::dvec3 hand(foot, 0, -press / k);
  scene.Reset({foot, 0, 0});
  TickResult result = Hold(scene, hand, 200);
  for (double time = 0; time < kRise + kHold; time += kTick) {
    const double now = push * std::min(1.0, time / kRise);
    const glm::dvec3 wanted = result.proxy_P + glm::dvec3(now, 0, -press) / k;
    hand += kTick / kFollow * (wanted - hand);
    hand.y = 0;
    result = scene.Tick(TipAt(hand));
  }
  EXPECT_FALSE(result.fault);
  return result.proxy_P.x;
}

// Five percent: the push rises over 4 s and the hand's end lags by 50 ms behind a tip that climbs
// 0.2 mm of rim in that time, 0.003 N of the 0.25 N at the light press; the rest is room for the
// tip's swinging, which the damper ends.
TEST(TurningBack, HappensBelowTheStatedForceAndNotAbove) {
  for (const double press : {0.3, 1.0}) {
    const double force = TurningForce(kRule, press);
    const double below = PushedTo(0.95 * force, press);
    EXPECT_LT(below, -kRule.rounding) << "passed at press " << press;
    EXPECT_GT(below, -0.5 * kRule.width) << "never met the ridge at press " << press;
    EXPECT_GT(PushedTo(1.05 * force, press), 0.5 * kRule.width) << "held at press " << press;
  }
}

}  // namespace
}  // namespace moontrace
