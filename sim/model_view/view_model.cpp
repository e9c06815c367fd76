#include "sim/model_view/view_model.h"

#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr std::string_view kWhole = "whole", kTip = "tip", kOwn = "moontrace_";

void AddName(std::vector<std::string>& names, std::string name) {
  if (name.empty() || name.starts_with(kOwn)) return;
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
}

void AddNames(const mjModel& m, int type, int count, std::vector<std::string>& names) {
  for (int i = 0; i < count; ++i) AddName(names, NameOf(m, type, i));
}

}  // namespace

std::string NameOf(const mjModel& m, int type, int number) {
  const char* name = mj_id2name(&m, type, number);
  return name == nullptr ? std::string() : std::string(name);
}

const char* KindOfGeom(const mjModel& m, int geom) {
  switch (m.geom_type[geom]) {
    case mjGEOM_PLANE:
      return "plane";
    case mjGEOM_HFIELD:
      return "height field";
    case mjGEOM_SPHERE:
      return "sphere";
    case mjGEOM_CAPSULE:
      return "capsule";
    case mjGEOM_ELLIPSOID:
      return "ellipsoid";
    case mjGEOM_CYLINDER:
      return "cylinder";
    case mjGEOM_BOX:
      return "box";
    case mjGEOM_MESH:
      return "mesh";
    default:
      return "shape";
  }
}

namespace {

ModelPtr CopyOf(const mjModel* m) {
  ModelPtr copy(mj_copyModel(nullptr, m));
  if (!copy) throw InputError("the model takes too much memory to be shown; make it smaller");
  return copy;
}

}  // namespace

std::shared_ptr<const ViewModel> MakeViewModel(const Scene& scene,
                                               const std::vector<LaidLabel>& others,
                                               std::string_view text) {
  auto view = std::make_shared<ViewModel>();
  view->m = CopyOf(scene.model());
  view->page = scene.options().label;
  for (std::size_t i = 0; i < scene.labels().size(); ++i) {
    const Label& label = scene.labels()[i];
    ViewModel::Label shown;
    shown.name = NameOf(label);
    shown.text = i == view->page ? std::string(text) : label.text;
    shown.geom = scene.geom_of(i);
    shown.drawn = label.named;
    shown.lift = label.error;
    shown.solid = SolidOf(*view->m, shown.geom).value_or(Solid());
    shown.chart = scene.laid(i).chart;
    if (i == view->page) shown.text_P = scene.options().text_P;
    for (const LaidLabel& other : others) {
      if (other.label != i) continue;
      shown.field = other.field;
      shown.text_P = other.text_P;
    }
    view->labels.push_back(std::move(shown));
  }
  const mjModel& m = *view->m;
  view->proxy_body = mj_name2id(&m, mjOBJ_BODY, "moontrace_proxy");
  view->handle_body = mj_name2id(&m, mjOBJ_BODY, "moontrace_handle");
  if (view->handle_body >= 0) view->mocap = m.body_mocapid[view->handle_body];
  TakePose(scene, view->start);
  return view;
}

std::shared_ptr<const ViewModel> WithPage(const ViewModel& model, const LaidLabel& before,
                                          const Label& label, const LaidLabel& page,
                                          std::string_view text) {
  auto view = std::make_shared<ViewModel>();
  view->m = CopyOf(model.m.get());
  view->labels = model.labels;
  view->page = page.label;
  view->proxy_body = model.proxy_body;
  view->handle_body = model.handle_body;
  view->mocap = model.mocap;
  view->start = model.start;
  view->labels[before.label].field = before.field;
  view->labels[before.label].text_P = before.text_P;
  ViewModel::Label& shown = view->labels[page.label];
  shown.text = text;
  shown.field = nullptr;  // the page's
  shown.text_P = page.text_P;
  shown.chart = LabelChart(shown.solid, PlaceOn(label, shown.solid, page.text_P));
  return view;
}

ViewTarget FindTarget(const ViewModel& model, std::string_view name) {
  using Kind = ViewTarget::Kind;
  const mjModel& m = *model.m;
  const std::string given(name);
  for (std::size_t i = 0; i < model.labels.size(); ++i) {
    if (model.labels[i].name == given) return {Kind::kLabel, static_cast<int>(i)};
  }
  const int geom = mj_name2id(&m, mjOBJ_GEOM, given.c_str());
  for (std::size_t i = 0; geom >= 0 && i < model.labels.size(); ++i) {
    if (model.labels[i].drawn == geom) return {Kind::kLabel, static_cast<int>(i)};
  }
  if (geom >= 0) return {Kind::kGeom, geom};
  if (const int body = mj_name2id(&m, mjOBJ_BODY, given.c_str()); body >= 0) {
    return {Kind::kBody, body};
  }
  if (const int camera = mj_name2id(&m, mjOBJ_CAMERA, given.c_str()); camera >= 0) {
    return {Kind::kCamera, camera};
  }
  if (given == kWhole) return {};
  if (given == kTip) return {Kind::kTip, 0};
  const std::string shown = OneLine(given, 60);
  const std::string nearest = NearestName(given, TargetNames(model));
  if (nearest.empty()) {
    throw InputError(fmt::format(
        "the model has nothing named '{}' to look at: name a label, geom, body or camera", shown));
  }
  throw InputError(fmt::format("the model has nothing named '{}' to look at: did you mean {}?",
                               shown, OneLine(nearest, 60)));
}

std::vector<std::string> TargetNames(const ViewModel& model) {
  const mjModel& m = *model.m;
  std::vector<std::string> names;
  for (const ViewModel::Label& label : model.labels) {
    if (!label.text.empty()) AddName(names, label.name);
  }
  AddNames(m, mjOBJ_GEOM, static_cast<int>(m.ngeom), names);
  AddNames(m, mjOBJ_BODY, static_cast<int>(m.nbody), names);
  AddNames(m, mjOBJ_CAMERA, static_cast<int>(m.ncam), names);
  AddName(names, std::string(kWhole));
  AddName(names, std::string(kTip));
  return names;
}

}  // namespace moontrace
