#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/physics/pose.h"
#include "textures/objects/solid.h"

namespace moontrace {

/// A surface of triangles. Frame F: the mesh's own.
struct TriangleMesh {
  std::vector<glm::dvec3> points;  ///< [m]
  std::vector<std::array<std::size_t, 3>>
      faces;  ///< numbers of points, counter-clockwise from outside
};

/// The solid that a part of a mesh is close to.
struct FittedSolid {
  Solid solid;               ///< a box, of which the top is the flat part; a cylinder; a sphere
  Pose X_FO;                 ///< of the solid
  double error = 0;          ///< greatest distance of that part from the solid's surface [m]
  glm::dvec2 on_face{0, 0};  ///< the place that was asked for, on the solid's face [m]
  double turn = 0;           ///< from the face's u to the right hand, to the left [rad]
};

/// A fit, or one line that says why there is none.
struct Fit {
  std::optional<FittedSolid> solid;
  std::string why;
};

/// Fits the part of the mesh that is met from `from_F` along `along_F` (unit), seen with `right_F`
/// to the right. Flat to 0.1 mm: the largest rectangle within that part, as deep as the mesh is
/// there. Round to 0.5 mm and 3 % of the radius, facets counted, and nearly closed: a cylinder or a
/// sphere. Whatever covers most wins. Other parts of the mesh do not matter. Time grows with the
/// triangles times their logarithm.
Fit FitSolid(const TriangleMesh& mesh, glm::dvec3 from_F, glm::dvec3 along_F, glm::dvec3 right_F);

}  // namespace moontrace
