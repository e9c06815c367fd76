// Labels on geoms of every kind, in MuJoCo: what the tip feels there, and what it does to them.
#include "sim/physics/felt_object.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "sim/physics/mujoco_compat.h"
#include "tests/sim/scene_fixture.h"

namespace moontrace {
namespace {

struct Kind {
  const char* type;
  const char* size;
  double height;  ///< of its highest point over its middle [m]
};
const std::vector<Kind> kKinds = {{"box", "0.04 0.03 0.02", 0.02},
                                  {"sphere", "0.04", 0.04},
                                  {"cylinder", "0.04 0.03", 0.03},
                                  {"capsule", "0.03 0.02", 0.05},
                                  {"ellipsoid", "0.05 0.04 0.03", 0.03}};

/// A geom of that kind with a label, its body at the origin on `joint`, with a mass off its middle.
std::string ModelOf(const Kind& kind, const std::string& joint) {
  return fmt::format(
      "<mujoco><option gravity='0 0 0' density='0'/>"
      "<custom><text name='moontrace:it' data='{{middle_mm=[0,0]}}'/></custom><worldbody>"
      "<body>{}<geom name='it' type='{}' size='{}' mass='0.3' contype='0' conaffinity='0'/>"
      "<geom type='box' size='0.01 0.02 0.005' pos='0.03 0.02 0' mass='0.2' contype='0' "
      "conaffinity='0'/></body></worldbody></mujoco>",
      joint, kind.type, kind.size);
}

SceneOptions WithRendering(Rendering rendering) {
  SceneOptions options;
  options.rendering = rendering;
  options.friction = 0.2;
  return options;
}

TEST(FeltObject, IsASpringTowardsItsNearestSurface) {
  for (const Kind& kind : kKinds) {
    Scene scene = Scene::FromXml(ModelOf(kind, ""), kind.type, {});
    // proxy and coupling are springs in series, of 1000 N/m each
    const TickResult above = Hold(scene, {0, 0, kind.height - 0.002}, 3000);
    EXPECT_NEAR(above.force_W.z, 1.0, 1e-6) << kind.type;
    EXPECT_NEAR(std::hypot(above.force_W.x, above.force_W.y), 0, 1e-9) << kind.type;
    EXPECT_GT(above.depth, 0);
    EXPECT_EQ(Hold(scene, {0, 0, kind.height + 0.002}, 500).depth > 0, false);
    EXPECT_NEAR(glm::length(Hold(scene, {0, 0, kind.height + 0.002}, 3000).force_W), 0, 1e-9);
  }
}

/// Momentum of everything that floats, linear and about the world's origin: the model's bodies by
/// MuJoCo's own sums, the proxy among them where it has a mass that moves by itself.
struct Momentum {
  glm::dvec3 linear{0, 0, 0}, angular{0, 0, 0};
};
Momentum MomentumOf(Scene& scene, bool proxy_too) {
  const mjModel& m = *scene.model();
  // on a copy, since what a step left stays
  mjData* d = mj_copyData(nullptr, &m, scene.data());
  mj_forward(&m, d);
  Momentum sum;
  for (int body = 1; body < m.nbody; ++body) {
    const bool proxy = body == mj_name2id(&m, mjOBJ_BODY, "moontrace_proxy");
    if (m.body_weldid[body] == 0 || (proxy && !proxy_too)) continue;
    mjtNum velocity[6];  // turning, then moving of the centre of mass, in the world's axes
    mj_objectVelocity(&m, d, mjOBJ_BODY, body, velocity, 0);
    const glm::dvec3 w(velocity[0], velocity[1], velocity[2]);
    const glm::dvec3 v(velocity[3], velocity[4], velocity[5]);
    const mjtNum* c = d->xipos + 3 * body;
    const glm::dvec3 centre(c[0], c[1], c[2]);
    const mjtNum* R = d->ximat + 9 * body;
    const glm::dmat3 axes(R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]);
    const mjtNum* I = m.body_inertia + 3 * body;
    const glm::dvec3 spin = axes * (glm::dvec3(I[0], I[1], I[2]) * (w * axes));
    const double mass = m.body_mass[body];
    sum.linear += mass * v;
    sum.angular += spin + glm::cross(centre, mass * v);
  }
  mj_deleteData(d);
  return sum;
}

/// The proxy's place now; its slides are the world's axes.
glm::dvec3 ProxyIn(Scene& scene) {
  const mjModel& m = *scene.model();
  const int body = mj_name2id(&m, mjOBJ_BODY, "moontrace_proxy");
  const mjtNum* p = m.body_pos + 3 * body;
  const mjtNum* q = scene.data()->qpos + m.jnt_qposadr[m.body_jntadr[body]];
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}

// What the hand gives is all that changes momentum. The device's force acts where proxy and handle
// are joined: at the proxy, in direct rendering at the tip. The angular sum needs the proxy's place
// at each step, so a tick is one step there.
TEST(FeltObject, ThatFloatsTakesExactlyTheImpulseOfTheHand) {
  const TextureField field = GrooveAlongY();
  for (const Rendering rendering : {Rendering::kProxy, Rendering::kDirect}) {
    for (const Kind& kind : kKinds) {
      for (const double tick : {1e-3, 1e-4}) {
        SceneOptions options = WithRendering(rendering);
        options.tick = tick;
        Scene scene = Scene::FromXml(ModelOf(kind, "<freejoint/>"), kind.type, options);
        scene.SetField(&field);
        const bool proxy = rendering == Rendering::kProxy;
        const bool one_step = scene.substeps() == 1;
        ASSERT_TRUE(one_step || tick > 1e-4) << kind.type;
        const glm::dvec3 start(0.006, 0.004, kind.height - 0.002);
        const int ticks = static_cast<int>(std::lround(0.06 / tick));
        for (int i = 0; i < ticks / 3; ++i) scene.Tick(TipAt(start));
        mjData& d = *scene.data();
        mjtNum* spin = d.qvel + scene.model()->nv - 3;
        spin[0] += 0.4;  // turning as well
        spin[2] += 0.7;
        const Momentum first = MomentumOf(scene, proxy);
        Momentum given;
        double exchanged = 0, turned = 0;
        for (int i = 0; i < ticks; ++i) {
          const double ms = 1e3 * tick * i;
          const glm::dvec3 tip =
              start + glm::dvec3(2e-5 * ms, 1e-5 * ms, -6e-5 * ms - 3e-6 * ms * ms);
          const glm::dvec3 at = proxy ? ProxyIn(scene) : tip;
          const TickResult felt = scene.Tick(TipAt(tip));
          ASSERT_FALSE(felt.fault);
          ASSERT_GT(felt.depth, 0) << kind.type << proxy << i;  // alone it drifts as MuJoCo has it
          given.linear -= tick * felt.force_W;
          given.angular -= tick * glm::cross(at, felt.force_W);
          exchanged += tick * glm::length(felt.force_W);
          turned += tick * glm::length(glm::cross(at, felt.force_W));
        }
        ASSERT_GT(exchanged, 1e-3) << kind.type;
        const Momentum last = MomentumOf(scene, proxy);
        EXPECT_LT(glm::distance(last.linear - first.linear, given.linear), 1e-6 * exchanged)
            << kind.type << proxy;
        if (proxy && !one_step) continue;
        EXPECT_LT(glm::distance(last.angular - first.angular, given.angular),
                  1e-6 * (glm::length(first.angular) + turned))
            << kind.type << proxy << tick;
      }
    }
  }
}

const char kTwoThings[] =
    "<mujoco><option gravity='0 0 0'/><custom>"
    "<text name='moontrace:cup' data=\"{face='round', turn_deg=90}\"/>"
    "<text name='moontrace:cup:2' data=\"{face='top'}\"/>"
    "<text name='moontrace:ball' data='{}'/>"
    "</custom><worldbody>"
    "<geom name='cup' type='cylinder' size='0.04 0.05' contype='0' conaffinity='0'/>"
    "<body name='ball' pos='0.2 0 0'><freejoint/>"
    "<geom name='ball' type='sphere' size='0.05' mass='0.4' contype='0' conaffinity='0'/></body>"
    "</worldbody></mujoco>";

TEST(FeltObject, EachLabelIsFeltWhereItLies) {
  const auto field = std::make_shared<const TextureField>(GrooveAlongY());
  SceneOptions options;
  options.rendering = Rendering::kDirect;
  Scene scene = Scene::FromXml(kTwoThings, "two", options);
  ASSERT_EQ(scene.labels().size(), 3u);
  // blank: a smooth side
  EXPECT_NEAR(scene.Tick(TipAt({0, -0.039, 0})).force_W.y, -1, 1e-9);
  scene.SetField(field.get());  // the first: turned, so that its groove lies around
  scene.SetLabel({1, field, {}});
  // in the groove's middle, 0.3 mm above its floor and 0.3 below the side: nothing
  EXPECT_EQ(scene.Tick(TipAt({0, -0.0397, 0})).depth > 0, false);
  EXPECT_EQ(scene.Tick(TipAt({0.0397 * std::sin(0.7), -0.0397 * std::cos(0.7), 0})).depth > 0,
            false);
  EXPECT_GT(scene.Tick(TipAt({0, -0.0397, 0.002})).depth, 0.00029);
  // on the top the groove lies along y
  EXPECT_EQ(scene.Tick(TipAt({0, 0.01, 0.0497})).depth > 0, false);
  EXPECT_GT(scene.Tick(TipAt({0.003, 0.01, 0.0497})).depth, 0.00029);
  // the ball is blank and can be pushed
  EXPECT_NEAR(scene.Tick(TipAt({0.2, 0, 0.049})).force_W.z, 1, 1e-3);
  EXPECT_LT(scene.data()->qvel[2], 0);
}

/// A plate of a millimetre and five grams on a stiff spring, its upper face at zero.
constexpr const char* kLightPlate =
    "<mujoco><option gravity='0 0 0'/><custom><text name='moontrace:plate' data='{}'/></custom>"
    "<worldbody><body><joint type='slide' axis='0 0 1' stiffness='100000' damping='5'/>"
    "<geom name='plate' type='box' size='0.06 0.03 0.0005' pos='0 0 -0.0005' mass='0.005' "
    "contype='0' conaffinity='0'/></body></worldbody></mujoco>";

// Pressed 2.5 mm beyond its back, the plate is still what moves: the tick is not made coarser.
TEST(FeltObject, ALightThinPlateTakesItsSubStepsAlsoBehindIt) {
  Scene scene = Scene::FromXml(kLightPlate, "plate", WithRendering(Rendering::kDirect));
  ASSERT_GT(scene.substeps(), 1);
  scene.Tick(TipAt({0.01, 0.01, 0.0005}));
  EXPECT_GT(scene.Tick(TipAt({0.01, 0.01, -0.0035})).force_W.z, 0);
  EXPECT_GT(scene.Tick(TipAt({0.01, 0.01, -0.0035})).force_W.z, 0);
  EXPECT_EQ(scene.model()->opt.timestep, scene.options().tick / scene.substeps());
}

TEST(FeltObject, AfterAFaultAThinPlateIsFeltFromWhereTheTipComesBack) {
  Scene scene = Scene::FromXml(kLightPlate, "plate", WithRendering(Rendering::kDirect));
  scene.Tick(TipAt({0.01, 0.01, 0.0005}));
  EXPECT_TRUE(scene.Tick(TipAt({NAN, 0, 0})).fault);
  scene.Tick(TipAt({0.01, 0.01, -0.002}));
  EXPECT_EQ(scene.Tick(TipAt({0.01, 0.01, -0.002})).force_W, glm::dvec3(0));
  EXPECT_LT(scene.Tick(TipAt({0.01, 0.01, -0.0008})).force_W.z, 0);
}

TEST(FeltObject, ARoundPagesFrameIsExactAtTheTip) {
  Scene scene = Scene::FromXml(kTwoThings, "two", {});
  const glm::dvec3 p_P(0.02, 0.01, 0.003);
  const PagePoint point = scene.PointOn(p_P);
  EXPECT_NEAR(glm::distance(point.p_W, glm::dvec3(0.043 * std::sin(-0.01 / 0.04),
                                                  -0.043 * std::cos(-0.01 / 0.04), 0.02)),
              0, 1e-12);
  const TickResult felt = scene.Tick(TipAt(point.p_W));
  EXPECT_NEAR(glm::distance(felt.tip_P, p_P), 0, 1e-12);
  EXPECT_NEAR(glm::distance(FromWorld(scene.X_WP(), point.p_W), p_P), 0, 1e-12);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = 1e-6;
    const glm::dvec3 slope = (scene.PointOn(p_P + step).p_W - scene.PointOn(p_P - step).p_W) / 2e-6;
    EXPECT_NEAR(glm::distance(slope, point.moves[axis]), 0, 1e-8);
  }
}

TEST(FeltObject, StateGoesOnFromWhereItWas) {
  const std::string plate =
      "<mujoco><custom><text name='moontrace:plate' data='{}'/></custom><worldbody>"
      "<geom name='plate' type='box' size='0.05 0.05 0.001'/></worldbody></mujoco>";
  const auto tip = [](int i) { return TipAt({0.001, 0.002, 0.002 - 2e-5 * i}); };
  Scene scene = Scene::FromXml(plate, "plate", {});
  for (int i = 0; i < 150; ++i) scene.Tick(tip(i));
  Scene again = Scene::FromXml(plate, "plate", {});
  again.SetState(scene.State());
  for (int i = 150; i < 250; ++i) {
    const TickResult a = scene.Tick(tip(i)), b = again.Tick(tip(i));
    EXPECT_EQ(a.force_W, b.force_W) << i;
    EXPECT_GT(a.force_W.z, 0) << i;  // from above, though the lower face is nearer at last
  }
}

/// A body on a hinge with a motor, a spring, a limit, friction and a sensor, one that rests on the
/// floor, some that fall on it: what people have. ATTRIBUTES are of <option>, MORE of the world.
const char kTheirs[] =
    "<mujoco><option timestep='0.001' ATTRIBUTES/><custom>"
    "<text name='moontrace:lid' data='{}'/><text name='moontrace:can' data='{}'/></custom>"
    "<worldbody><geom type='plane' size='1 1 0.1' pos='0 0 -0.2'/>"
    "<body pos='0 0 0.1'><joint name='hinge' type='hinge' axis='0 1 0' damping='0.01' "
    "stiffness='0.3' frictionloss='0.01' limited='true' range='-20 20'/>"
    "<geom name='lid' type='box' size='0.1 0.05 0.004' pos='0.1 0 0' mass='0.2'/>"
    "</body><body pos='0.5 0 -0.148'><freejoint/>"
    "<geom name='can' type='cylinder' size='0.03 0.05' mass='0.3'/></body>MORE</worldbody>"
    "<actuator><motor joint='hinge' gear='0.2'/></actuator>"
    "<sensor><jointpos joint='hinge'/><subtreecom body='last'/></sensor></mujoco>";

std::string Theirs(const std::string& attributes, int boxes) {
  std::string more;
  for (int i = 0; i < boxes; ++i) {
    more += "<body name='" + std::string(i + 1 == boxes ? "last" : "box" + std::to_string(i)) +
            "' pos='" + std::to_string(0.3 + 0.11 * (i % 4)) + " 0.2 " +
            std::to_string(0.1 * (i / 4) - 0.14) +
            "' euler='10 20 30'><freejoint/><geom type='box' size='0.05 0.04 0.03' mass='0.1'/>"
            "<body pos='0 0 0.05'><joint type='hinge' axis='1 0 0' damping='0.001'/>"
            "<geom type='sphere' size='0.02' mass='0.02'/></body></body>";
  }
  std::string xml = kTheirs;
  xml.replace(xml.find("ATTRIBUTES"), 10, attributes);
  return xml.replace(xml.find("MORE"), 4, more);
}

/// Steps `xml` by MuJoCo alone beside a scene of it whose tip moves far away, as long as bits
/// agree: how many steps that was, at most 1500.
int StepsAlike(const std::string& xml) {
  std::string warning;
  const ModelPtr m = CompileMjcf(xml, "theirs.xml", "theirs", warning);
  const DataPtr d = MakeData(*m, "theirs");
  Scene scene = Scene::FromXml(xml, "theirs", {});
  // their joints come behind those of the proxy
  const auto before_q = scene.model()->nq - m->nq, before_v = scene.model()->nv - m->nv;
  int contacts = 0;
  for (int i = 0; i < 1500; ++i) {
    d->ctrl[0] = scene.data()->ctrl[0] = std::sin(0.01 * i);
    mj_step(m.get(), d.get());
    scene.Tick(TipAt({0.3, 0.3 + 0.01 * std::sin(0.02 * i), 0.9}));
    contacts = std::max(contacts, static_cast<int>(d->ncon));
    const mjData& other = *scene.data();
    if (!std::equal(d->qpos, d->qpos + m->nq, other.qpos + before_q) ||
        !std::equal(d->qvel, d->qvel + m->nv, other.qvel + before_v) ||
        !std::equal(d->sensordata, d->sensordata + m->nsensordata, other.sensordata)) {
      return i;
    }
  }
  EXPECT_GT(contacts, 0);
  return 1500;
}

// Contacts, limits and friction are solved to the same bit as in MuJoCo's own steps of the file, by
// all solvers and integrators, by dense matrices and by sparse ones (60 joints on).
TEST(FeltObject, WithoutTouchAModelBehavesAsItsOwnToTheBit) {
  for (const char* integrator : {"Euler", "implicit", "RK4"}) {
    const std::string by = "integrator='" + std::string(integrator) + "'";
    for (const int boxes : {1, 2, 8}) EXPECT_EQ(StepsAlike(Theirs(by, boxes)), 1500) << by << boxes;
  }
  for (const char* options :
       {"solver='PGS'", "solver='CG'", "solver='Newton' cone='elliptic'",
        "solver='CG' cone='elliptic'", "noslip_iterations='4'", "jacobian='sparse'",
        "jacobian='dense'", "solver='PGS' jacobian='sparse'", "impratio='10' cone='elliptic'",
        "wind='1 2 0' density='1.2' viscosity='0.00002'"}) {
    EXPECT_EQ(StepsAlike(Theirs(options, 3)), 1500) << options;
  }
}

// A file's keyframes stay what they were.
TEST(FeltObject, KeyframesOfAModelWithJointsAreStillItsOwn) {
  const Scene scene = Scene::FromXml(
      "<mujoco><custom><text name='moontrace:can' data='{}'/></custom><worldbody>"
      "<body name='led' mocap='true'><geom size='0.01'/></body>"
      "<body><joint type='slide'/><joint name='turn' type='hinge'/>"
      "<geom name='can' type='cylinder' size='0.03 0.05'/></body></worldbody><keyframe>"
      "<key name='half' qpos='0.1 0.2' qvel='0.3 0.4' mpos='1 2 3' mquat='0 1 0 0'/></keyframe>"
      "</mujoco>",
      "keys", {});
  const mjModel& m = *scene.model();
  const int turn = mj_name2id(&m, mjOBJ_JOINT, "turn");
  const int led = m.body_mocapid[mj_name2id(&m, mjOBJ_BODY, "led")];
  EXPECT_EQ(m.key_qpos[m.jnt_qposadr[turn]], 0.2);
  EXPECT_EQ(m.key_qvel[m.jnt_dofadr[turn]], 0.4);
  EXPECT_EQ(m.key_mpos[3 * led + 2], 3);
  EXPECT_EQ(m.key_mquat[4 * led + 1], 1);
}

}  // namespace
}  // namespace moontrace
