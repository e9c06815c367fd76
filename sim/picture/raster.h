#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moontrace {

/// A picture of points: 3 bytes a point, red, green, blue, rows from the top down.
struct Raster {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height
};

}  // namespace moontrace
