#pragma once

#include <algorithm>

#include "textures/field/field_layer.h"

namespace moontrace {

/// How a query finds what can matter at a point. All inline: it runs in the tick.

/// Whether a point relative to a placed block's origin lies in its box.
inline bool IsIn(const Box& box, glm::dvec2 p) noexcept {
  // one branch instead of four: they are all taken or the point lies between letters
  return (p.x >= box.min.x) & (p.x <= box.max.x) & (p.y >= box.min.y) & (p.y <= box.max.y);
}

/// The cell in which a point of the block's box lies.
struct CellPlace {
  std::uint32_t column = 0, row = 0;
};
inline CellPlace PlaceOf(const Block& block, glm::dvec2 p) noexcept {
  const auto column = static_cast<std::uint32_t>((p.x - block.box.min.x) * block.cells_per_m.x);
  const auto row = static_cast<std::uint32_t>((p.y - block.box.min.y) * block.cells_per_m.y);
  return {std::min(column, block.columns - 1u), std::min(row, block.rows - 1u)};
}

/// The elements of a cell that holds some, wherever their numbers stand.
struct CellElements {
  CellElements(const TextureField::CompiledLayer& layer, const Block& block, Cell cell) noexcept {
    if (!cell.listed()) {
      first = &layer.elements[cell.element()];
      return;
    }
    const std::uint16_t* list = &layer.items[cell.list()];
    first = &layer.elements[block.first_element];
    count = list[0];
    items = list + 1;
  }
  const FlatElement& operator[](std::size_t i) const noexcept { return first[items[i]]; }

  static constexpr std::uint16_t kFirst = 0;
  const FlatElement* first = nullptr;
  std::uint32_t count = 1;
  const std::uint16_t* items = &kFirst;  ///< counted from `first`
};

/// The band at a height, or one beyond all, also for NaN.
inline std::uint32_t BandOf(const TextureField::CompiledLayer& layer, double y) noexcept {
  // comparisons are written so that a NaN ends here
  const double v = (y - layer.origin.y) * layer.bands_per_m;
  if (!(v >= 0 && v < layer.band_count)) return static_cast<std::uint32_t>(layer.band_count);
  return static_cast<std::uint32_t>(v);
}

/// A letter of a row, and the steps of the raster between which it is the one that a point meets.
struct FoundLetter {
  const Block* block = nullptr;  ///< nullptr: the point lies beyond the row
  glm::dvec2 origin{0, 0};       ///< [m]
  std::int32_t from = 0, next = 0;
};

/// Steps of the raster from a row's first slot, of a place within its slots.
inline std::int32_t StepOf(const Rows& rows, double x) noexcept {
  return static_cast<std::int32_t>((x - rows.begin) * rows.steps_per_m);
}

/// The last letter of a row that begins at or before the point: at most one is met.
inline FoundLetter FindLetter(const TextureField::CompiledLayer& layer, std::uint32_t row,
                              double x) noexcept {
  const Rows& rows = layer.rows;
  const double u = (x - rows.begin) * rows.slots_per_m;
  if (!(u >= 0 && u < rows.slot_count)) return {};
  const std::uint32_t start =
      std::min(static_cast<std::uint32_t>(u), rows.length - 1 - Rows::kWindow);
  const Letters* slot = &rows.slots[row * rows.length + start];
  // counting needs no branch, which at random points would be mispredicted
  const std::int32_t here = StepOf(rows, x);
  std::uint32_t begun = 0;
  for (std::uint32_t i = 1; i <= Rows::kWindow; ++i) begun += slot[i].first() <= here ? 1 : 0;
  const Letters letters = slot[begun];
  std::int32_t place = letters.first(), next = place;
  std::uint32_t which = 0;
  for (std::uint32_t i = 0; i + 1 < Letters::kMost; ++i) {
    const std::int32_t step = rows.codes[letters.code(i)].step;
    next += step;
    const std::int32_t has_begun = next <= here ? 1 : 0;
    place += step & -has_begun;
    which += static_cast<std::uint32_t>(has_begun);
  }
  const Code& code = rows.codes[letters.code(which)];
  return {&layer.blocks[code.block],
          {rows.first_x + static_cast<double>(place) * rows.step, rows.y[row]},
          place,
          place + code.step};
}

/// Magnitude and gradient at a point of the block's box, from its origin.
Magnitude SampleBlockAt(const TextureField::CompiledLayer& layer, const Block& block,
                        glm::dvec2 p) noexcept;
/// The same of a whole layer, anywhere on the page.
Magnitude SampleLayerAt(const TextureField::CompiledLayer& layer, glm::dvec2 p) noexcept;
/// Whether nothing of a layer other than the first can be there.
bool IsBare(const TextureField::CompiledLayer& layer, glm::dvec2 p) noexcept;

}  // namespace moontrace
