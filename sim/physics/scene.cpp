#include "sim/physics/scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
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
/// integrator's stability, h^2 k / m + 2 h b / m < 4. `surface` [N/m]: the greatest stiffness of
/// what is touched; `compliance` [1/kg]: FeltObject::compliance.
int StepsFor(const SceneOptions& options, double surface, double mass, double compliance) {
  const bool direct = options.rendering == Rendering::kDirect;
  if (direct && compliance == 0) return 1;
  const double page = surface + (options.friction > 0 ? options.presliding_stiffness : 0);
  const double own = direct ? 0 : 1 / mass;
  const double rate = (page + (direct ? 0 : options.coupling_stiffness)) * own;  // [1/s^2]
  const double both = page * (own + compliance);
  const double damped = direct ? 0 : options.coupling_damping / mass;  // [1/s]
  const int most = compliance > 0 ? kMostOfMoving : kMostSubsteps;
  for (int steps = 1; steps <= most; ++steps) {
    const double h = options.tick / steps;
    const bool page_holds = compliance == 0 || h * h * both < kMovingPage;
    if (h * h * rate < 1 && h * damped < 1 && page_holds) return steps;
  }
  const double finest = options.tick / most;
  if (finest * finest * rate < 1 && finest * damped < 1) {
    throw InputError(fmt::format(
        "the page's body is too light: {:.3g} g where it gives way most, under {:.0f} N/m; make it "
        "heavier or round the letters more",
        1000 / compliance, page));
  }
  throw InputError(fmt::format(
      "too stiff: {:.0f} N/m, {:.0f} N s/m on {:.0f} g, over {} steps in {:g} ms: round it more",
      rate * mass, options.coupling_damping, 1000 * mass, most, 1000 * options.tick));
}

/// Of an object with these labels.
int StepsFor(const SceneOptions& options, const FeltObject& object,
             const std::vector<LabelOnSolid>& labels, double mass) {
  const double shrink =
      ShrinkAt(object.solid, ThroughDepthOn(object.solid, object.surface, labels));
  for (const LabelOnSolid& label : labels) {
    if (label.field == nullptr) continue;
    CheckFriction(options, shrink * label.stretch * label.field->greatest_slope());
  }
  return StepsFor(options, StiffnessOn(object.solid, object.surface, labels), mass,
                  object.compliance);
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

Scene::Impl::Impl(LoadedModel loaded_model, DataPtr data, const SceneOptions& scene_options,
                  const std::string& name, bool anew)
    : loaded(std::move(loaded_model)),
      options(scene_options),
      d(std::move(data)),
      caller_qfrc(static_cast<std::size_t>(loaded.m->nv), 0.0),
      own_qpos(loaded.m->opt.integrator == mjINT_RK4 ? static_cast<std::size_t>(loaded.m->nq) : 0),
      name_(name) {
  mjModel& m = *loaded.m;
  if (std::abs(m.opt.timestep - options.tick) > 1e-12) {
    loaded.remarks.push_back(fmt::format("time step: {:g} ms instead of the model's {:g} ms",
                                         1000 * options.tick, 1000 * m.opt.timestep));
  }
  if ((m.opt.disableflags & mjDSBL_GRAVITY) == 0) {
    lift_W = -loaded.proxy.weight_mass *
             glm::dvec3(m.opt.gravity[0], m.opt.gravity[1], m.opt.gravity[2]);
  }
  if (anew) {
    SetOptions(scene_options);
    return;
  }
  coupling = {options.coupling_stiffness, options.coupling_damping};
  FindObjects();
  memory.tip_W = ProxyPosition();
}

void Scene::Impl::SetOptions(const SceneOptions& new_options) {
  const double tick = options.tick, tilt = options.tilt;
  const std::size_t label = options.label;
  const Unlabelled unlabelled = options.unlabelled;
  options = new_options;
  options.tick = tick;
  options.unlabelled = unlabelled;
  options.tilt = tilt;
  options.label = label;
  coupling = {options.coupling_stiffness, options.coupling_damping};
  mj_resetData(loaded.m.get(), d.get());
  mj_forward(loaded.m.get(), d.get());
  FindObjects();
  Reset({0, 0, 0.02});
}

void Scene::Impl::FindObjects() {
  objects = FeltObjects(*loaded.m, *d, loaded.labels, options, name_);
  reactions.assign(objects.size(), {0, 0, 0});
  sides.assign(objects.size(), {});
  FindPage();
  SetField(nullptr);
}

Scene::Impl::Carrier Scene::Impl::CarrierOf(std::size_t label) const noexcept {
  Carrier carrier;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t k = 0; k < objects[i].numbers.size(); ++k) {
      if (objects[i].numbers[k] == label) carrier = {i, k};
    }
  }
  return carrier;
}

/// Which object carries the page, and how that lies on it.
void Scene::Impl::FindPage() noexcept {
  const Carrier carrier = CarrierOf(options.label);
  page_object = carrier.object;
  page_number = carrier.number;
  touched = page_object;
  page_geom = page().geom;
  pushes = std::any_of(objects.begin(), objects.end(),
                       [](const FeltObject& object) { return object.pushed; });
  page_only = objects.size() == 1 && page().IsPage();
  const LabelChart& chart = page_label().chart;
  flat = chart.place().face != Face::kRound;
  X_GP = {};
  turned = false;
  rests = flat && !page().moves;
  if (!flat) return;
  const glm::dvec3 origin = chart.ToObject({0, 0, 0});
  const LabelChart::Point at = chart.At(origin);
  X_GP = Pose{{at.dx_O, at.dy_O, glm::cross(at.dx_O, at.dy_O)}, origin};
  turned = X_GP.R != glm::dmat3(1.0);
  X_WP = PoseOfPage({0, 0, 0});
}

ReadyPage Scene::Impl::MakeReady(std::size_t label, const TextureField* field,
                                 const Box& text_P) const {
  static const TextureField blank;
  const Carrier carrier = CarrierOf(label);
  const FeltObject& object = objects[carrier.object];
  ReadyPage page;
  page.label = label;
  page.laid = Lay(loaded.labels[label], object.solid, field != nullptr ? field : &blank, text_P);
  page.text_P = text_P;
  std::vector<LabelOnSolid> labels = object.labels;
  labels[carrier.number] = page.laid;
  page.substeps = StepsFor(options, object, labels, loaded.proxy.mass);
  return page;
}

void Scene::Impl::SetField(const TextureField* new_field) {
  MakeReady(options.label, new_field, options.text_P);
  objects[page_object].labels[page_number].field = new_field;
  objects[page_object].Settle();
  TakeSteps();
}

void Scene::Impl::SetLabel(const LaidLabel& laid) {
  for (FeltObject& object : objects) {
    for (std::size_t k = 0; k < object.numbers.size(); ++k) {
      if (object.numbers[k] != laid.label) continue;
      object.labels[k] =
          Lay(loaded.labels[laid.label], object.solid, laid.field.get(), laid.text_P);
      object.Settle();
    }
  }
  TakeSteps();
}

void Scene::Impl::TakeSteps() {
  substeps = 1;
  for (FeltObject& object : objects) {
    object.steps = StepsFor(options, object, object.labels, loaded.proxy.mass);
    substeps = std::max(substeps, object.steps);
  }
  free_substeps = StepsFor(options, 0, loaded.proxy.mass, 0);
  steps_taken = 0;
  loaded.m->opt.timestep = options.tick / substeps;
  memory.stored_jumped = 1;
  remarks = loaded.remarks;
  if (substeps > 1) {
    remarks.push_back(fmt::format("{} sub-steps a tick: the page is stiff", substeps));
  }
}

PagePoint Scene::Impl::PointOn(glm::dvec3 p_P) const noexcept {
  const Pose X_WG = PoseOfGeom(*d, page().geom);
  if (flat) {
    const Pose lies = PoseOfPage({0, 0, 0});
    return {ToWorld(lies, p_P), lies.R};
  }
  const LabelChart& chart = page_label().chart;
  // towards its axis lengths shrink to nothing, and beyond it they run backwards; there a tip is
  // through it already
  constexpr double kDeepest = 1.6;  // of GreatestDepth
  p_P.z = std::max(p_P.z, -kDeepest * GreatestDepth(page().solid));
  const glm::dvec3 p_O = chart.ToObject(p_P);
  const LabelChart::Point at = chart.At(p_O);
  const glm::dmat3 gradients(at.dx_O, at.dy_O, chart.Above(p_O).normal_O);
  return {ToWorld(X_WG, p_O), X_WG.R * glm::transpose(glm::inverse(gradients))};
}

void Scene::Impl::Reset(glm::dvec3 tip_P) {
  mj_resetData(loaded.m.get(), d.get());
  const std::vector<double> begin(d->qpos, d->qpos + loaded.m->nq);
  mj_kinematics(loaded.m.get(), d.get());
  memory = TickMemory();
  touched = page_object;
  std::fill(sides.begin(), sides.end(), Sides());
  memory.tip_W = PointOn(tip_P).p_W;
  PlaceProxy(memory.tip_W, {0, 0, 0});
  if (loaded.proxy.handle_mocap >= 0) {
    for (int i = 0; i < 3; ++i) {
      d->mocap_pos[3 * loaded.proxy.handle_mocap + i] = memory.tip_W[i];
    }
  }
  mj_forward(loaded.m.get(), d.get());
  // as MuJoCo begins by itself: quaternions as they are in the model, solvers from zero
  std::copy(begin.begin(), begin.end(), d->qpos);
  PlaceProxy(memory.tip_W, {0, 0, 0});
  std::fill_n(d->qacc_warmstart, loaded.m->nv, 0.0);
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
  LoadedModel loaded = LoadModel(ReadTextFile(path, kGreatestModel), folder, path, options.tilt,
                                 options.label, options.unlabelled);
  if (shipped) loaded.remarks.clear();  // what it lacks, it lacks on purpose
  DataPtr data = MakeData(*loaded.m, path);
  return Scene(std::make_unique<Impl>(std::move(loaded), std::move(data), options, path, true));
}

Scene Scene::FromXml(const std::string& xml, const std::string& name, const SceneOptions& options) {
  Check(options);
  LoadedModel loaded = LoadModel(xml, "", name, options.tilt, options.label, options.unlabelled);
  DataPtr data = MakeData(*loaded.m, name);
  return Scene(std::make_unique<Impl>(std::move(loaded), std::move(data), options, name, true));
}

Scene Scene::Bind(mjModel_* m, mjData_* d, std::string xml, const std::string& name,
                  const SceneOptions& options) {
  Check(options);
  LoadedModel loaded =
      AdoptModel(ModelPtr(m, DeleteModel{true}), std::move(xml), name, options.label);
  return Scene(std::make_unique<Impl>(std::move(loaded), DataPtr(d, DeleteData{true}), options,
                                      name, false));
}

void Scene::SetOptions(const SceneOptions& options) {
  Check(options);
  impl_->SetOptions(options);
}
void Scene::SetField(const TextureField* field) { impl_->SetField(field); }
void Scene::SetLabel(const LaidLabel& laid) { impl_->SetLabel(laid); }
ReadyPage Scene::MakeReady(std::size_t label, const TextureField* field, const Box& text_P) const {
  return impl_->MakeReady(label, field, text_P);
}
void Scene::Swap(const ReadyPage& page) noexcept { impl_->Swap(page); }
void Scene::Restart() noexcept { impl_->Restart(); }
TickResult Scene::Tick(const DeviceState& input, bool delivered) noexcept {
  return impl_->Tick(input, delivered);
}
void Scene::Reset(glm::dvec3 tip_P) { impl_->Reset(tip_P); }

const std::vector<Label>& Scene::labels() const { return impl_->loaded.labels; }
const Label& Scene::page_label() const { return labels()[options().label]; }
Pose Scene::X_WP() const { return impl_->PoseOfPage(impl_->memory.tip_W); }
PagePoint Scene::PointOn(glm::dvec3 p_P) const noexcept { return impl_->PointOn(p_P); }
bool Scene::page_is_flat() const { return impl_->flat; }
bool Scene::page_goes() const { return impl_->page().moves; }
bool Scene::page_falls() const { return impl_->page().free; }
bool Scene::page_moves() const {
  return std::any_of(impl_->objects.begin(), impl_->objects.end(),
                     [](const FeltObject& object) { return object.moves; });
}
glm::dvec2 Scene::page_extent() const { return ExtentOf(page_label(), impl_->page().solid); }
std::vector<Solid> Scene::solids() const {
  std::vector<Solid> solids(labels().size());
  for (const FeltObject& object : impl_->objects) {
    for (const std::size_t number : object.numbers) solids[number] = object.solid;
  }
  return solids;
}
const SceneOptions& Scene::options() const { return impl_->options; }
const std::string& Scene::model_xml() const { return impl_->loaded.xml; }
const std::vector<std::string>& Scene::remarks() const { return impl_->remarks; }
int Scene::substeps() const { return impl_->substeps; }
double Scene::proxy_mass() const { return impl_->loaded.proxy.mass; }
double Scene::force_bound(const Movement& movement) const {
  if (page_moves()) return std::numeric_limits<double>::infinity();
  return ForceBound(options(), proxy_mass(), movement, substeps());
}
double Scene::groove_press() const { return impl_->page().law.sideways; }
double Scene::carried_press() const {
  const FeltObject& page = impl_->page();
  return CarriedPressOn(page.solid, page.surface, page.labels);
}
double Scene::gives(int geom) const noexcept {
  const mjModel& m = *impl_->loaded.m;
  const int body = geom >= 0 ? m.geom_bodyid[geom] : 0;
  if (m.body_jntnum[body] != 1) return 0;
  const int joint = m.body_jntadr[body];
  const bool one_way = m.jnt_type[joint] == mjJNT_SLIDE || m.jnt_type[joint] == mjJNT_HINGE;
  if (m.jnt_limited[joint] == 0 || !one_way) return 0;
  const int q = m.jnt_qposadr[joint];
  const mjtNum* range = m.jnt_range + std::ptrdiff_t{2} * joint;
  const double rest = m.qpos0[q];
  const double most = std::max(std::abs(range[0] - rest), std::abs(range[1] - rest));
  return most > 0 ? std::abs(impl_->d->qpos[q] - rest) / most : 0;
}
const mjModel_* Scene::model() const { return impl_->loaded.m.get(); }
mjData_* Scene::data() { return impl_->d.get(); }
const mjData_* Scene::data() const { return impl_->d.get(); }
int Scene::geom_of(std::size_t number) const {
  return impl_->objects[impl_->CarrierOf(number).object].geom;
}
const LabelOnSolid& Scene::laid(std::size_t number) const {
  const Impl::Carrier carrier = impl_->CarrierOf(number);
  return impl_->objects[carrier.object].labels[carrier.number];
}

std::vector<double> Scene::State() const {
  std::vector<double> state;
  VisitState(*impl_->loaded.m, *impl_->d, [&state](const mjtNum* values, std::size_t count) {
    state.insert(state.end(), values, values + count);
  });
  state.resize(state.size() + kMemoryDoubles);
  std::memcpy(state.data() + state.size() - kMemoryDoubles, &impl_->memory, sizeof(TickMemory));
  if (impl_->page_only) return state;
  state.push_back(static_cast<double>(impl_->touched));
  for (const Sides& sides : impl_->sides) {
    for (int i = 0; i < 3; ++i) state.push_back(sides.of[i]);
  }
  return state;
}

void Scene::SetState(const std::vector<double>& state) {
  const std::size_t more = impl_->page_only ? 0 : 1 + 3 * impl_->sides.size();
  std::size_t expected = kMemoryDoubles + more;
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
  if (more > 0) {
    next += kMemoryDoubles;
    const double kept = *next++;
    const bool sound = kept >= 0 && kept < static_cast<double>(impl_->objects.size());
    impl_->touched = sound ? static_cast<std::size_t>(kept) : impl_->page_object;
    for (Sides& sides : impl_->sides) {
      for (int i = 0; i < 3; ++i) sides.of[i] = *next++;
    }
  }
  mj_kinematics(impl_->loaded.m.get(), impl_->d.get());
}

}  // namespace moontrace
