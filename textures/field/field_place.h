#pragma once

#include <cstdint>
#include <vector>

#include "textures/field/field_layer.h"

namespace moontrace {

/// A group with elements of its own, where it stands on the page.
struct PlacedGroup {
  const Group* group = nullptr;  ///< of the tree, which must live on
  glm::dvec2 origin{0, 0};       ///< [m]
  std::uint16_t block = 0;
  std::uint32_t order = 0;  ///< in the tree, decides ties
  Box box;                  ///< on the page [m]
};

/// How far beyond an element of a group something can matter: as far as blending swells it [m].
double ReachIn(const PlacedGroup& place);
/// Where on the page an element of a group can matter; empty for an outline without pieces.
Box BoxOf(const Element& element, const PlacedGroup& place);

/// A compiled layer and what it was made of.
struct CompiledPart {
  TextureField::CompiledLayer layer;
  std::vector<PlacedGroup> places;
};
/// Flattens one layer. Of letters with links between them the letters are one part, in rows, and
/// the links, which overlap them, another that joins it. Throws InputError for broken profiles, for
/// more than 65535 different groups, and for one that stands beyond 1000 km.
std::vector<CompiledPart> CompileLayer(const Layer& layer);

/// What reaches into each band, from left to right; a group in every band that its box touches.
using Bands = std::vector<std::vector<const PlacedGroup*>>;

/// Makes the layer's placed groups findable: as rows of slots where AddRows can, else by buckets.
/// At least one group; places finite.
void AddPlaces(const std::vector<PlacedGroup>& places, TextureField::CompiledLayer& layer);

/// Writes the bands as rows of slots, if all groups stand apart, on a raster, at one height in each
/// band; else leaves the layer as it is and returns false. `all`: the box of all of them.
bool AddRows(const Bands& bands, const Box& all, TextureField::CompiledLayer& layer);

/// The same for lines at uneven distances, as of letters of two sizes: bands are then so narrow
/// that each meets one line at most, and know which. False, and the layer as it was, where lines
/// do not stand apart.
bool AddUnevenRows(const std::vector<PlacedGroup>& places, const Box& all,
                   TextureField::CompiledLayer& layer);

}  // namespace moontrace
