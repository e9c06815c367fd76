#include "sim/library/stepping/bound_scene.h"

#include <mujoco/mujoco.h>

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "sim/console/console.h"

namespace moontrace {

namespace {
constexpr const char* kModel = "the model";  ///< in messages
}

BoundScene::Settings BoundScene::Read() const noexcept {
  return {m_->opt.timestep, m_->stat.meaninertia, m_->opt.jacobian, m_->opt.disableflags,
          m_->opt.enableflags};
}

void BoundScene::Write(const Settings& settings) noexcept {
  m_->opt.timestep = settings.timestep;
  m_->stat.meaninertia = settings.mean_inertia;
  m_->opt.jacobian = settings.jacobian;
  m_->opt.disableflags = settings.disabled;
  m_->opt.enableflags = settings.enabled;
}

BoundScene::Identity BoundScene::IdentityOf(const mjModel_& m, const mjData_& d) noexcept {
  return {m.buffer, d.buffer};
}

void BoundScene::Bind(SceneOptions options) {
  auto place = [this] { mj_fwdPosition(m_, d_); };
  if (!RunMujoco(place)) Broke();
  const Settings callers = Read();
  tick_ = options.tick = callers.timestep;
  identity_ = IdentityOf(*m_, *d_);
  scene_.reset();
  try {
    scene_.emplace(Scene::Bind(m_, d_, xml_, kModel, options));
  } catch (...) {
    Write(callers);
    throw;
  }
  own_ = Read();
  own_.disabled &= ~callers.disabled;
  own_.enabled |= ~callers.enabled;
  Write(callers);
}

void BoundScene::Require(const mjModel_* m, const mjData_* d) const {
  if (m == nullptr || d == nullptr) throw UsageError("model or data are NULL");
  if (m != m_ || d != d_) throw UsageError("the scene was opened with another model or other data");
  if (IdentityOf(*m, *d) != identity_) {
    throw UsageError("model or data were made anew; open the scene anew with them");
  }
  if (m->opt.timestep != tick_) {
    throw UsageError(
        fmt::format("the model's time step is {:g} ms, the scene's {:g} ms; open it anew",
                    1e3 * m->opt.timestep, 1e3 * tick_));
  }
}

TickResult BoundScene::Tick(const DeviceState& input) {
  if (broken_)
    throw MujocoError(std::string("after an error of MuJoCo's: ") + LastMujocoError() +
                      "; reset the scene");
  TickResult result;
  Run([&] { result = scene_->Tick(input); });
  return result;
}

void BoundScene::Reset(glm::dvec3 tip_P) {
  Run([&] { scene_->Reset(tip_P); });
  broken_ = false;
}

void BoundScene::Broke() {
  broken_ = true;
  throw MujocoError(std::string("MuJoCo stopped: ") + LastMujocoError());
}

}  // namespace moontrace
