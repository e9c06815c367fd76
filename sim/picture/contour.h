#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "textures/field/element.h"

namespace moontrace {

/// Heights at the corners of equal cells over a box, row by row from its lower left corner.
struct HeightGrid {
  Box box;
  std::size_t columns = 0;      ///< of cells
  std::size_t rows = 0;         ///< of cells
  std::vector<double> heights;  ///< (columns + 1) (rows + 1)
};

/// Closed polygons round where the height is above zero: counter-clockwise, holes clockwise, ended
/// by the box. Straight between where the cells' sides cross zero ("marching squares": W. E.
/// Lorensen and H. E. Cline, "Marching cubes", 1987, in the plane); two high corners that face each
/// other across a cell are joined.
std::vector<std::vector<glm::dvec2>> OutlinesAboveZero(const HeightGrid& grid);

}  // namespace moontrace
