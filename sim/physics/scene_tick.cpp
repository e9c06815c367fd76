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

bool IsSane(glm::dvec3 v, double greatest) noexcept {
  // comparisons with NaN are false
  return std::abs(v.x) <= greatest && std::abs(v.y) <= greatest && std::abs(v.z) <= greatest;
}

bool IsSane(const DeviceState& input) noexcept {
  constexpr double kFastest = 1e6;  // [m/s]
  return IsSane(input.p_D, kFarthest) && (!input.velocity_known || IsSane(input.v_D, kFastest));
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

}  // namespace

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
/// pull of that same moment, so that what it is given is what the proxy gets. Each value is written
/// once: clearing the struct first would cost a twentieth of the tick.
StepForces Scene::Impl::Compute(glm::dvec3 tip_W, glm::dvec3 v_W) noexcept {
  const mjModel& m = *loaded.m;
  if (direct()) PlaceProxy(tip_W, v_W);
  if (loaded.proxy.handle_mocap >= 0) {
    mjtNum* handle = d->mocap_pos + std::ptrdiff_t{3} * loaded.proxy.handle_mocap;
    for (int i = 0; i < 3; ++i) handle[i] = tip_W[i];
  }
  mj_step1(&m, d.get());

  const Pose X_WP = PoseOfPage(*d, loaded.page);
  const glm::dvec3 point_W = direct() ? tip_W : ProxyPosition();
  const glm::dvec3 velocity_W = ProxyVelocity();
  const glm::dvec3 point_P = FromWorld(X_WP, point_W);
  const Contact contact = Touch(law, *field, point_P);
  glm::dvec3 page_P = memory.page_share * contact.force_P;
  if (options.friction > 0) {
    const glm::dvec3 normal_P = NormalOf(contact.sample.gradient);
    page_P += memory.friction.Advance(options.friction, options.presliding_stiffness, point_P,
                                      normal_P, glm::dot(page_P, normal_P));
  }
  const glm::dvec3 pull_W =
      direct() ? glm::dvec3(0) : coupling.Pull(tip_W - point_W, v_W - velocity_W);
  return {.X_WP = X_WP,
          .point_W = point_W,
          .velocity_W = velocity_W,
          .point_P = point_P,
          .depth = contact.depth,
          .displacement = contact.sample.displacement,
          .page_P = page_P,
          .page_W = TurnToWorld(X_WP, page_P),
          .pull_W = pull_W};
}

/// The energy stored now [J].
double Scene::Impl::Observe(glm::dvec3 tip_W, const StepForces& step) noexcept {
  double stored = memory.page_share * Potential(law, step.displacement, step.point_P.z) +
                  memory.friction.Energy(options.presliding_stiffness);
  if (!direct()) {
    stored += coupling.Energy(tip_W - step.point_W) +
              0.5 * loaded.proxy.mass * glm::dot(step.velocity_W, step.velocity_W);
  }
  if (memory.started == 0 || memory.stored_jumped != 0) {
    memory.observer.Rebase(stored);
  } else {
    const glm::dvec3 page_travel = ToWorld(step.X_WP, memory.touch_P) - memory.touch_W;
    const double work = glm::dot(memory.device_force_W, tip_W - memory.tip_W) -
                        glm::dot(memory.page_force_W, page_travel);
    memory.observer.Add(work, stored);
  }
  memory.stored_jumped = 0;
  memory.touch_P = step.point_P;
  memory.touch_W = step.point_W;
  return stored;
}

/// Adds our forces to the caller's qfrc_applied for one step, then restores its bits. The proxy's
/// three slides are the world's axes: a force on it is its own generalized force, as mj_applyFT
/// would find it. What the model's air and wind would do to the proxy, a thing that is not there,
/// is taken back.
void Scene::Impl::Integrate(const StepForces& step) noexcept {
  const mjModel& m = *loaded.m;
  std::copy_n(d->qfrc_applied, caller_qfrc.size(), caller_qfrc.begin());
  const glm::dvec3 on_proxy = direct() ? lift_W : lift_W + step.page_W + step.pull_W;
  for (int i = 0; i < 3; ++i) {
    const int dof = loaded.proxy.dof + i;
    d->qfrc_applied[dof] += on_proxy[i] - d->qfrc_passive[dof];
  }
  if (loaded.page.moves) {
    const mjtNum reaction[3] = {-step.page_W.x, -step.page_W.y, -step.page_W.z};
    const mjtNum point[3] = {step.point_W.x, step.point_W.y, step.point_W.z};
    const mjtNum torque[3] = {0, 0, 0};
    mj_applyFT(&m, d.get(), reaction, torque, point, loaded.page.body, d->qfrc_applied);
  }
  mj_step2(&m, d.get());
  std::copy_n(caller_qfrc.begin(), caller_qfrc.size(), d->qfrc_applied);
}

/// Whether something besides coupling and page moved the proxy in the step just taken.
bool Scene::Impl::IsHeld(const StepForces& step) const noexcept {
  if (direct()) return false;
  const double h = loaded.m->opt.timestep;
  const glm::dvec3 foreign = loaded.proxy.axis_mass * (ProxyVelocity() - step.velocity_W) -
                             h * (step.page_W + step.pull_W);  // [N s]
  return glm::dot(foreign, foreign) > kForeign * kForeign * h * h;
}

/// Pressed harder than the page carries, the proxy sinks: below a depth it is through, and the
/// page's force fades, its stored energy with it, until the proxy is above the page again. A proxy
/// that begins there, or that came there without the page's whole force, is pushed up as ever.
void Scene::Impl::WatchThrough(const StepForces& step, bool delivered) noexcept {
  const bool deep = -step.point_P.z > through_depth;
  if (deep && memory.deep == 0 && delivered) memory.through = 1;
  memory.deep = deep ? 1 : 0;
  if (memory.through == 0) return;
  memory.stored_jumped = 1;  // what was stored is dropped, not handed out
  memory.page_share = std::max(0.0, memory.page_share - options.tick / kFadeTime);
  if (step.depth > 0 || step.point_P.z < 0) return;
  memory.through = 0;
  memory.page_share = 1;
}

/// Steps the rest of the world while the device gives nothing usable.
void Scene::Impl::Idle() noexcept {
  StepForces none;
  for (int i = 0; i < substeps; ++i) {
    PlaceProxy(memory.tip_W, {0, 0, 0});
    mj_step1(loaded.m.get(), d.get());
    none.point_W = memory.tip_W;
    Integrate(none);
  }
}

void Scene::Impl::SwapField(const TextureField* new_field, int new_substeps) noexcept {
  field = new_field != nullptr ? new_field : &flat;
  law = LawOf(options.surface, *field);
  through_depth = ThroughDepth(options.surface, *field);
  substeps = new_substeps;
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
  Restart();
  TickResult result;
  result.fault = true;
  const glm::dvec3 tip_P = FromWorld(PoseOfPage(*d, loaded.page), tip_W);
  if (IsSane(tip_P, 1e300)) result.tip_P = result.proxy_P = tip_P;
  result.energy_out = memory.observer.energy_out();
  return result;
}

TickResult Scene::Impl::Tick(const DeviceState& input, bool delivered) noexcept {
  if (!IsSane(input)) {
    Idle();
    return Fail(memory.tip_W);
  }
  const glm::dvec3 tip_W = input.p_D;
  const glm::dvec3 from_W = memory.started != 0 ? memory.tip_W : tip_W;
  const glm::dvec3 v_W = input.velocity_known ? input.v_D : (tip_W - from_W) / options.tick;
  // a proxy left where the tip was before a gap would be a wound-up spring
  if (memory.started == 0) PlaceProxy(tip_W, v_W);

  const ResetWatch watch(*loaded.m, *d, substeps);
  const auto aim_W = [&](int i) noexcept {
    return i == substeps ? tip_W : from_W + static_cast<double>(i) / substeps * (tip_W - from_W);
  };
  StepForces step = Compute(aim_W(1), v_W);
  const double stored = Observe(tip_W, step);
  Integrate(step);
  bool held = IsHeld(step);
  glm::dvec3 pull_W = step.pull_W;
  glm::dvec3 page_W = step.page_W;
  for (int i = 2; i <= substeps; ++i) {
    step = Compute(aim_W(i), v_W);
    Integrate(step);
    held |= IsHeld(step);
    pull_W += step.pull_W;
    page_W += step.page_W;
  }
  if (substeps > 1) {
    pull_W *= 1.0 / substeps;
    page_W *= 1.0 / substeps;
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
  memory.started = 1;
  memory.tip_W = tip_W;
  memory.device_force_W = force_W;
  memory.page_force_W = page_W;
  const bool through = memory.through != 0;
  return {.tip_P = FromWorld(step.X_WP, tip_W),
          .v_P = input.velocity_known ? TurnFromWorld(step.X_WP, v_W) : glm::dvec3(0),
          .velocity_known = input.velocity_known,
          .proxy_P = FromWorld(step.X_WP, ProxyPosition()),
          .force_P = TurnFromWorld(step.X_WP, force_W),
          .force_W = force_W,
          .page_force_P = step.page_P,
          .depth = through ? 0 : step.depth,
          .energy_out = memory.observer.energy_out(),
          .stored = stored,
          .through = through};
}

}  // namespace moontrace
