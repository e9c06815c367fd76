#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "sim/physics/scene_impl.h"

namespace moontrace {
namespace {

constexpr double kFarthest = 1000;  ///< a tip further off than this is a fault [m]
constexpr double kFadeTime = 0.03;  ///< of the page's force when it is pressed through [s]
/// A force on the proxy that is neither the coupling's nor the page's: above what MuJoCo's solvers
/// leave of their own error [N].
constexpr double kForeign = 0.02;
const TextureField kBlank;

bool IsSane(glm::dvec3 v, double greatest) noexcept {
  // comparisons with NaN are false
  return std::abs(v.x) <= greatest && std::abs(v.y) <= greatest && std::abs(v.z) <= greatest;
}

bool IsSane(const DeviceState& input) noexcept {
  constexpr double kFastest = 1e6;  // [m/s]
  return IsSane(input.p_D, kFarthest) && (!input.velocity_known || IsSane(input.v_D, kFastest));
}

/// How often MuJoCo found a value in the state that is not finite or too great, and (by default)
/// reset itself silently.
int BadStateCount(const mjData& d) noexcept {
  return d.warning[mjWARN_BADQPOS].number + d.warning[mjWARN_BADQVEL].number +
         d.warning[mjWARN_BADQACC].number;
}

/// Notices that MuJoCo met a bad number and reset itself within a tick. A reset sets its counters
/// back too, but never its time to what was expected.
class ResetWatch {
 public:
  ResetWatch(const mjModel& m, const mjData& d, int steps) noexcept
      : d_(d),
        count_(BadStateCount(d)),
        expected_(d.time + steps * m.opt.timestep),
        margin_(0.5 * m.opt.timestep) {}
  bool Sees() const noexcept {
    return BadStateCount(d_) != count_ || !(std::abs(d_.time - expected_) <= margin_);
  }

 private:
  const mjData& d_;
  int count_;
  double expected_;
  double margin_;
};

/// Whether a point is no farther from a geom's middle than that [m]; most objects are far off, and
/// their poses need not be read.
bool IsWithin(double reach, const mjData& d, int geom, glm::dvec3 p_W) noexcept {
  const mjtNum* middle = d.geom_xpos + std::ptrdiff_t{3} * geom;
  const glm::dvec3 apart = p_W - glm::dvec3(middle[0], middle[1], middle[2]);
  return glm::dot(apart, apart) < reach * reach;
}

/// The plane that touches a round label below a point: P as on paper there.
Pose TouchingPose(const LabelChart& chart, const Pose& X_WO, glm::dvec3 p_W) noexcept {
  const glm::dvec3 p_O = FromWorld(X_WO, p_W);
  const LabelChart::Point at = chart.At(p_O);
  const Nearest above = chart.Above(p_O);
  const glm::dvec3 n = above.normal_O;
  const glm::dvec3 x = glm::normalize(at.dx_O - glm::dot(at.dx_O, n) * n);
  const glm::dmat3 R(x, glm::cross(n, x), n);
  return {X_WO.R * R, p_W - X_WO.R * (R * glm::dvec3(at.p_P, above.height))};
}

/// A force on one slide of the proxy, with what it comes to.
struct Push {
  double applied = 0;       ///< to be added to what acts there [N]
  double acceleration = 0;  ///< [m/s^2]
};

double LastBitOf(double value) noexcept {
  return std::nextafter(std::abs(value), INFINITY) - std::abs(value);
}

/// `wanted` [N], to within some of its last bits, so that mass times acceleration is the sum of
/// `acting` [N] and what is applied, and that sum divided by the mass the acceleration, to the bit,
/// as MuJoCo computes both: then its solvers find nothing left of the proxy, however far they come
/// down with the rest. With the shipped proxy's mass two of three numbers will do, and their
/// neighbours else.
Push SolvedPush(double wanted, double acting, double mass) noexcept {
  constexpr int kMost = 64;
  const double inverse = 1 / mass, first = wanted - acting;
  const double step = std::max(LastBitOf(first), LastBitOf(wanted));
  for (int i = 0; i < kMost; ++i) {
    for (const double applied : {first + i * step, first - i * step}) {
      const double sum = acting + applied, acceleration = sum * inverse;
      if (mass * acceleration == sum) return {applied, acceleration};
    }
  }
  return {first, wanted * inverse};
}

}  // namespace

Pose Scene::Impl::PoseOfLabel(const Pose& X_WG, glm::dvec3 p_W) const noexcept {
  if (!flat) return TouchingPose(page_label().chart, X_WG, p_W);
  return {X_WG.R * X_GP.R, ToWorld(X_WG, X_GP.p)};
}

glm::dvec3 Scene::Impl::ToRoundPage(glm::dvec3 p_W) const noexcept {
  const LabelChart& chart = page_label().chart;
  const glm::dvec3 p_O = FromWorld(PoseOfGeom(*d, page_geom), p_W);
  return {chart.At(p_O).p_P, chart.Above(p_O).height};
}

glm::dvec3 Scene::Impl::ProxyPosition() const noexcept {
  const mjtNum* q = d->qpos + loaded.proxy.qpos;
  return loaded.proxy.offset_W + glm::dvec3(q[0], q[1], q[2]);
}

glm::dvec3 Scene::Impl::ProxyVelocity() const noexcept {
  const mjtNum* v = d->qvel + loaded.proxy.dof;
  return {v[0], v[1], v[2]};
}

void Scene::Impl::PlaceProxy(glm::dvec3 p_W, glm::dvec3 v_W) noexcept {
  const glm::dvec3 q = p_W - loaded.proxy.offset_W;
  for (int i = 0; i < 3; ++i) {
    d->qpos[loaded.proxy.qpos + i] = q[i];
    d->qvel[loaded.proxy.dof + i] = v_W[i];
  }
}

/// Runs MuJoCo up to its forces and computes ours from the same moment: positions and velocities at
/// the start of the step. The semi-implicit integrator that follows turns the springs' forces into
/// velocity before it moves, which keeps their energy (it is symplectic); the device feels the
/// pull of that same moment, so that what it is given is what the proxy gets. Of a page each value
/// is written once: clearing the struct first would cost a twentieth of the tick.
StepForces Scene::Impl::Compute(glm::dvec3 tip_W, glm::dvec3 v_W) noexcept {
  if (direct()) PlaceProxy(tip_W, v_W);
  if (loaded.proxy.handle_mocap >= 0) {
    mjtNum* handle = d->mocap_pos + std::ptrdiff_t{3} * loaded.proxy.handle_mocap;
    for (int i = 0; i < 3; ++i) handle[i] = tip_W[i];
  }
  BeginStep();

  const glm::dvec3 point_W = direct() ? tip_W : ProxyPosition();
  const glm::dvec3 velocity_W = ProxyVelocity();
  const glm::dvec3 pull_W = PullOn(tip_W - point_W, v_W - velocity_W);
  if (!rests) X_WP = PoseOfPage(point_W);
  if (page_only) return TouchPage(point_W, velocity_W, pull_W);
  StepForces step;
  step.point_W = point_W;
  step.velocity_W = velocity_W;
  step.pull_W = pull_W;
  TouchObjects(step);
  return step;
}

/// The coupling's on the proxy.
glm::dvec3 Scene::Impl::PullOn(glm::dvec3 stretch_W, glm::dvec3 rate_W) const noexcept {
  if (direct()) return glm::dvec3(0);
  if (!collides()) return coupling.Pull(stretch_W, rate_W);
  return coupling.PullWithin(options.surface.force_cap, stretch_W, rate_W);
}

/// What the proxy met in the step just taken.
Scene::Impl::ProxyContact Scene::Impl::CollisionOfProxy() const noexcept {
  ProxyContact met;
  for (int i = 0; i < static_cast<int>(d->ncon); ++i) {
    const mjContact& contact = d->contact[i];
    const int geoms[2] = {contact.geom1, contact.geom2};
    for (int side = 0; side < 2; ++side) {
      if (geoms[side] < 0 || geoms[1 - side] < 0) continue;
      if (loaded.m->geom_bodyid[geoms[side]] != loaded.proxy.body) continue;
      met = {geoms[1 - side], std::max(met.depth, -contact.dist)};
    }
  }
  return met;
}

/// One page on a plane, in its own frame: the quick way.
StepForces Scene::Impl::TouchPage(glm::dvec3 point_W, glm::dvec3 velocity_W,
                                  glm::dvec3 pull_W) noexcept {
  const glm::dvec3 point_P = FromWorld(X_WP, point_W);
  const SurfaceLaw& law = page().law;
  const TextureField* field = page_label().field;
  const Contact contact = Touch(law, field != nullptr ? *field : kBlank, point_P);
  glm::dvec3 page_P = memory.page_share * contact.force_P;
  if (options.friction > 0) {
    const glm::dvec3 normal_P = NormalOf(contact.sample.gradient);
    page_P += memory.friction.Advance(options.friction, options.presliding_stiffness, point_P,
                                      normal_P, glm::dot(page_P, normal_P));
  }
  const glm::dvec3 page_W = TurnToWorld(X_WP, page_P);
  reactions[0] = page_W;
  return {.point_W = point_W,
          .velocity_W = velocity_W,
          .touch_T = point_P,
          .depth = contact.depth,
          .sunk = -point_P.z,
          .energy = Potential(law, contact.sample.displacement, point_P.z),
          .page_P = page_P,
          .page_W = page_W,
          .pull_W = pull_W};
}

/// All objects that carry labels. The one that is touched deepest has the friction.
void Scene::Impl::TouchObjects(StepForces& step) noexcept {
  std::size_t deepest = touched;
  SolidContact there;
  Pose X_WO = PoseOfGeom(*d, objects[deepest].geom);
  step.touch_T = FromWorld(X_WO, step.point_W);
  step.depth = -1;
  step.sunk = -1;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const FeltObject& object = objects[i];
    reactions[i] = {0, 0, 0};
    if (!IsWithin(object.reach, *d, object.geom, step.point_W)) {
      sides[i] = {};
      continue;
    }
    const Pose pose = PoseOfGeom(*d, object.geom);
    const glm::dvec3 p_O = FromWorld(pose, step.point_W);
    Remember(object.solid, object.thin, p_O, sides[i]);
    const SolidContact contact = TouchSolid(object.law, object.solid, object.labels, p_O, sides[i]);
    step.energy += Potential(object.law, contact.displacement, contact.nearest.height);
    reactions[i] = TurnToWorld(pose, memory.page_share * contact.force_O);
    step.sunk = std::max(step.sunk, -contact.nearest.height);
    if (contact.depth <= step.depth || contact.depth <= 0) continue;
    step.depth = contact.depth;
    deepest = i;
    there = contact;
    X_WO = pose;
    step.touch_T = p_O;
  }
  if (deepest != touched) memory.friction = Friction();
  touched = deepest;
  if (options.friction > 0) {
    const glm::dvec3 normal_O = glm::normalize(there.nearest.normal_O - there.gradient_O);
    const double press = step.depth > 0 ? memory.page_share * glm::dot(there.force_O, normal_O) : 0;
    reactions[touched] +=
        TurnToWorld(X_WO, memory.friction.Advance(options.friction, options.presliding_stiffness,
                                                  step.touch_T, normal_O, press));
  }
  for (const glm::dvec3& reaction : reactions) step.page_W += reaction;
  step.page_P = TurnFromWorld(X_WP, step.page_W);
}

/// The frame of StepForces::touch_T.
Pose Scene::Impl::FrameOf(std::size_t object) const noexcept {
  return page_only ? X_WP : PoseOfGeom(*d, objects[object].geom);
}

/// The energy stored now [J]. `before`: what was touched in the tick before.
double Scene::Impl::Observe(glm::dvec3 tip_W, const StepForces& step, std::size_t before) noexcept {
  double stored =
      memory.page_share * step.energy + memory.friction.Energy(options.presliding_stiffness);
  if (!direct()) {
    const glm::dvec3 stretch_W = tip_W - step.point_W;
    stored += (collides() ? coupling.EnergyWithin(options.surface.force_cap, stretch_W)
                          : coupling.Energy(stretch_W)) +
              0.5 * loaded.proxy.mass * glm::dot(step.velocity_W, step.velocity_W);
  }
  if (memory.started == 0 || memory.stored_jumped != 0) {
    memory.observer.Rebase(stored);
  } else {
    const glm::dvec3 page_travel = ToWorld(FrameOf(before), memory.touch_P) - memory.touch_W;
    const double work = glm::dot(memory.device_force_W, tip_W - memory.tip_W) -
                        glm::dot(memory.page_force_W, page_travel);
    memory.observer.Add(work, stored);
  }
  memory.stored_jumped = 0;
  memory.touch_P = step.touch_T;
  memory.touch_W = step.point_W;
  return stored;
}

/// Adds our forces to the caller's qfrc_applied for one step, then restores its bits. The proxy's
/// three slides are the world's axes: a force on it is its own generalized force, as mj_applyFT
/// would find it. Its weight, and what the model's air and wind would do to the proxy, a thing that
/// is not there, are taken back. MuJoCo's solvers begin where the proxy will be: nothing of it is
/// left to be solved among the model's own contacts.
void Scene::Impl::Integrate(const StepForces& step) noexcept {
  const mjModel& m = *loaded.m;
  std::copy_n(d->qfrc_applied, caller_qfrc.size(), caller_qfrc.begin());
  const bool alone = m.nv == 3;
  glm::dvec3 on_proxy = alone ? lift_W : glm::dvec3(0);
  if (!direct()) on_proxy = on_proxy + step.page_W + step.pull_W;
  for (int i = 0; i < 3; ++i) {
    const int dof = loaded.proxy.dof + i;
    if (alone) {
      d->qfrc_applied[dof] += on_proxy[i] - d->qfrc_passive[dof];
    } else {
      const double wanted = d->qfrc_applied[dof] + on_proxy[i];
      const Push push =
          SolvedPush(wanted, d->qfrc_passive[dof] - d->qfrc_bias[dof], loaded.proxy.axis_mass[i]);
      d->qfrc_applied[dof] = push.applied;
      d->qacc_warmstart[dof] = push.acceleration;
    }
  }
  if (const int pad = loaded.proxy.pad_dof; pad >= 0) {
    d->qfrc_applied[pad] += d->qfrc_bias[pad] - d->qfrc_passive[pad];
    d->qacc_warmstart[pad] = 0;
  }
  if (pushes) PushBack(step);
  FinishStep();
  if (pushes) KeepMomentum();
  std::copy_n(caller_qfrc.begin(), caller_qfrc.size(), d->qfrc_applied);
}

/// Of bodies that float and were pushed, each once.
void Scene::Impl::KeepMomentum() noexcept {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (reactions[i] == glm::dvec3(0) || !objects[i].floating.floats()) continue;
    bool done = false;  // two objects on one body
    for (std::size_t k = 0; k < i; ++k) {
      done |= reactions[k] != glm::dvec3(0) && objects[k].floating.Is(objects[i].floating);
    }
    if (!done) objects[i].floating.End(loaded.m->opt.timestep, *d);
  }
}

/// MuJoCo's step up to its forces. It makes quaternions unit in place, which a second time would
/// change their last bits, so where the step is begun once more they are kept as they were.
void Scene::Impl::BeginStep() noexcept {
  if (!own_qpos.empty()) std::copy_n(d->qpos, own_qpos.size(), own_qpos.begin());
  mj_step1(loaded.m.get(), d.get());
}

/// MuJoCo's step from where mj_step1 left it. Its mj_step2 knows no RK4, so a model that asks for
/// that is stepped whole, and the proxy, whose forces are held over the step, goes on as by Euler.
void Scene::Impl::FinishStep() noexcept {
  const mjModel& m = *loaded.m;
  if (own_qpos.empty()) {
    mj_step2(&m, d.get());
    return;
  }
  std::copy_n(own_qpos.begin(), own_qpos.size(), d->qpos);
  const glm::dvec3 from_W = ProxyPosition();
  mj_step(&m, d.get());
  PlaceProxy(from_W + m.opt.timestep * ProxyVelocity(), ProxyVelocity());
}

/// Integration steps of this tick: as many as what is near needs; where nothing is near that its
/// stiffness could move, as few as the coupling needs, so that a model without touch goes as it
/// would by itself.
int Scene::Impl::StepsNow(glm::dvec3 tip_W) const noexcept {
  if (substeps == 1 || (page_only && loaded.m->nv == 3)) return substeps;
  const glm::dvec3 points_W[] = {tip_W, direct() ? tip_W : ProxyPosition()};
  int steps = free_substeps;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const FeltObject& object = objects[i];
    if (object.steps <= steps) continue;
    for (const glm::dvec3& p_W : points_W) {
      if (!IsWithin(object.reach + object.near, *d, object.geom, p_W)) continue;
      const Pose X_WO = PoseOfGeom(*d, object.geom);
      const double height = NearestOf(object.solid, FromWorld(X_WO, p_W), sides[i]).height;
      if (!(height > object.near)) steps = std::max(steps, object.steps);
    }
  }
  return steps;
}

/// The opposite of each force on the tip, where that acts, on what can be pushed.
void Scene::Impl::PushBack(const StepForces& step) noexcept {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    FeltObject& object = objects[i];
    if (!object.pushed || reactions[i] == glm::dvec3(0)) continue;
    object.floating.Begin(*d);
    const mjtNum reaction[3] = {-reactions[i].x, -reactions[i].y, -reactions[i].z};
    const mjtNum point[3] = {step.point_W.x, step.point_W.y, step.point_W.z};
    const mjtNum torque[3] = {0, 0, 0};
    mj_applyFT(loaded.m.get(), d.get(), reaction, torque, point, object.body, d->qfrc_applied);
  }
}

/// Whether something besides coupling and page moved the proxy in the step just taken.
bool Scene::Impl::IsHeld(const StepForces& step) const noexcept {
  if (direct() || collides()) return false;
  const double h = loaded.m->opt.timestep;
  const glm::dvec3 foreign = loaded.proxy.axis_mass * (ProxyVelocity() - step.velocity_W) -
                             h * (step.page_W + step.pull_W);  // [N s]
  return glm::dot(foreign, foreign) > kForeign * kForeign * h * h;
}

/// Pressed harder than the page carries, the proxy sinks: below a depth it is through, and the
/// page's force fades, its stored energy with it, until the proxy is above the page again. A proxy
/// that begins there, or that came there without the page's whole force, is pushed up as ever.
void Scene::Impl::WatchThrough(const StepForces& step, bool delivered) noexcept {
  const bool deep = step.sunk > objects[touched].through_depth;
  if (deep && memory.deep == 0 && delivered) memory.through = 1;
  memory.deep = deep ? 1 : 0;
  if (memory.through == 0) return;
  memory.stored_jumped = 1;  // what was stored is dropped, not handed out
  memory.page_share = std::max(0.0, memory.page_share - options.tick / kFadeTime);
  if (step.depth > 0 || step.sunk > 0) return;
  memory.through = 0;
  memory.page_share = 1;
}

/// Steps the rest of the world while the device gives nothing usable.
void Scene::Impl::Idle() noexcept {
  StepForces none;
  steps_taken = 0;
  loaded.m->opt.timestep = options.tick / substeps;
  std::fill(reactions.begin(), reactions.end(), glm::dvec3(0));
  for (int i = 0; i < substeps; ++i) {
    PlaceProxy(memory.tip_W, {0, 0, 0});
    BeginStep();
    none.point_W = memory.tip_W;
    Integrate(none);
  }
}

void Scene::Impl::Swap(const ReadyPage& page) noexcept {
  options.label = page.label;
  options.text_P = page.text_P;
  const Carrier carrier = CarrierOf(page.label);
  FeltObject& object = objects[carrier.object];
  object.labels[carrier.number] = page.laid;
  object.Settle();
  object.steps = page.substeps;
  FindPage();
  substeps = 1;
  for (const FeltObject& each : objects) substeps = std::max(substeps, each.steps);
  steps_taken = 0;
  loaded.m->opt.timestep = options.tick / substeps;
  Restart();
}

void Scene::Impl::Restart() noexcept {
  const glm::dvec3 tip_W = memory.tip_W;
  const PassivityObserver observer = memory.observer;
  memory = TickMemory();
  memory.observer = observer;
  memory.tip_W = tip_W;
}

/// Zero force, the proxy at rest at the tip; the next good tick starts afresh.
TickResult Scene::Impl::Fail(glm::dvec3 tip_W) noexcept {
  PlaceProxy(tip_W, {0, 0, 0});
  memory.tip_W = tip_W;
  // where the tip comes back it is not known to have been pressed through anything
  std::fill(sides.begin(), sides.end(), Sides());
  Restart();
  TickResult result;
  result.fault = true;
  if (!rests) X_WP = PoseOfPage(tip_W);
  const glm::dvec3 tip_P = ToPage(tip_W);
  if (IsSane(tip_P, 1e300)) result.tip_P = result.proxy_P = tip_P;
  result.energy_out = memory.observer.energy_out();
  return result;
}

// Flat: its parts hand each other vectors, which as arguments would go through memory, written by
// number and read by pair, and each such reading waits.
[[gnu::flatten]] TickResult Scene::Impl::Tick(const DeviceState& input, bool delivered) noexcept {
  if (!IsSane(input)) {
    Idle();
    return Fail(memory.tip_W);
  }
  const glm::dvec3 tip_W = input.p_D;
  const glm::dvec3 from_W = memory.started != 0 ? memory.tip_W : tip_W;
  const glm::dvec3 v_W = input.velocity_known ? input.v_D : (tip_W - from_W) / options.tick;
  // a proxy left where the tip was before a gap would be a wound-up spring
  if (memory.started == 0) PlaceProxy(tip_W, v_W);

  const int steps = StepsNow(tip_W);
  if (steps != steps_taken) {
    steps_taken = steps;
    loaded.m->opt.timestep = options.tick / steps;
  }
  // Felt directly, the tip stays where it was read: so its force acts, on what it touches, at the
  // place that is reported.
  const auto aim_W = [&](int i) noexcept {
    if (i == steps || direct()) return tip_W;
    return from_W + static_cast<double>(i) / steps * (tip_W - from_W);
  };
  const ResetWatch watch(*loaded.m, *d, steps);
  const std::size_t before = touched;
  StepForces step = Compute(aim_W(1), v_W);
  const double stored = Observe(tip_W, step, before);
  Integrate(step);
  bool held = IsHeld(step);
  glm::dvec3 pull_W = step.pull_W;
  glm::dvec3 page_W = step.page_W;
  for (int i = 2; i <= steps; ++i) {
    step = Compute(aim_W(i), v_W);
    Integrate(step);
    held |= IsHeld(step);
    pull_W += step.pull_W;
    page_W += step.page_W;
  }
  if (steps > 1) {
    pull_W *= 1.0 / steps;
    page_W *= 1.0 / steps;
  }

  // through the paper not even the proxy's own weight is dragged along
  const glm::dvec3 force_W = direct() ? page_W : -memory.page_share * pull_W;
  if (watch.Sees() || !IsSane(force_W, 1e9) || !IsSane(ProxyPosition(), 2 * kFarthest)) {
    return Fail(tip_W);
  }
  if (held) {
    TickResult failed = Fail(tip_W);
    failed.held = true;
    return failed;
  }
  if (direct()) PlaceProxy(tip_W, v_W);
  WatchThrough(step, delivered);
  const ProxyContact collision = collides() ? CollisionOfProxy() : ProxyContact();
  // what MuJoCo's contact takes or gives is in no balance here
  if (collision.geom >= 0) memory.stored_jumped = 1;
  memory.started = 1;
  memory.tip_W = tip_W;
  memory.device_force_W = force_W;
  memory.page_force_W = page_W;
  const bool through = memory.through != 0;
  return {.tip_P = ToPage(tip_W),
          .v_P = input.velocity_known ? TurnFromWorld(X_WP, v_W) : glm::dvec3(0),
          .velocity_known = input.velocity_known,
          .proxy_P = ToPage(ProxyPosition()),
          .force_P = TurnFromWorld(X_WP, force_W),
          .force_W = force_W,
          .page_force_P = step.page_P,
          .depth = through ? 0 : std::max(step.depth, collision.depth),
          .geom = !through && step.depth > 0 ? objects[touched].geom : collision.geom,
          .energy_out = memory.observer.energy_out(),
          .stored = stored,
          .through = through};
}

}  // namespace moontrace
