#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "textures/field/element.h"

namespace moontrace {

/// From where the page is looked at: a point of it in the picture's middle, from the reader's side.
struct PageCamera {
  glm::dvec2 at_P{0, 0};  ///< [m]
  double height = 0.1;    ///< of page that the picture's height shows at `at_P`, level [m]
  double lean = 0;        ///< from straight above towards the reader's eye, 0 to 1.2 [rad]
};

/// Angle of view from lower to upper edge [rad].
inline constexpr double kFieldOfView = 0.6;

/// Distance of the eye from `at_P` [m].
double EyeDistance(const PageCamera& camera);

/// The rectangle of the page's plane that holds all that is seen, at most eight picture heights
/// each way. `aspect`: width over height of the picture.
Box VisibleBox(const PageCamera& camera, double aspect);

/// The point of the page's plane under a point of the picture (0..1 from its lower left corner).
glm::dvec2 PointUnder(const PageCamera& camera, double aspect, glm::dvec2 share);

/// Where a point is seen in the picture; of the page's plane the reverse of PointUnder. None behind
/// the eye.
std::optional<glm::dvec2> ShareOf(const PageCamera& camera, double aspect, glm::dvec3 p_P);
inline std::optional<glm::dvec2> ShareOf(const PageCamera& camera, double aspect, glm::dvec2 p_P) {
  return ShareOf(camera, aspect, glm::dvec3(p_P, 0));
}

/// The same page point stays under `share` while the view shrinks by `factor` (zooms in below 1);
/// 2 mm to 2 m of page.
PageCamera Zoomed(const PageCamera& camera, double aspect, glm::dvec2 share, double factor);

/// The camera that shows a whole box.
PageCamera CameraOn(const Box& box_P, double aspect, double lean = 0);

}  // namespace moontrace
