#include "sim/model_view/sight.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "sim/physics/mujoco_compat.h"

namespace moontrace {

namespace {
glm::dvec3 Vector(const float v[3]) { return {v[0], v[1], v[2]}; }
}  // namespace

Sight::Sight(const mjvScene& scene, double aspect) {
  const mjvGLCamera camera = mjv_averageCamera(&scene.camera[0], &scene.camera[1]);
  eye_W = Vector(camera.pos);
  forward_W = glm::normalize(Vector(camera.forward));
  right_W = glm::normalize(glm::cross(forward_W, Vector(camera.up)));
  up_W = glm::cross(right_W, forward_W);
  orthographic_ = IsOrthographic(camera);
  near_ = camera.frustum_near;
  far_ = camera.frustum_far;
  const double top = camera.frustum_top, bottom = camera.frustum_bottom;
  middle_ = {camera.frustum_center, 0.5 * (top + bottom)};
  half_ = {HalfWidthOf(camera, aspect), 0.5 * (top - bottom)};
}

glm::dvec3 Sight::ToEye(glm::dvec3 p_W) const {
  return orthographic_ ? -forward_W : glm::normalize(eye_W - p_W);
}

double Sight::DepthOf(glm::dvec3 p_W) const { return glm::dot(p_W - eye_W, forward_W); }

std::optional<glm::dvec2> Sight::ShareOf(glm::dvec3 p_W) const {
  const glm::dvec4 clip = ClipOf(p_W, false);
  if (clip.w <= 0) return std::nullopt;
  return 0.5 + 0.5 * glm::dvec2(clip) / clip.w;
}

Sight::Ray Sight::RayUnder(glm::dvec2 share) const {
  const glm::dvec2 at = middle_ + (2.0 * share - 1.0) * half_;
  const glm::dvec3 across = at.x * right_W + at.y * up_W;
  if (orthographic_) return {eye_W + across, forward_W};
  return {eye_W, glm::normalize(near_ * forward_W + across)};
}

double Sight::HeightAt(glm::dvec3 p_W) const {
  return orthographic_ ? 2 * half_.y : 2 * half_.y * std::abs(DepthOf(p_W)) / near_;
}

glm::dvec4 Sight::ClipOf(glm::dvec3 p_W, bool reversed) const {
  const glm::dvec3 r = p_W - eye_W;
  const double x = glm::dot(r, right_W), y = glm::dot(r, up_W), z = glm::dot(r, forward_W);
  // 0 to w of what MuJoCo keeps in the depth buffer
  const double range = far_ - near_;
  if (orthographic_) {
    const double near_first = (z - near_) / range;
    return {(x - middle_.x) / half_.x, (y - middle_.y) / half_.y,
            2 * (reversed ? 1 - near_first : near_first) - 1, 1};
  }
  const double depth = (reversed ? near_ * (far_ - z) : far_ * (z - near_)) / range;
  return {(near_ * x - middle_.x * z) / half_.x, (near_ * y - middle_.y * z) / half_.y,
          2 * depth - z, z};
}

}  // namespace moontrace
