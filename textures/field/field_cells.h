#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "textures/field/field_layer.h"
#include "textures/field/texture.h"

namespace moontrace {

/// A line of a group and the dots of its profile that round its ends, by their numbers there.
struct CappedLine {
  static constexpr std::uint16_t kNone = 0xffffu;
  std::uint16_t line = 0;
  std::array<std::uint16_t, 2> caps{kNone, kNone};  ///< at its start, at its end
};
/// Those with a cap at least, from the group's first on; none where they could not be numbered.
std::vector<CappedLine> CappedLines(const Group& group);

/// Whether the element can matter within `reach` of a point (a cell's middle): never false by
/// mistake.
bool CanMatter(const Element& element, glm::dvec2 middle, double reach);

/// Lays the blocks' grids and fills them: for each cell the elements that can matter there, in the
/// group's order. `groups` are the blocks'. The layer's steps, and what the blocks' elements are,
/// must be known.
void AddCells(const std::vector<const Group*>& groups, TextureField::CompiledLayer& layer);

}  // namespace moontrace
