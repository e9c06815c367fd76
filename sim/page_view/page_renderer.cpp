#include "sim/page_view/page_renderer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "sim/physics/mujoco_compat.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr int kMostGeoms = 20000;
constexpr double kDegrees = 57.29577951308232;
constexpr double kUnitsPerNewton = 14;  // of a drawn arrow, in hundredths of the picture
constexpr double kLeastArrow = 0.02;    // forces below are not drawn [N]

/// A box as thin as paper that carries the shaded picture, lit so that it is shown as it is.
std::string ModelXml(const RendererSize& size) {
  return fmt::format(
      "<mujoco><visual><global offwidth='{0}' offheight='{1}' fovy='{2:.9g}'/>"
      "<quality shadowsize='0' offsamples='0'/>"
      "<headlight ambient='1 1 1' diffuse='0 0 0' specular='0 0 0'/>"
      "<map znear='0.001' zfar='100'/></visual><statistic center='0 0 0' extent='0.3'/>"
      "<asset><texture name='page' type='2d' builtin='flat' width='{0}' height='{1}' "
      "rgb1='1 1 1'/><material name='page' texture='page' texuniform='false' texrepeat='1 1' "
      "emission='0' specular='0' shininess='0' reflectance='0'/></asset>"
      "<worldbody><geom name='page' type='box' size='1 1 1' contype='0' conaffinity='0' "
      "material='page'/></worldbody></mujoco>",
      size.width, size.height, kFieldOfView * kDegrees);
}

void SetColor(mjvGeom& geom, const Color& color, double alpha) {
  geom.rgba[0] = static_cast<float>(color.red);
  geom.rgba[1] = static_cast<float>(color.green);
  geom.rgba[2] = static_cast<float>(color.blue);
  geom.rgba[3] = static_cast<float>(alpha);
}

/// Adds shapes to MuJoCo's scene; what does not fit is left out.
class Pen {
 public:
  /// `unit` [m]: a hundredth of the picture's height, for what has no size of its own.
  Pen(mjvScene& scene, double unit) : scene_(scene), unit_(unit) {}

  void Ball(glm::dvec3 p_P, double radius, const Color& color, double alpha) {
    mjvGeom* geom = Next();
    if (geom == nullptr) return;
    const mjtNum size[3] = {radius, radius, radius}, at[3] = {p_P.x, p_P.y, p_P.z};
    const float rgba[4] = {1, 1, 1, 1};
    mjv_initGeom(geom, mjGEOM_SPHERE, size, at, nullptr, rgba);
    SetColor(*geom, color, alpha);
  }

  void Segment(glm::dvec3 from, glm::dvec3 to, int type, double width, const Color& color) {
    mjvGeom* geom = Next();
    if (geom == nullptr) return;
    const float rgba[4] = {1, 1, 1, 1};
    mjv_initGeom(geom, type, nullptr, nullptr, nullptr, rgba);
    const double a[3] = {from.x, from.y, from.z}, b[3] = {to.x, to.y, to.z};
    Connect(*geom, type, width, a, b);
    SetColor(*geom, color, 1);
  }

  void Arrow(glm::dvec3 from, glm::dvec3 force, const Color& color) {
    if (glm::length(force) < kLeastArrow) return;
    Segment(from, from + kUnitsPerNewton * unit_ * force, mjGEOM_ARROW, 0.4 * unit_, color);
  }

 private:
  mjvGeom* Next() {
    if (scene_.ngeom >= scene_.maxgeom) return nullptr;
    mjvGeom* geom = scene_.geoms + scene_.ngeom++;
    std::memset(geom, 0, sizeof *geom);
    geom->category = mjCAT_DECOR;
    return geom;
  }

  mjvScene& scene_;
  double unit_;
};

void AddMarks(mjvScene& scene, const PageCamera& camera, const ViewMarks& marks) {
  const double unit = 0.01 * camera.height;
  Pen pen(scene, unit);
  if (marks.bead_P) {
    pen.Ball(glm::dvec3(*marks.bead_P, 0), 0.9 * unit, view_color::kGuidance, 0.8);
  }
  if (marks.proxy_P) pen.Ball(*marks.proxy_P, 0.7 * unit, view_color::kForce, 1);
  if (!marks.tip_P) return;
  const glm::dvec3 tip = *marks.tip_P;
  // above the paper, which is drawn flat and would hide what lies in a groove
  const glm::dvec3 foot(tip.x, tip.y, std::max(tip.z, 0.0));
  const glm::dvec3 seen = foot + glm::dvec3(0, 0, 0.8 * unit);
  pen.Arrow(seen, marks.force_P, view_color::kForce);
  pen.Arrow(seen, marks.guidance_P, view_color::kGuidance);
}

}  // namespace

struct PageRenderer::State {
  RendererSize size;
  Color desk{0.46, 0.34, 0.24};
  ModelPtr m;
  DataPtr d;
  mjvScene scene;
  mjrContext context;
  mjvOption option;
  Box surface_P;

  explicit State(const RendererSize& wanted) : size(wanted) {
    std::string warning;
    m = CompileMjcf(ModelXml(size), "view.xml", "view", warning);
    d = MakeData(*m, "view");
    mj_forward(m.get(), d.get());
    mjv_defaultScene(&scene);
    mjv_makeScene(m.get(), &scene, kMostGeoms);
    mjv_defaultOption(&option);
    for (const mjtRndFlag flag : {mjRND_SHADOW, mjRND_REFLECTION, mjRND_SKYBOX, mjRND_HAZE}) {
      scene.flags[flag] = 0;
    }
    mjr_defaultContext(&context);
    mjr_makeContext(m.get(), &context, mjFONTSCALE_50);
  }
  ~State() {
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void Draw(const PageCamera& camera, const ViewMarks& marks, mjrRect rect) {
    mjvCamera eye;
    mjv_defaultCamera(&eye);
    eye.lookat[0] = camera.at_P.x;
    eye.lookat[1] = camera.at_P.y;
    eye.lookat[2] = 0;
    eye.distance = EyeDistance(camera);
    eye.azimuth = 90;
    eye.elevation = -90 + camera.lean * kDegrees;
    mjv_updateScene(m.get(), d.get(), &option, nullptr, &eye, mjCAT_ALL, &scene);
    if (scene.ngeom > 0) LaySurface(scene.geoms[0]);
    const Box seen = VisibleBox(camera, static_cast<double>(rect.width) / rect.height);
    if (!Contains(surface_P, seen.min) || !Contains(surface_P, seen.max)) LayDesk();
    AddMarks(scene, camera, marks);
    mjr_render(rect, &scene, &context);
  }

  /// Below the surface, wherever it does not reach.
  void LayDesk() {
    constexpr double kFar = 30;  // [m]
    mjvGeom& geom = scene.geoms[scene.ngeom++];
    const mjtNum half[3] = {kFar, kFar, 1e-5}, at[3] = {0, 0, -2e-3};
    const float rgba[4] = {1, 1, 1, 1};
    mjv_initGeom(&geom, mjGEOM_BOX, half, at, nullptr, rgba);
    geom.category = mjCAT_DECOR;
    SetColor(geom, desk, 1);
  }

  void LaySurface(mjvGeom& geom) const {
    constexpr float kThin = 1e-5F;  // [m]
    const glm::dvec2 middle = 0.5 * (surface_P.min + surface_P.max);
    const glm::dvec2 half = 0.5 * (surface_P.max - surface_P.min);
    geom.size[0] = static_cast<float>(half.x);
    geom.size[1] = static_cast<float>(half.y);
    geom.size[2] = kThin;
    geom.pos[0] = static_cast<float>(middle.x);
    geom.pos[1] = static_cast<float>(middle.y);
    geom.pos[2] = -kThin;
  }
};

PageRenderer::PageRenderer(const RendererSize& size) : state_(std::make_unique<State>(size)) {}
PageRenderer::~PageRenderer() = default;
PageRenderer::PageRenderer(PageRenderer&&) noexcept = default;
PageRenderer& PageRenderer::operator=(PageRenderer&&) noexcept = default;

const RendererSize& PageRenderer::size() const { return state_->size; }

void PageRenderer::SetSurface(const Raster& raster, const Box& covers_P) {
  mjModel& m = *state_->m;
  const auto most =
      static_cast<std::size_t>(state_->size.width) * static_cast<std::size_t>(state_->size.height);
  if (raster.width * raster.height > most) return;
  m.tex_width[0] = static_cast<int>(raster.width);
  m.tex_height[0] = static_cast<int>(raster.height);
  std::memcpy(TextureBytes(m, 0), raster.rgb.data(), raster.rgb.size());
  mjr_uploadTexture(&m, &state_->context, 0);
  state_->surface_P = covers_P;
}

void PageRenderer::SetDesk(const Color& color) { state_->desk = color; }

void PageRenderer::Aim(bool window) {
  mjr_setBuffer(window ? mjFB_WINDOW : mjFB_OFFSCREEN, &state_->context);
}

void PageRenderer::Draw(const PageCamera& camera, const ViewMarks& marks, int x, int y, int width,
                        int height) {
  state_->Draw(camera, marks, {x, y, width, height});
}

Raster PageRenderer::Picture() {
  const mjrRect rect = {0, 0, state_->size.width, state_->size.height};
  const auto width = static_cast<std::size_t>(rect.width);
  const auto height = static_cast<std::size_t>(rect.height);
  std::vector<unsigned char> bottom_up(3 * width * height);
  mjr_readPixels(bottom_up.data(), nullptr, rect, &state_->context);
  Raster raster{width, height, std::vector<std::uint8_t>(bottom_up.size())};
  for (std::size_t row = 0; row < height; ++row) {
    std::copy_n(&bottom_up[3 * width * (height - 1 - row)], 3 * width,
                &raster.rgb[3 * width * row]);
  }
  return raster;
}

Raster PageRenderer::DrawToPicture(const PageCamera& camera, const ViewMarks& marks) {
  Aim(false);
  Draw(camera, marks, 0, 0, state_->size.width, state_->size.height);
  return Picture();
}

}  // namespace moontrace
