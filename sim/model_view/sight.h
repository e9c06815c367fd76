#pragma once

#include <mujoco/mujoco.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>

namespace moontrace {

/// How a camera sees the world, as MuJoCo draws it: from points of the world to points of the
/// picture and back.
class Sight {
 public:
  Sight() = default;
  /// What a scene was updated for last; `aspect` of the picture, width over height.
  Sight(const mjvScene& scene, double aspect);

  glm::dvec3 eye_W{0, 0, 0};  ///< [m]
  glm::dvec3 forward_W{0, 1, 0}, right_W{1, 0, 0}, up_W{0, 0, 1};

  /// Towards the eye from a point, unit.
  glm::dvec3 ToEye(glm::dvec3 p_W) const;
  /// How far before the eye [m].
  double DepthOf(glm::dvec3 p_W) const;
  /// Where in the picture, 0 to 1 from its lower left corner, beside it beyond; none: behind the
  /// eye.
  std::optional<glm::dvec2> ShareOf(glm::dvec3 p_W) const;
  /// What lies under a point of the picture: a ray from the eye.
  struct Ray {
    glm::dvec3 from_W{0, 0, 0}, along_W{0, 0, 1};  ///< [m]
  };
  Ray RayUnder(glm::dvec2 share) const;
  /// Of the world, at a point, that the picture's height shows [m].
  double HeightAt(glm::dvec3 p_W) const;
  /// OpenGL's clip coordinates, depth from -w to w, which grows from near to far, or where MuJoCo
  /// keeps it `reversed` from far to near.
  glm::dvec4 ClipOf(glm::dvec3 p_W, bool reversed) const;

 private:
  bool orthographic_ = false;
  double near_ = 0.01, far_ = 100;            ///< [m]
  glm::dvec2 middle_{0, 0}, half_{0.5, 0.5};  ///< of the picture on the near plane [m]
};

}  // namespace moontrace
