#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "sim/model_view/sight.h"
#include "sim/physics/pose.h"
#include "textures/field/field.h"
#include "textures/objects/label_chart.h"

namespace moontrace {

/// Labels as they are seen: a fine grid laid over the label's chart wherever its texture is other
/// than flat, in the geom's frame O, so that it moves with the geom. What MuJoCo drew of the geom
/// is multiplied by how much more or less light falls on the relief than on the smooth surface:
/// colours, textures and materials of the geom stay.

/// What of a page is to be drawn, and how finely.
struct ReliefArea {
  Box box_P;        ///< [m]
  double step = 0;  ///< between points of the grid [m]
};

/// What is seen of `area_P`, a point for each of the picture's; none: nothing is. `height`: of the
/// picture [points].
std::optional<ReliefArea> SeenOf(const LabelChart& chart, const Solid& solid, const Box& area_P,
                                 const Pose& X_WG, const Sight& sight, int height);

/// Whether what was made for one area shows another as well.
bool Serves(const ReliefArea& made, const ReliefArea& wanted);

struct ReliefPoint {
  glm::vec3 p_O{0, 0, 0};                          ///< ridges raised, grooves not sunk [m]
  glm::vec3 smooth_O{0, 0, 1}, relief_O{0, 0, 1};  ///< normals without and with texture
  float depth = 0;  ///< share of the field's greatest, below 0 in grooves
};

struct LabelRelief {
  ReliefArea of;
  std::vector<ReliefPoint> points;
  std::vector<std::uint32_t> triangles;  ///< three points each
};
/// `lift` [m] over the chart, where the geom that is seen lies off it.
LabelRelief MakeRelief(const LabelChart& chart, const TextureField& field, const ReliefArea& area,
                       double lift = 0);

/// How deep and high places are tinted beside their light, so that a groove is seen that light
/// falls straight into.
struct ReliefTint {
  glm::vec3 groove{0.36F, 0.39F, 0.45F};  ///< factors of the geom's colour
  glm::vec3 ridge{0.66F, 0.52F, 0.36F};
};
/// Dark things are not made darker. `luminance` of the geom, 0 to 1.
ReliefTint TintFor(double luminance, bool high_contrast);

/// A point as OpenGL takes it.
struct DrawnPoint {
  float clip[4];
  float factor[3];  ///< half of that of the geom's colour
};
/// Lights as MuJoCo's scene has them, by its own lighting without highlights; `emission` of the
/// geom. `drawn` and `triangles` are made anew: without what is turned away.
void ShadeRelief(const LabelRelief& relief, const Pose& X_WG, const Sight& sight, bool reversed,
                 std::span<const mjvLight> lights, double emission, const ReliefTint& tint,
                 std::vector<DrawnPoint>& drawn, std::vector<std::uint32_t>& triangles);

}  // namespace moontrace
