#include "sim/physics/unlabelled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sim/physics/mujoco_compat.h"
#include "sim/physics/scene.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

// The label is on `sign`; beside it, tops at z = 0: `block` rests, `crate` floats, `ghost` is only
// seen, and has a collider of its own; `mesh` has no chart.
constexpr const char* kModel = R"(
<mujoco>
  <option gravity="0 0 0" timestep="0.001"/>
  <custom><text name="moontrace:sign" data="{middle_mm=[0,0]}"/></custom>
  <asset><mesh name="m" vertex="0 0 0 .01 0 0 0 .01 0 0 0 .01"/></asset>
  <worldbody>
    <geom name="sign" type="box" size="0.02 0.02 0.02" pos="0 0 -0.02"/>
    <geom name="block" type="box" size="0.02 0.02 0.02" pos="0.1 0 -0.02"/>
    <geom name="rock" type="mesh" mesh="m" pos="0.4 0 0"/>
    <body pos="0.2 0 -0.02"><freejoint/>
      <geom name="crate" type="box" size="0.02 0.02 0.02" mass="0.3"/></body>
    <body pos="0.3 0 -0.02">
      <geom name="ghost" type="sphere" size="0.025" contype="0" conaffinity="0"/>
      <geom name="collider" type="box" size="0.02 0.02 0.02"/></body>
  </worldbody>
</mujoco>)";

Scene With(Unlabelled unlabelled, const char* xml = kModel) {
  SceneOptions options;
  options.unlabelled = unlabelled;
  return Scene::FromXml(xml, "model", options);
}

/// Of a tip that has come down there, 1 mm below z = 0, at 50 mm/s.
TickResult PressedAt(Scene& scene, glm::dvec2 at, double depth = 0.001) {
  for (double z = 0.005; z > -depth; z -= 5e-5) scene.Tick(TipAt({at, z}));
  return Hold(scene, {at, -depth}, 500);
}

std::string Touched(const Scene& scene, const TickResult& felt) {
  return felt.geom < 0 ? "" : mj_id2name(scene.model(), mjOBJ_GEOM, felt.geom);
}

TEST(Unlabelled, IsNothingAtFirst) {
  Scene scene = With(Unlabelled::kNothing);
  EXPECT_NEAR(glm::length(PressedAt(scene, {0.1, 0}).force_W), 0, 1e-9);
}

// The page and the coupling, 1000 N/m each, one behind the other.
TEST(Unlabelled, IsFeltPlainWhereItCollides) {
  Scene scene = With(Unlabelled::kPlain);
  std::string felt;
  for (const Label& label : scene.labels()) felt += label.geom + (label.implied ? "+ " : " ");
  EXPECT_EQ(felt, "sign block+ crate+ collider+ ");
  for (const double x : {0.0, 0.1, 0.3}) {
    const TickResult pressed = PressedAt(scene, {x, 0});
    EXPECT_NEAR(pressed.force_W.z, 0.5, 1e-6) << x;
    EXPECT_EQ(Touched(scene, pressed), x == 0 ? "sign" : x == 0.1 ? "block" : "collider");
  }
  for (const std::string& remark : scene.remarks()) {
    EXPECT_EQ(remark.find("labels in the model"), std::string::npos) << remark;
  }
}

// What is seen is felt where nothing of the model collides.
TEST(Unlabelled, IsFeltPlainWhereItIsOnlySeen) {
  std::string xml = kModel;
  for (std::size_t at = 0; (at = xml.find("<geom ", at)) != std::string::npos; at += 6) {
    xml.insert(at + 6, xml.compare(at, 18, "<geom name=\"ghost\"") == 0
                           ? ""
                           : "contype='0' conaffinity='0' ");
  }
  Scene scene = With(Unlabelled::kPlain, xml.c_str());
  EXPECT_EQ(scene.labels().size(), 5U);
  EXPECT_NEAR(PressedAt(scene, {0.1, 0}).force_W.z, 0.5, 1e-6);
}

// Pressed 20 mm into what rests the coupling would pull with 20 N.
TEST(Unlabelled, MujocosOwnContactsNeverGiveMoreThanTheCap) {
  Scene scene = With(Unlabelled::kContacts);
  double most = 0, step = 0, last = 0;
  for (int i = 0; i < 1600; ++i) {
    // down to 20 mm in 0.5 s, and up again
    const double z = 0.005 - 5e-5 * (i < 500 ? i : i < 1000 ? 500 : 1500 - i);
    const TickResult felt = scene.Tick(TipAt({0.1, 0, std::min(z, 0.02)}));
    ASSERT_FALSE(felt.fault) << i;
    ASSERT_FALSE(felt.held) << i;
    const double force = glm::length(felt.force_W);
    most = std::max(most, force);
    if (i > 1000) step = std::max(step, std::abs(force - last));
    last = force;
    if (i == 999) {
      EXPECT_EQ(Touched(scene, felt), "block");
      EXPECT_NEAR(felt.force_W.z, 4, 1e-9);
    }
  }
  EXPECT_LE(most, 4 + 1e-12);
  EXPECT_LT(step, 0.3);  // no snap on the way back
  EXPECT_NEAR(last, 0, 1e-3);
}

// What the hand gives is what crate and proxy get; MuJoCo's soft contact keeps it.
TEST(Unlabelled, ContactsPushWhatFloatsAsTheHandDoes) {
  Scene scene = With(Unlabelled::kContacts);
  glm::dvec3 given(0), felt_last(0);
  for (int i = 0; i < 400; ++i) {
    const TickResult felt = scene.Tick(TipAt({0.2, 0, 0.003 - 2e-5 * i}));
    given -= 1e-3 * felt.force_W;
    felt_last = felt.force_W;
  }
  const mjModel& m = *scene.model();
  const mjData& d = *scene.data();
  const int crate = m.body_dofadr[m.geom_bodyid[mj_name2id(&m, mjOBJ_GEOM, "crate")]];
  const int proxy = m.body_dofadr[mj_name2id(&m, mjOBJ_BODY, "moontrace_proxy")];
  const double momentum = 0.3 * d.qvel[crate + 2] + scene.proxy_mass() * d.qvel[proxy + 2];
  EXPECT_LT(d.qvel[crate + 2], -0.01);
  EXPECT_NEAR(momentum, given.z, 1e-6 + 1e-3 * std::abs(felt_last.z));  // less the tick under way
}

// A label is felt as ever: the proxy does not collide with what carries one.
TEST(Unlabelled, LabelsDoNotCollide) {
  Scene plain = With(Unlabelled::kNothing), colliding = With(Unlabelled::kContacts);
  EXPECT_EQ(PressedAt(plain, {0.003, 0.002}).force_W, PressedAt(colliding, {0.003, 0.002}).force_W);
}

TEST(Unlabelled, AModelThatUsesAllBitsIsRefused) {
  std::string xml = kModel;
  xml.insert(xml.find("name=\"block\""), "contype='2147483647' ");
  const std::string error = ErrorOf([&] { With(Unlabelled::kContacts, xml.c_str()); });
  EXPECT_TRUE(IsOneLine(error));
  EXPECT_TRUE(Holds(error, "model: every bit of contype")) << error;
  SceneOptions direct;
  direct.unlabelled = Unlabelled::kContacts;
  direct.rendering = Rendering::kDirect;
  EXPECT_TRUE(IsOneLine(ErrorOf([&] { Scene::FromXml(kModel, "model", direct); })));
}

// Far from the tip nothing changes.
TEST(Unlabelled, WithoutTouchTheModelMovesAsByItself) {
  std::string xml = kModel;
  xml.replace(xml.find("0 0 0\" timestep"), 5, "0 0 -9.81");
  xml.insert(xml.find("<body pos=\"0.2"), "<geom type='plane' size='1 1 1' pos='0 0 -0.1'/>");
  std::string warning;
  const ModelPtr m = CompileMjcf(xml, "theirs.xml", "theirs", warning);
  for (const Unlabelled unlabelled :
       {Unlabelled::kNothing, Unlabelled::kPlain, Unlabelled::kContacts}) {
    const DataPtr d = MakeData(*m, "theirs");
    Scene scene = With(unlabelled, xml.c_str());
    for (int i = 0; i < 3000; ++i) {
      mj_step(m.get(), d.get());
      scene.Tick(TipAt({0, 0, 0.3 + 1e-3 * std::sin(0.1 * i)}));
      ASSERT_TRUE(std::equal(d->qpos, d->qpos + m->nq, scene.data()->qpos + kInserted))
          << static_cast<int>(unlabelled) << " " << i << " " << d->ncon << " "
          << scene.data()->ncon;
    }
    EXPECT_GT(d->ncon, 0);
  }
}

}  // namespace
}  // namespace moontrace
