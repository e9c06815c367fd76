#include "sim/physics/scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <numeric>
#include <utility>

#include "sim/physics/scene_impl.h"
#include "textures/base/error.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr std::size_t kGreatestModel = std::size_t{64} << 20;  ///< [bytes]
constexpr int kMostSubsteps = 16;
constexpr int kMostOfMoving = 64;          ///< where the page moves and may be light
constexpr double kGreatestFriction = 0.9;  ///< times the greatest slope

/// Friction holds a tip on a flank of slope s when mu * s reaches one: it would stick in every
/// groove.
void CheckFriction(const SceneOptions& options, double slope) {
  if (options.friction * slope < kGreatestFriction) return;
  // the greatest hundredth that is still below the limit
  const double most = std::max(0.0, std::ceil(100 * kGreatestFriction / slope - 1e-9) - 1) / 100;
  throw InputError(fmt::format("friction {:g} is too high for the slope {:.2f}: at most {:.2f}",
                               options.friction, slope, most));
}

/// A page that moves is stepped this finely, h^2 k / m: the integrator's energy then errs by less
/// than a hundredth of what page and hand exchange.
constexpr double kMovingPage = 0.04;

/// Integration steps a tick so that h^2 k / m < 1 and h b / m < 1: well inside the semi-implicit
/// integrator's stability, h^2 k / m + 2 h b / m < 4. `page_compliance` [1/kg]: PageCompliance.
int StepsFor(const SceneOptions& options, const TextureField& field, double mass,
             double page_compliance) {
  const bool direct = options.rendering == Rendering::kDirect;
  if (direct && page_compliance == 0) return 1;
  const double page = GreatestStiffness(options.surface, field, options.surface.force_cap) +
                      (options.friction > 0 ? options.presliding_stiffness : 0);
  const double own = direct ? 0 : 1 / mass;
  const double rate = (page + (direct ? 0 : options.coupling_stiffness)) * own;  // [1/s^2]
  const double both = page * (own + page_compliance);
  const double damped = direct ? 0 : options.coupling_damping / mass;  // [1/s]
  const int most = page_compliance > 0 ? kMostOfMoving : kMostSubsteps;
  for (int steps = 1; steps <= most; ++steps) {
    const double h = options.tick / steps;
    const bool page_holds = page_compliance == 0 || h * h * both < kMovingPage;
    if (h * h * rate < 1 && h * damped < 1 && page_holds) return steps;
  }
  const double finest = options.tick / most;
  if (finest * finest * rate < 1 && finest * damped < 1) {
    throw InputError(fmt::format(
        "the page's body is too light: {:.3g} g where it gives way most, under {:.0f} N/m; make it "
        "heavier or round the letters more",
        1000 / page_compliance, page));
  }
  throw InputError(fmt::format(
      "too stiff: {:.0f} N/m, {:.0f} N s/m on {:.0f} g, over {} steps in {:g} ms: round it more",
      rate * mass, options.coupling_damping, 1000 * mass, most, 1000 * options.tick));
}

/// How readily the page's body gives way [1/kg]: the greatest velocity that a unit impulse on a
/// corner of the page gives that corner, from J M^-1 J^T; at least its greatest eigenvalue, by its
/// row sums. Zero for a page that rests. Constraints, which hold it back, do not count.
double PageCompliance(const mjModel& m, mjData& d, const PagePlace& page) {
  if (!page.moves) return 0;
  const auto nv = static_cast<std::size_t>(m.nv);
  std::vector<mjtNum> J(3 * nv), solved(3 * nv);
  const mjtNum* half = m.geom_size + std::ptrdiff_t{3} * page.geom;
  const mjtNum* p = d.geom_xpos + std::ptrdiff_t{3} * page.geom;
  const mjtNum* R = d.geom_xmat + std::ptrdiff_t{9} * page.geom;
  double greatest = 0;
  for (const int corner : {0, 1, 2, 3}) {
    const mjtNum corner_G[3] = {(corner & 1) != 0 ? half[0] : -half[0],
                                (corner & 2) != 0 ? half[1] : -half[1], half[2]};
    mjtNum corner_W[3];
    mju_rotVecMat(corner_W, corner_G, R);
    mju_addTo3(corner_W, p);
    mj_jac(&m, &d, J.data(), nullptr, corner_W, page.body);
    mj_solveM(&m, &d, solved.data(), J.data(), 3);
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = 0;
      for (std::size_t column = 0; column < 3; ++column) {
        sum += std::abs(
            std::inner_product(J.begin() + static_cast<std::ptrdiff_t>(row * nv),
                               J.begin() + static_cast<std::ptrdiff_t>((row + 1) * nv),
                               solved.begin() + static_cast<std::ptrdiff_t>(column * nv), 0.0));
      }
      greatest = std::max(greatest, sum);
    }
  }
  return greatest;
}

/// Calls `visit(values, count)` for every array that a step starts from.
template <typename Data, typename Visit>
void VisitState(const mjModel& m, Data& d, const Visit& visit) {
  const auto count = [](auto n) { return static_cast<std::size_t>(n); };
  visit(&d.time, 1);
  visit(d.qpos, count(m.nq));
  visit(d.qvel, count(m.nv));
  visit(d.act, count(m.na));
  visit(d.qacc_warmstart, count(m.nv));
  visit(d.ctrl, count(m.nu));
  visit(d.qfrc_applied, count(m.nv));
  visit(d.xfrc_applied, 6 * count(m.nbody));
  visit(d.mocap_pos, 3 * count(m.nmocap));
  visit(d.mocap_quat, 4 * count(m.nmocap));
  visit(d.userdata, count(m.nuserdata));
}

constexpr std::size_t kMemoryDoubles = sizeof(TickMemory) / sizeof(double);

}  // namespace

Scene::Impl::Impl(LoadedModel loaded_model, const SceneOptions& scene_options,
                  const std::string& name)
    : loaded(std::move(loaded_model)),
      options(scene_options),
      d(MakeData(*loaded.m, name)),
      caller_qfrc(static_cast<std::size_t>(loaded.m->nv), 0.0) {
  mjModel& m = *loaded.m;
  if (std::abs(m.opt.timestep - options.tick) > 1e-12) {
    loaded.remarks.push_back(fmt::format("time step: {:g} ms instead of the model's {:g} ms",
                                         1000 * options.tick, 1000 * m.opt.timestep));
  }
  if ((m.opt.disableflags & mjDSBL_GRAVITY) == 0) {
    lift_W = -loaded.proxy.weight_mass *
             glm::dvec3(m.opt.gravity[0], m.opt.gravity[1], m.opt.gravity[2]);
  }
  mj_forward(loaded.m.get(), d.get());
  page_compliance = PageCompliance(m, *d, loaded.page);
  SetOptions(scene_options);
}

void Scene::Impl::SetOptions(const SceneOptions& new_options) {
  const double tick = options.tick, tilt = options.tilt;
  options = new_options;
  options.tick = tick;
  options.tilt = tilt;
  coupling = {options.coupling_stiffness, options.coupling_damping};
  SetField(nullptr);
  Reset({0, 0, 0.02});
}

int Scene::Impl::CheckField(const TextureField* new_field) const {
  const TextureField& next = new_field != nullptr ? *new_field : flat;
  CheckFriction(options, next.greatest_slope());
  return StepsFor(options, next, loaded.proxy.mass, page_compliance);
}

void Scene::Impl::SetField(const TextureField* new_field) {
  substeps = CheckField(new_field);
  field = new_field != nullptr ? new_field : &flat;
  law = LawOf(options.surface, *field);
  through_depth = ThroughDepth(options.surface, *field);
  loaded.m->opt.timestep = options.tick / substeps;
  memory.stored_jumped = 1;
  remarks = loaded.remarks;
  if (substeps > 1) {
    remarks.push_back(fmt::format("{} sub-steps a tick: the page is stiff", substeps));
  }
}

void Scene::Impl::Reset(glm::dvec3 tip_P) {
  mj_resetData(loaded.m.get(), d.get());
  mj_kinematics(loaded.m.get(), d.get());
  memory = TickMemory();
  memory.tip_W = ToWorld(PoseOfPage(*d, loaded.page), tip_P);
  PlaceProxy(memory.tip_W, {0, 0, 0});
  if (loaded.proxy.handle_mocap >= 0) {
    for (int i = 0; i < 3; ++i) {
      d->mocap_pos[3 * loaded.proxy.handle_mocap + i] = memory.tip_W[i];
    }
  }
  mj_forward(loaded.m.get(), d.get());
}

Scene::Scene(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Scene Scene::Load(const std::string& model_path, const SceneOptions& options) {
  Check(options);
  const bool shipped = model_path.empty();
  const std::string path = shipped ? ResourcePath("models/page.xml") : model_path;
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  LoadedModel loaded = LoadModel(ReadTextFile(path, kGreatestModel), folder, path, options.tilt);
  if (shipped) loaded.remarks.clear();  // what it lacks, it lacks on purpose
  return Scene(std::make_unique<Impl>(std::move(loaded), options, path));
}

Scene Scene::FromXml(const std::string& xml, const std::string& name, const SceneOptions& options) {
  Check(options);
  return Scene(std::make_unique<Impl>(LoadModel(xml, "", name, options.tilt), options, name));
}

void Scene::SetOptions(const SceneOptions& options) {
  Check(options);
  impl_->SetOptions(options);
}
void Scene::SetField(const TextureField* field) { impl_->SetField(field); }
int Scene::CheckField(const TextureField* field) const { return impl_->CheckField(field); }
void Scene::SwapField(const TextureField* field, int substeps) noexcept {
  impl_->SwapField(field, substeps);
}
void Scene::Restart() noexcept { impl_->Restart(); }
TickResult Scene::Tick(const DeviceState& input, bool delivered) noexcept {
  return impl_->Tick(input, delivered);
}
void Scene::Reset(glm::dvec3 tip_P) { impl_->Reset(tip_P); }

const std::vector<Label>& Scene::labels() const { return impl_->loaded.labels; }
Pose Scene::X_WP() const { return PoseOfPage(*impl_->d, impl_->loaded.page); }
glm::dvec2 Scene::page_extent() const { return impl_->loaded.page.extent; }
bool Scene::page_moves() const { return impl_->loaded.page.moves; }
const SceneOptions& Scene::options() const { return impl_->options; }
const std::string& Scene::model_xml() const { return impl_->loaded.xml; }
const std::vector<std::string>& Scene::remarks() const { return impl_->remarks; }
int Scene::substeps() const { return impl_->substeps; }
double Scene::proxy_mass() const { return impl_->loaded.proxy.mass; }
double Scene::force_bound(const Movement& movement) const {
  if (page_moves()) return std::numeric_limits<double>::infinity();
  return ForceBound(options(), proxy_mass(), movement, substeps());
}
double Scene::carried_press() const { return CarriedPress(impl_->options.surface, *impl_->field); }
const mjModel_* Scene::model() const { return impl_->loaded.m.get(); }
mjData_* Scene::data() { return impl_->d.get(); }

std::vector<double> Scene::State() const {
  std::vector<double> state;
  VisitState(*impl_->loaded.m, *impl_->d, [&state](const mjtNum* values, std::size_t count) {
    state.insert(state.end(), values, values + count);
  });
  state.resize(state.size() + kMemoryDoubles);
  std::memcpy(state.data() + state.size() - kMemoryDoubles, &impl_->memory, sizeof(TickMemory));
  return state;
}

void Scene::SetState(const std::vector<double>& state) {
  std::size_t expected = kMemoryDoubles;
  VisitState(*impl_->loaded.m, *impl_->d,
             [&expected](const mjtNum*, std::size_t count) { expected += count; });
  if (state.size() != expected) {
    throw InputError(fmt::format("state: {} numbers, this model has {}; use the record's own model",
                                 state.size(), expected));
  }
  const double* next = state.data();
  VisitState(*impl_->loaded.m, *impl_->d, [&next](mjtNum* values, std::size_t count) {
    std::copy_n(next, count, values);
    next += count;
  });
  std::memcpy(static_cast<void*>(&impl_->memory), next, sizeof(TickMemory));
  mj_kinematics(impl_->loaded.m.get(), impl_->d.get());
}

}  // namespace moontrace
