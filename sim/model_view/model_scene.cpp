#include "sim/model_view/model_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "sim/model_view/label_relief.h"
#include "sim/model_view/relief_gl.h"
#include "sim/physics/felt_object.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr int kMostMarks = 20000;
constexpr double kNearShare = 0.15;  // of the distance, before which nothing is cut away

/// Adds shapes to MuJoCo's scene; what does not fit is left out.
class Pen {
 public:
  explicit Pen(mjvScene& scene) : scene_(scene) {}

  void Add(const SceneMarks& marks) {
    for (const SceneMarks::Line& line : marks.lines) {
      Segment(mjGEOM_LINE, line.from_W, line.to_W, line.width, line.color);
    }
    for (const SceneMarks::Arrow& arrow : marks.arrows) {
      Segment(mjGEOM_ARROW, arrow.from_W, arrow.to_W, arrow.width, arrow.color);
    }
    for (const SceneMarks::Ball& ball : marks.balls) {
      const mjtNum size[3] = {ball.radius, ball.radius, ball.radius};
      const mjtNum at[3] = {ball.p_W.x, ball.p_W.y, ball.p_W.z};
      Next(mjGEOM_SPHERE, size, at, ball.color, ball.alpha);
    }
  }

 private:
  void Segment(int type, glm::dvec3 from, glm::dvec3 to, double width, const Color& color) {
    mjvGeom* geom = Next(type, nullptr, nullptr, color, 1);
    if (geom == nullptr) return;
    const double a[3] = {from.x, from.y, from.z}, b[3] = {to.x, to.y, to.z};
    Connect(*geom, type, width, a, b);
  }

  mjvGeom* Next(int type, const mjtNum* size, const mjtNum* at, const Color& color, double alpha) {
    if (scene_.ngeom >= scene_.maxgeom) return nullptr;
    mjvGeom* geom = scene_.geoms + scene_.ngeom++;
    std::memset(geom, 0, sizeof *geom);
    const float rgba[4] = {static_cast<float>(color.red), static_cast<float>(color.green),
                           static_cast<float>(color.blue), static_cast<float>(alpha)};
    mjv_initGeom(geom, type, size, at, nullptr, rgba);
    geom->category = mjCAT_DECOR;
    geom->emission = 0.6F;  // seen in the shade as well
    return geom;
  }

  mjvScene& scene_;
};

/// A label that may be seen, and what was made for it last.
struct Shown {
  std::size_t label = 0;
  std::shared_ptr<const TextureField> field;
  Box area_P;
  LabelRelief relief;
};

double LuminanceOf(const float rgba[4]) {
  return 0.2126 * rgba[0] + 0.7152 * rgba[1] + 0.0722 * rgba[2];
}

}  // namespace

struct ModelScene::State {
  std::shared_ptr<const ViewModel> view;
  int width, height;
  ModelPtr m;  // of its own: the size of pictures and the near plane are MuJoCo's to know
  DataPtr d;
  mjvScene scene;
  mjrContext context;
  mjvOption option;
  double near = 0;  // as the model has it
  bool tip = false, high_contrast = false;
  std::vector<Shown> labels;
  std::vector<DrawnPoint> points;
  std::vector<std::uint32_t> triangles;

  State(std::shared_ptr<const ViewModel> model, int to_width, int to_height)
      : view(std::move(model)), width(to_width), height(to_height) {
    m.reset(mj_copyModel(nullptr, view->m.get()));
    if (!m) throw LackError("the model takes too much memory to be shown");
    m->vis.global.offwidth = width;
    m->vis.global.offheight = height;
    near = m->vis.map.znear;
    d = MakeData(*m, "view");
    mjv_defaultScene(&scene);
    mjv_makeScene(m.get(), &scene, 4 * static_cast<int>(m->ngeom) + kMostMarks);
    mjv_defaultOption(&option);
    mjr_defaultContext(&context);
    mjr_makeContext(m.get(), &context, mjFONTSCALE_50);
    for (std::size_t i = 0; i < view->labels.size(); ++i) {
      const ViewModel::Label& label = view->labels[i];
      if (label.field != nullptr) labels.push_back({i, label.field, label.text_P, {}});
    }
  }
  ~State() {
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void Update(mjvCamera& eye);
  void HideTip();
  const mjvGeom* DrawnGeom(int geom) const;
  void DrawLabel(Shown& shown, const Sight& sight, mjrRect rect);
};

void ModelScene::State::Update(mjvCamera& eye) {
  if (eye.type == mjCAMERA_FREE) {
    const double nearest = kNearShare * eye.distance / std::max(m->stat.extent, 1e-9);
    m->vis.map.znear = static_cast<float>(std::min(near, nearest));
  } else {
    m->vis.map.znear = static_cast<float>(near);
  }
  mjv_updateScene(m.get(), d.get(), &option, nullptr, &eye, mjCAT_ALL, &scene);
  if (!tip) HideTip();
}

/// Without a hand there is neither stylus nor proxy.
void ModelScene::State::HideTip() {
  const auto is_tip = [this](const mjvGeom& geom) {
    if (geom.objtype != mjOBJ_GEOM || geom.objid < 0) return false;
    const int body = m->geom_bodyid[geom.objid];
    return body == view->proxy_body || body == view->handle_body;
  };
  mjvGeom* end = std::remove_if(scene.geoms, scene.geoms + scene.ngeom, is_tip);
  scene.ngeom = static_cast<int>(end - scene.geoms);
}

/// None: it is not drawn.
const mjvGeom* ModelScene::State::DrawnGeom(int geom) const {
  const mjvGeom *begin = scene.geoms, *end = begin + scene.ngeom;
  const mjvGeom* found = std::find_if(begin, end, [geom](const mjvGeom& drawn) {
    return drawn.objtype == mjOBJ_GEOM && drawn.objid == geom;
  });
  return found == end ? nullptr : found;
}

void ModelScene::State::DrawLabel(Shown& shown, const Sight& sight, mjrRect rect) {
  const ViewModel::Label& label = view->labels[shown.label];
  const mjvGeom* geom = DrawnGeom(label.drawn);
  if (geom == nullptr || !(shown.area_P.min.x < shown.area_P.max.x)) return;
  const Pose X_WG = PoseOfGeom(*d, label.geom);
  const auto wanted = SeenOf(label.chart, label.solid, shown.area_P, X_WG, sight, rect.height);
  if (!wanted) return;
  if (!Serves(shown.relief.of, *wanted)) {
    shown.relief = MakeRelief(label.chart, *shown.field, *wanted, label.lift);
  }
  const double luminance = MayHaveTexture(*geom) ? 1 : LuminanceOf(geom->rgba);
  ShadeRelief(shown.relief, X_WG, sight, DepthIsReversed(),
              {scene.lights, static_cast<std::size_t>(scene.nlight)}, geom->emission,
              TintFor(luminance, high_contrast), points, triangles);
  DrawRelief(points, triangles, rect);
}

ModelScene::ModelScene(std::shared_ptr<const ViewModel> model, int width, int height)
    : camera(WholeModel(*model->m)),
      state_(std::make_unique<State>(std::move(model), width, height)) {
  SetPose(state_->view->start);
}
ModelScene::~ModelScene() = default;
ModelScene::ModelScene(ModelScene&&) noexcept = default;
ModelScene& ModelScene::operator=(ModelScene&&) noexcept = default;

const ViewModel& ModelScene::model() const { return *state_->view; }
const mjData& ModelScene::data() const { return *state_->d; }

void ModelScene::SetPose(const ScenePose& pose) {
  State& s = *state_;
  const auto fits = [](const std::vector<double>& values, auto count) {
    return values.size() == static_cast<std::size_t>(count);
  };
  if (!fits(pose.qpos, s.m->nq) || !fits(pose.mocap_pos, 3 * s.m->nmocap)) return;
  std::copy(pose.qpos.begin(), pose.qpos.end(), s.d->qpos);
  std::copy(pose.mocap_pos.begin(), pose.mocap_pos.end(), s.d->mocap_pos);
  std::copy(pose.mocap_quat.begin(), pose.mocap_quat.end(), s.d->mocap_quat);
  // a stylus that is never turned is held as a hand would hold it, out of the page
  mjtNum* turned =
      s.view->mocap >= 0 ? s.d->mocap_quat + std::ptrdiff_t{4} * s.view->mocap : nullptr;
  if (turned != nullptr && turned[0] == 1) {
    const glm::dvec3 z(0, 0, 1), normal_W = pose.X_WP.R[2];
    const mjtNum from[3] = {z.x, z.y, z.z}, to[3] = {normal_W.x, normal_W.y, normal_W.z};
    mjtNum axis[3];
    mju_cross(axis, from, to);
    const double sine = mju_normalize3(axis);
    const mjtNum across[3] = {1, 0, 0};
    const double angle = std::atan2(sine, normal_W.z);
    mju_axisAngle2Quat(turned, sine > 1e-9 ? axis : across, angle);
  }
  mj_fwdPosition(s.m.get(), s.d.get());
}

void ModelScene::SetPage(std::shared_ptr<const TextureField> field, const Box& area_P) {
  State& s = *state_;
  s.labels.erase(std::remove_if(s.labels.begin(), s.labels.end(),
                                [&s](const Shown& shown) { return shown.label == s.view->page; }),
                 s.labels.end());
  if (field != nullptr) s.labels.push_back({s.view->page, std::move(field), area_P, {}});
}

void ModelScene::ShowTip(bool shown) { state_->tip = shown; }
void ModelScene::SetHighContrast(bool wanted) { state_->high_contrast = wanted; }

Sight ModelScene::Look(double aspect) {
  state_->Update(camera);
  return {state_->scene, aspect};
}

void ModelScene::Aim(bool window) {
  mjr_setBuffer(window ? mjFB_WINDOW : mjFB_OFFSCREEN, &state_->context);
}

void ModelScene::Draw(const SceneMarks& marks, int x, int y, int width, int height) {
  State& s = *state_;
  const mjrRect rect = {x, y, width, height};
  const Sight sight = Look(static_cast<double>(width) / height);
  Pen(s.scene).Add(marks);
  mjr_render(rect, &s.scene, &s.context);
  LeaveNoTexture();
  for (Shown& shown : s.labels) s.DrawLabel(shown, sight, rect);
}

Raster ModelScene::Picture() {
  State& s = *state_;
  const mjrRect rect = {0, 0, s.width, s.height};
  const auto width = static_cast<std::size_t>(s.width), height = static_cast<std::size_t>(s.height);
  std::vector<unsigned char> bottom_up(3 * width * height);
  mjr_readPixels(bottom_up.data(), nullptr, rect, &s.context);
  Raster raster{width, height, std::vector<std::uint8_t>(bottom_up.size())};
  for (std::size_t row = 0; row < height; ++row) {
    std::copy_n(&bottom_up[3 * width * (height - 1 - row)], 3 * width,
                raster.rgb.begin() + static_cast<std::ptrdiff_t>(3 * width * row));
  }
  return raster;
}

}  // namespace moontrace
