#pragma once

#include "textures/field/field_layer.h"
#include "textures/field/texture.h"

namespace moontrace {

/// Fills a block's grid: for each cell the elements that can matter there, in the group's order.
/// The layer's steps, and what the block's elements are, must be known.
void AddCells(const Group& group, Block& block, TextureField::CompiledLayer& layer);

}  // namespace moontrace
