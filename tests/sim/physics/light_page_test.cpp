// Pages that a touch can move: energy is only exchanged, however light the page is.
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

/// A sheet of that mass, 100 by 100 by 2 mm, its upper face at height zero, without weight.
std::string Sheet(double mass, const std::string& joint) {
  return fmt::format(
      "<mujoco><option gravity='0 0 0' density='0'/>"
      "<custom><text name='moontrace:sheet' data='{{}}'/></custom><worldbody>"
      "<body pos='0 0 -0.001'>{}<geom name='sheet' type='box' size='0.05 0.05 0.001' mass='{}' "
      "contype='0' conaffinity='0'/></body></worldbody></mujoco>",
      joint, mass);
}

/// Motion of the page's body [J].
double KineticEnergy(Scene& scene) {
  const mjModel& m = *scene.model();
  const mjData& d = *scene.data();
  const auto nv = static_cast<std::size_t>(m.nv);
  std::vector<mjtNum> M(nv * nv), momentum(nv);
  mj_fullM(&m, M.data(), d.qM);
  mju_mulMatVec(momentum.data(), M.data(), d.qvel, m.nv, m.nv);
  return 0.5 * mju_dot(d.qvel, momentum.data(), m.nv);
}

struct Balance {
  double gained = 0;     ///< energy at the end less what the hand put in [J]
  double exchanged = 0;  ///< sum of what went either way [J]
};

/// A tip strokes over the sheet, along and across its groove, then lifts, so that no spring holds
/// anything at the end: what is left is motion of sheet and proxy.
Balance Stroke(double mass, const std::string& joint, const SceneOptions& options) {
  const TextureField field = GrooveAlongY();
  Scene scene = Scene::FromXml(Sheet(mass, joint), "sheet", options);
  scene.SetField(&field);
  scene.Reset({-0.002, 0.01, 0.0005});
  Balance balance;
  double work = 0;
  glm::dvec3 last(-0.002, 0.01, 0.0005);
  for (int i = 0; i < 400; ++i) {
    const double t = 0.001 * i;
    const glm::dvec3 p(-0.002 + 0.01 * t, 0.01 + 0.02 * t,
                       i < 200 ? 0.0005 - 0.0012 * std::sin(15.7 * t) : 0.0005 + 0.2 * (t - 0.2));
    const TickResult result = scene.Tick(TipAt(p));
    if (result.fault) return {INFINITY, 0};
    // the hand works against the force on the device
    const double done = -glm::dot(result.force_W, p - last);
    work += done;
    balance.exchanged += std::abs(done);
    last = p;
  }
  EXPECT_LE(Hold(scene, last, 100).depth, 0);
  balance.gained = KineticEnergy(scene) - work;
  return balance;
}

TEST(LightPage, GainsNothingThatTheHandDidNotPutIn) {
  for (const double mass : {0.001, 0.002, 0.005, 0.02, 0.1}) {
    for (const char* joint : {"<freejoint/>", "<joint type='slide' axis='0 0 1'/>"}) {
      const Balance balance = Stroke(mass, joint, {});
      EXPECT_GT(balance.exchanged, 1e-6);
      // the coupling's damper takes some: only a gain is a fault
      EXPECT_LT(balance.gained, 0.01 * balance.exchanged + 1e-6) << mass << joint;
    }
  }
}

TEST(LightPage, TooLightForAnyStepIsRefusedInWords) {
  const TextureField field = GrooveAlongY();
  const std::string text = ErrorOf([&] {
    Scene scene = Scene::FromXml(Sheet(0.00001, "<freejoint/>"), "sheet", {});
    scene.SetField(&field);
  });
  EXPECT_TRUE(IsOneLine(text)) << text;
  EXPECT_TRUE(Holds(text, "the page's body is too light")) << text;
}

}  // namespace
}  // namespace moontrace
