#include "sim/physics/scene.h"

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

SceneOptions Direct() {
  SceneOptions options;
  options.rendering = Rendering::kDirect;
  return options;
}

TEST(Scene, ProxyRestsWhereCouplingAndPageBalance) {
  // springs in series: page k, coupling K, tip 1 mm below the paper
  SceneOptions options;
  options.surface.stiffness = 3000;
  Scene scene = Scene::Load("", options);
  const TickResult rest = Hold(scene, {0.05, 0.05, -0.001}, 1000);
  const double force = 0.001 * 3000 * 1000 / (3000 + 1000);
  // the slowest motion dies as exp(-100 t): nothing is left but rounding
  EXPECT_NEAR(rest.force_W.z, force, 1e-9);
  EXPECT_NEAR(rest.depth, force / 3000, 1e-12);
  EXPECT_NEAR(rest.page_force_P.z, 3000 * rest.depth, 1e-9);
  EXPECT_NEAR(rest.proxy_P.z, -rest.depth, 1e-12);
  EXPECT_NEAR(glm::length(glm::dvec2(rest.force_W)), 0, 1e-12);
}

TEST(Scene, AirGivesNoForceAndTheProxyHasNoWeight) {
  Scene scene = Scene::Load("", {});
  const TickResult rest = Hold(scene, {0.05, 0.05, 0.001}, 1000);
  EXPECT_EQ(rest.page_force_P, glm::dvec3(0, 0, 0));
  EXPECT_LT(rest.depth, 0);
  EXPECT_NEAR(glm::length(rest.force_W), 0, 1e-12);
  EXPECT_NEAR(glm::distance(rest.proxy_P, rest.tip_P), 0, 1e-15);
}

TEST(Scene, DirectForceIsThePagesAtTheTipInTheSameTick) {
  const TextureField field = GrooveAlongY();
  Scene scene = Scene::Load("", Direct());
  scene.SetField(&field);
  for (const double x : {-0.0006, -0.0002, 0.0, 0.0004, 0.002}) {
    const glm::dvec3 p{x, 0.01, -0.0008};
    const TickResult result = scene.Tick(TipAt(p));
    const Contact contact = Touch(scene.options().surface, field, p);
    EXPECT_EQ(result.force_P, contact.force_P) << x;
    EXPECT_EQ(result.depth, contact.depth) << x;
    EXPECT_EQ(result.proxy_P, result.tip_P) << x;
  }
}

TEST(Scene, GrooveHoldsTheProxyInItsMiddle) {
  const TextureField field = GrooveAlongY();
  Scene scene = Scene::Load("", {});
  scene.SetField(&field);
  Hold(scene, {0, 0.01, -0.002}, 500);
  const TickResult aside = Hold(scene, {0.0001, 0.01, -0.002}, 500);
  EXPECT_LT(aside.force_W.x, 0);  // back towards the spine
  EXPECT_EQ(aside.force_W.y, 0);
}

TEST(Scene, TiltRaisesTheFarEdgeAboutTheLowerOne) {
  SceneOptions options;
  options.tilt = 0.5;
  Scene scene = Scene::Load("", options);
  const Pose X_WP = scene.X_WP();
  EXPECT_NEAR(glm::length(X_WP.p), 0, 1e-12);  // the lower left corner stays
  const glm::dvec3 far = ToWorld(X_WP, {0, 0.1, 0});
  EXPECT_NEAR(far.y, 0.1 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(far.z, 0.1 * std::sin(0.5), 1e-12);
  const TickResult rest = Hold(scene, ToWorld(X_WP, {0.05, 0.1, -0.001}), 1000);
  EXPECT_NEAR(rest.force_P.z, 0.5, 1e-9);
  EXPECT_NEAR(rest.force_W.y, -0.5 * std::sin(0.5), 1e-9);
  EXPECT_NEAR(rest.force_W.z, 0.5 * std::cos(0.5), 1e-9);
}

TEST(Scene, PageFollowsAMocapBody) {
  const std::string xml =
      "<mujoco><custom><text name='moontrace:page' data='{}'/></custom><worldbody>"
      "<body name='board' mocap='true'><geom name='page' type='plane' size='1 1 1' contype='0' "
      "conaffinity='0'/></body></worldbody></mujoco>";
  Scene scene = Scene::FromXml(xml, "board", {});
  // the handle is one as well
  const mjModel* m = scene.model();
  const int board = m->body_mocapid[mj_name2id(m, mjOBJ_BODY, "board")];
  scene.data()->mocap_pos[3 * board + 2] = 0.3;
  EXPECT_NEAR(Hold(scene, {0, 0, 0.299}, 1000).force_W.z, 0.5, 1e-9);
  EXPECT_EQ(scene.X_WP().p.z, 0.3);
}

TEST(Scene, HandleStandsAtTheTip) {
  Scene scene = Scene::Load("", {});
  Hold(scene, {0.01, 0.02, 0.03}, 2);
  const int handle = mj_name2id(scene.model(), mjOBJ_BODY, "moontrace_handle");
  const mjtNum* p = scene.data()->xpos + 3 * handle;
  EXPECT_EQ(glm::dvec3(p[0], p[1], p[2]), glm::dvec3(0.01, 0.02, 0.03));
}

TEST(Scene, CallersForcesSurviveToTheBit) {
  const std::string xml =
      ModelWith("", "<body pos='1 0 0'><freejoint/><geom size='0.1' mass='1'/></body>");
  Scene scene = Scene::FromXml(xml, "ball", {});
  const auto nv = static_cast<std::size_t>(scene.model()->nv);
  ASSERT_EQ(nv, 6U + kInserted);
  std::vector<double> mine = {0.3, 0.7, -0.9, 0.0, 0.1, -0.0, 1e-310, 3.0, -7.25, 1e-17};
  std::copy(mine.begin(), mine.end(), scene.data()->qfrc_applied);
  Hold(scene, {0.03, 0.02, -0.002}, 10);
  EXPECT_EQ(std::memcmp(mine.data(), scene.data()->qfrc_applied, nv * sizeof(double)), 0);
  EXPECT_NE(scene.data()->qvel[kInserted + 3], 0);  // and they acted
}

/// A board of 0.5 kg that is a box, its upper face the page, at z = 0.
std::string BoardOn(const std::string& joint) {
  return "<mujoco><option gravity='0 0 0'/><custom><text name='moontrace:board' data='{}'/>"
         "</custom><worldbody><body name='board' pos='0 0 -0.01'>" +
         joint +
         "<geom name='board' type='box' size='0.2 0.15 0.01' mass='0.5' contype='0' "
         "conaffinity='0'/></body></worldbody></mujoco>";
}

TEST(Scene, MomentumChangesOnlyByTheHandsForce) {
  const TextureField field = GrooveAlongY();
  SceneOptions options;
  options.friction = 0.3;
  Scene scene = Scene::FromXml(BoardOn("<freejoint/>"), "board", options);
  scene.SetField(&field);
  const mjData* d = scene.data();
  glm::dvec3 before{0, 0, 0};
  double greatest = 0;
  for (int i = 0; i < 200; ++i) {
    const TickResult result = scene.Tick(TipAt({-0.002 + 2e-5 * i, 0.01, -0.002}));
    const glm::dvec3 after = 0.5 * glm::dvec3(d->qvel[4], d->qvel[5], d->qvel[6]) +
                             0.05 * glm::dvec3(d->qvel[0], d->qvel[1], d->qvel[2]);
    // device and proxy pull on each other: the device's force is what leaves the system
    EXPECT_NEAR(glm::length(after - before + 0.001 * result.force_W), 0, 1e-15) << i;
    greatest = std::max(greatest, glm::length(result.page_force_P));
    before = after;
  }
  EXPECT_GT(greatest, 0.1);  // the page was pushed
}

TEST(Scene, PageIsTurnedByTheForceAtThePointOfContact) {
  // one tick from rest: hinge speed = h * lever * force / inertia
  Scene scene = Scene::FromXml(BoardOn("<joint type='hinge' axis='1 0 0'/>"), "board", Direct());
  const glm::dvec3 tip{0.02, 0.04, -0.001};
  const TickResult result = scene.Tick(TipAt(tip));
  EXPECT_NEAR(result.page_force_P.z, 1.0, 1e-12);
  const double inertia = 0.5 / 3 * (0.15 * 0.15 + 0.01 * 0.01);
  EXPECT_NEAR(scene.data()->qvel[kInserted], -0.001 * tip.y * 1.0 / inertia, 1e-12);
}

TEST(Scene, OtherBodiesLiveOnAndChangeNothing) {
  const std::string ball =
      "<geom type='plane' size='1 1 1' pos='0 0 -0.5'/>"
      "<body name='ball' pos='0.05 0 -0.3'><freejoint/><geom size='0.05' mass='0.2'/></body>";
  Scene alone = Scene::FromXml(ModelWith("", ""), "alone", {});
  Scene among = Scene::FromXml(ModelWith("", ball), "among", {});
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 tip{1e-5 * i, 0, -0.001};
    const TickResult a = alone.Tick(TipAt(tip));
    const TickResult b = among.Tick(TipAt(tip));
    // MuJoCo's solver takes all bodies together and stops at its tolerance of 1e-8
    ASSERT_NEAR(glm::distance(a.force_W, b.force_W), 0, 1e-8) << i;
  }
  const int body = mj_name2id(among.model(), mjOBJ_BODY, "ball");
  EXPECT_NEAR(among.data()->xpos[3 * body + 2], -0.45, 0.002);  // MuJoCo's contacts are soft
  EXPECT_EQ(among.data()->ncon, 1);
}

TEST(Scene, SameInputsGiveTheSameBytesAndTwoScenesShareNothing) {
  const TextureField field = GrooveAlongY();
  const auto tip = [](int i, double phase) {
    return TipAt({0.001 * std::sin(0.05 * i + phase), 1e-5 * i, -0.001});
  };
  const auto run = [&](double phase) {
    Scene scene = Scene::Load("", {});
    scene.SetField(&field);
    std::vector<TickResult> results;
    for (int i = 0; i < 300; ++i) results.push_back(scene.Tick(tip(i, phase)));
    return results;
  };
  const std::vector<TickResult> alone = run(0.0);
  Scene a = Scene::Load("", {});
  Scene b = Scene::Load("", Direct());
  a.SetField(&field);
  b.SetField(&field);
  for (int i = 0; i < 300; ++i) {
    const TickResult again = a.Tick(tip(i, 0.0));
    b.Tick(tip(i, 1.0));
    const TickResult& first = alone[static_cast<std::size_t>(i)];
    ASSERT_EQ(std::memcmp(&again.force_W, &first.force_W, sizeof first.force_W), 0) << i;
    ASSERT_EQ(std::memcmp(&again.proxy_P, &first.proxy_P, sizeof first.proxy_P), 0) << i;
    ASSERT_EQ(again.energy_out, first.energy_out) << i;
  }
}

TEST(Scene, GoesOnFromAStateToTheBit) {
  const TextureField field = GrooveAlongY();
  SceneOptions options;
  options.friction = 0.2;
  const std::string xml =
      ModelWith("",
                "<geom type='plane' size='1 1 1' pos='0 0 -0.5'/>"
                "<body pos='0.05 0 -0.4'><freejoint/><geom size='0.05' mass='0.2'/></body>");
  Scene first = Scene::FromXml(xml, "first", options);
  Scene second = Scene::FromXml(first.model_xml(), "second", options);
  first.SetField(&field);
  second.SetField(&field);
  const auto tip = [](int i) { return TipAt({0.001 * std::sin(0.05 * i), 1e-5 * i, -0.001}); };
  for (int i = 0; i < 100; ++i) first.Tick(tip(i));
  second.SetState(first.State());
  for (int i = 100; i < 300; ++i) {
    const TickResult a = first.Tick(tip(i));
    const TickResult b = second.Tick(tip(i));
    ASSERT_EQ(std::memcmp(&a.force_W, &b.force_W, sizeof a.force_W), 0) << i;
    ASSERT_EQ(a.energy_out, b.energy_out) << i;
  }
  EXPECT_EQ(first.State(), second.State());
  EXPECT_TRUE(IsOneLine(ErrorOf([&] { second.SetState({1, 2, 3}); })));
}

TEST(SceneFault, BrokenInputGivesZeroForceAndTheNextTickIsGoodAgain) {
  for (const SceneOptions& options : {SceneOptions(), Direct()}) {
    Scene scene = Scene::Load("", options);
    Hold(scene, {0.05, 0.05, -0.001}, 200);
    for (const double bad : {kNan, std::numeric_limits<double>::infinity(), 1e300}) {
      const TickResult fault = scene.Tick(TipAt({0.05, bad, -0.001}));
      EXPECT_TRUE(fault.fault);
      EXPECT_EQ(fault.force_W, glm::dvec3(0, 0, 0));
      EXPECT_EQ(fault.force_P, glm::dvec3(0, 0, 0));
      EXPECT_NEAR(fault.proxy_P.z, -0.001, 1e-15);  // at the last good tip
    }
    DeviceState broken_velocity = TipAt({0.05, 0.05, -0.001});
    broken_velocity.velocity_known = true;
    broken_velocity.v_D.x = kNan;
    EXPECT_TRUE(scene.Tick(broken_velocity).fault);
    EXPECT_FALSE(scene.Tick(TipAt({0.05, 0.05, -0.001})).fault);
    const double rest = options.rendering == Rendering::kDirect ? 1.0 : 0.5;
    EXPECT_NEAR(Hold(scene, {0.05, 0.05, -0.001}, 1000).force_W.z, rest, 1e-9);
  }
}

// A wind in the model moves leaves, not the tip.
TEST(Scene, AirAndWindOfTheModelLeaveTheProxyAlone) {
  Scene still = Scene::FromXml(ModelWith("", ""), "still", {});
  Scene windy = Scene::FromXml(
      ModelWith("<option density='1000' viscosity='5' wind='9 3 -20'/>", ""), "windy", {});
  for (int i = 0; i < 300; ++i) {
    const DeviceState tip = TipAt({1e-5 * i, 0.01, 0.0005 - 1e-5 * i});
    const glm::dvec3 expected = still.Tick(tip).force_W;
    // the drag that is taken back is some 100 N: its rounding stays
    ASSERT_NEAR(glm::distance(windy.Tick(tip).force_W, expected), 0, 1e-9) << i;
  }
}

TEST(SceneFault, ForcesOfTheCallerOnTheProxyAreAFault) {
  Scene scene = Scene::Load("", {});
  EXPECT_FALSE(Hold(scene, {0.05, 0.05, -0.001}, 100).held);
  const int proxy = mj_name2id(scene.model(), mjOBJ_BODY, "moontrace_proxy");
  scene.data()->xfrc_applied[6 * proxy + 2] = -50;
  const TickResult pushed = Hold(scene, {0.05, 0.05, -0.001}, 100);
  EXPECT_TRUE(pushed.held && pushed.fault);
  EXPECT_EQ(pushed.force_W, glm::dvec3(0, 0, 0));
  scene.data()->xfrc_applied[6 * proxy + 2] = 0;
  EXPECT_NEAR(Hold(scene, {0.05, 0.05, -0.001}, 1000).force_W.z, 0.5, 1e-9);
}

TEST(SceneFault, NoticesThatMujocoResetItself) {
  const std::string xml =
      ModelWith("", "<body pos='1 0 0'><freejoint/><geom size='0.1' mass='1'/></body>");
  Scene scene = Scene::FromXml(xml, "ball", {});
  // from the very first tick, and again and again: a reset sets MuJoCo's own counters back
  for (int time = 0; time < 3; ++time) {
    scene.data()->qvel[kInserted] = kNan;
    const TickResult fault = scene.Tick(TipAt({0.05, 0.05, -0.001}));
    EXPECT_TRUE(fault.fault) << time;
    EXPECT_EQ(fault.force_W, glm::dvec3(0, 0, 0));
  }
  EXPECT_FALSE(scene.Tick(TipAt({0.05, 0.05, -0.001})).fault);
  EXPECT_NEAR(Hold(scene, {0.05, 0.05, -0.001}, 1000).force_W.z, 0.5, 1e-9);
}

TEST(Scene, FirstTickBringsTheProxyToTheTip) {
  Scene scene = Scene::Load("", {});
  scene.Reset({0, 0, 0.02});
  const TickResult first = scene.Tick(TipAt({0.15, 0.2, 0.001}));  // 25 cm from where it rested
  EXPECT_NEAR(glm::length(first.force_W), 0, 1e-12);
}

TEST(SceneSubsteps, AStiffPageIsSteppedFiner) {
  SceneOptions options;
  options.surface.stiffness = 200000;
  Scene scene = Scene::Load("", options);
  // h^2 (200000 + 1000) / 0.05 < 1 needs h < 0.499 ms
  EXPECT_EQ(scene.substeps(), 3);
  EXPECT_DOUBLE_EQ(scene.model()->opt.timestep, 0.001 / 3);
  EXPECT_FALSE(scene.remarks().empty());
  const TickResult rest = Hold(scene, {0.05, 0.05, -0.001}, 2000);
  EXPECT_NEAR(rest.force_W.z, 0.001 * 200000 * 1000 / 201000, 1e-9);
  EXPECT_NEAR(scene.data()->time, 2.0, 1e-9);
}

TEST(SceneSubsteps, ATooStiffPageIsRefusedWithTheNumbers) {
  SceneOptions options;
  options.surface.stiffness = 9e6;
  options.tick = 0.002;
  const std::string text = ErrorOf([&] { Scene::Load("", options); });
  EXPECT_TRUE(IsOneLine(text)) << text;
  EXPECT_TRUE(Holds(text, "50 g")) << text;
  EXPECT_TRUE(Holds(text, "9001000 N/m")) << text;
}

TEST(SceneOptions, ValuesOutOfRangeAreRefused) {
  for (const double bad : {kNan, -1.0, 1e300}) {
    SceneOptions options;
    options.surface.stiffness = bad;
    EXPECT_TRUE(IsOneLine(ErrorOf([&] { Scene::Load("", options); })));
    options = {};
    options.tick = bad;
    EXPECT_TRUE(IsOneLine(ErrorOf([&] { Scene::Load("", options); })));
  }
}

TEST(SceneFriction, TooHighForTheSlopeIsRefusedWithTheNumbers) {
  const TextureField field = GrooveAlongY();  // slope 0.7 / 0.42
  SceneOptions options;
  options.friction = 0.6;
  Scene scene = Scene::Load("", options);
  EXPECT_EQ(ErrorOf([&] { scene.SetField(&field); }),
            "friction 0.6 is too high for the slope 1.67: at most 0.53");
}

// What a device holds is known only once the model has been loaded: it must not be compiled again.
TEST(SceneOptionsChange, IsBitForBitALoadWithThem) {
  const TextureField field = GrooveAlongY();
  SceneOptions softer;
  softer.coupling_stiffness = 300;
  softer.coupling_damping = 4;
  softer.surface.force_cap = 0.7;
  Scene changed = Scene::Load("", {});
  changed.SetField(&field);
  for (int i = 0; i < 50; ++i) changed.Tick(TipAt({1e-5 * i, 0.01, -0.002}));
  changed.SetOptions(softer);
  Scene loaded = Scene::Load("", softer);
  EXPECT_EQ(changed.State(), loaded.State());
  EXPECT_EQ(changed.substeps(), loaded.substeps());
  EXPECT_EQ(changed.remarks(), loaded.remarks());
  for (Scene* scene : {&changed, &loaded}) scene->SetField(&field);
  for (int i = 0; i < 500; ++i) {
    const DeviceState tip = TipAt({1e-5 * i - 0.002, 0.01, -0.002});
    ASSERT_EQ(changed.Tick(tip).force_W, loaded.Tick(tip).force_W) << i;
  }
  EXPECT_EQ(changed.State(), loaded.State());
}

TEST(SceneOptionsChange, LeavesTickAndTiltAsTheyWereCompiled) {
  SceneOptions options;
  options.tick = 0.0005;
  options.tilt = 0.2;
  Scene scene = Scene::Load("", options);
  const Pose X_WP = scene.X_WP();
  scene.SetOptions({});
  EXPECT_EQ(scene.options().tick, 0.0005);
  EXPECT_EQ(scene.options().tilt, 0.2);
  EXPECT_EQ(scene.X_WP().R, X_WP.R);
}

TEST(SceneFriction, SlidingOnPaperCostsMuTimesThePress) {
  SceneOptions options;
  options.friction = 0.3;
  Scene scene = Scene::Load("", options);
  TickResult result;
  for (int i = 0; i < 3000; ++i) result = scene.Tick(TipAt({2e-5 * i, 0.05, -0.001}));
  EXPECT_NEAR(result.force_W.z, 0.5, 1e-9);
  EXPECT_NEAR(result.force_W.x, -0.3 * 0.5, 1e-6);  // steady after 3 s
}

TEST(SceneEnergy, IsBoundedForASlowPressAndSlide) {
  const TextureField field = GrooveAlongY();
  Scene scene = Scene::Load("", {});
  scene.SetField(&field);
  TickResult result;
  for (int i = 0; i < 10000; ++i) {
    const double t = 0.001 * i;
    const double press = std::min(0.001, 0.002 * t);
    result = scene.Tick(TipAt({0.003 * std::sin(3 * t), 0.01, 0.0002 - press}));
  }
  // 1 uJ: a thousandth of the 1 mJ that the springs hold meanwhile
  EXPECT_LT(result.energy_out, 1e-6);
}

TEST(SceneEnergy, GrowsAsSampledSpringsDoInUndampedDirectRendering) {
  // A tip that swings y = A sin(2 pi n / N) within a held spring k gains k/2 (y' - y)^2 a tick:
  // k A^2 N sin^2(pi / N) a swing.
  SceneOptions options = Direct();
  options.surface.stiffness = 20000;
  options.surface.force_cap = 100;
  Scene scene = Scene::Load("", options);
  constexpr int kN = 200;
  const double A = 0.0005;
  const double half = std::sin(M_PI / kN);
  const double a_swing = 20000 * A * A * kN * half * half;
  for (const int swings : {1, 10, 20}) {
    scene.Reset({0, 0, 0});
    TickResult result;
    for (int i = 0; i <= swings * kN; ++i) {
      result = scene.Tick(TipAt({0.05, 0.05, -0.001 + A * std::sin(2 * M_PI * i / kN)}));
    }
    EXPECT_NEAR(result.energy_out, swings * a_swing, 1e-9) << swings;
  }
}

TEST(SceneEnergy, SameSwingThroughTheCouplingCreatesNone) {
  Scene scene = Scene::Load("", {});
  TickResult result;
  for (int i = 0; i <= 4000; ++i) {
    result = scene.Tick(TipAt({0.05, 0.05, -0.001 + 0.0005 * std::sin(2 * M_PI * i / 200)}));
  }
  EXPECT_LT(result.energy_out, 1e-6);
}

}  // namespace
}  // namespace moontrace
