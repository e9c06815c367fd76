#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "sim/picture/drawing.h"
#include "sim/picture/raster.h"
#include "textures/field/element.h"
#include "textures/field/field.h"

namespace moontrace {

/// How the page is lit and coloured.
struct PageShade {
  Color paper{0.96, 0.95, 0.91};
  Color groove{0.24, 0.28, 0.36};  ///< at the field's greatest depth
  Color ridge{0.62, 0.42, 0.14};   ///< at its greatest height
  Color desk{0.42, 0.45, 0.49};    ///< beyond the sheet
  /// Towards the light, unit, z > 0; from the upper left, as people expect of relief.
  glm::dvec3 light_P{-0.48, 0.64, 0.60};
  /// Share of the light that comes from everywhere: so much that a groove is darkest along its
  /// middle, not on the flank that lies in shadow.
  double ambient = 0.72;
};

/// For weak eyes: black grooves on white, dark ridges.
PageShade HighContrastShade();

/// The field as a lit surface, exact at each point's middle: Lambert's law on the normal, tinted by
/// depth or height: not at all up to 0.15 of the field's greatest, wholly from 0.95, smoothly
/// (3 t^2 - 2 t^3) between, as hollows of a real sheet lie in the shade of their rims. Brightness
/// over that of flat paper is ambient + (1 - ambient) n.l / l_z, n the unit normal along (-dh/dx,
/// -dh/dy, 1); values above 1 are cut off. `view_P` [m] is what the picture covers, `sheet_P` where
/// paper lies. Rows are worked on by `threads` at once.
Raster ShadeField(const TextureField& field, const Box& view_P, const Box& sheet_P,
                  std::size_t width, std::size_t height, const PageShade& shade,
                  std::size_t threads = 1);

}  // namespace moontrace
