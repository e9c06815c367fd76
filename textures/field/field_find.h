#pragma once

#include <algorithm>

#include "textures/base/branchless.h"
#include "textures/field/field_layer.h"
#include "textures/field/in_box.h"

namespace moontrace {

/// How a query finds what can matter at a point. All inline: it runs in the tick.

/// Where a point lies beside a block's origin, in whole steps.
struct Steps {
  std::int64_t x = 0, y = 0;
};

/// Steps of a length, rounded.
inline std::int64_t StepsOf(const TextureField::CompiledLayer& layer, double length) noexcept {
  constexpr std::int64_t kAbove = 1 << 30;  // so that all is above zero, and is cut alike
  return static_cast<std::int64_t>(length * layer.steps_per_m + (kAbove + 0.5)) - kAbove;
}
inline Steps StepsOf(const TextureField::CompiledLayer& layer, glm::dvec2 p) noexcept {
  return {StepsOf(layer, p.x - layer.lead), StepsOf(layer, p.y)};
}

/// A cell of a block's grid. What lies before the grid or beyond it falls into the last.
struct CellPlace {
  std::uint32_t column = 0, row = 0;
};
/// The number of a cell so many steps from the grid's edge; below zero they become many.
template <class Unsigned>
inline std::uint32_t CellNumber(Unsigned steps, std::uint8_t shift, std::uint32_t count) noexcept {
  return static_cast<std::uint32_t>(std::min<Unsigned>(steps >> shift, count - 1));
}
inline CellPlace PlaceOf(const CellGrid& grid, Steps at) noexcept {
  const auto x = static_cast<std::uint64_t>(at.x + grid.left);
  const auto y = static_cast<std::uint64_t>(at.y + grid.below);
  return {CellNumber(x, grid.column_shift, grid.columns), CellNumber(y, grid.row_shift, grid.rows)};
}
inline Cell CellAt(const TextureField::CompiledLayer& layer, const Block& block,
                   CellPlace place) noexcept {
  return layer.cells[block.first_cell + place.row * block.grid.columns + place.column];
}

/// The elements of a cell that holds some, wherever their numbers stand.
struct CellElements {
  CellElements(const TextureField::CompiledLayer& layer, const Block& block, Cell cell) noexcept
      : first(&layer.elements[block.first_element]) {
    if (!cell.listed()) {
      first += cell.element();
      return;
    }
    const CellList& list = layer.lists[block.first_list + cell.list()];
    count = list.count;
    rims = list.rims;
    plain = list.plain;
    profile = list.profile;
    items = &layer.items[list.first_item];
  }
  const FlatElement& operator[](std::size_t i) const noexcept { return first[items[i]]; }

  static constexpr std::uint16_t kFirst = 0;
  const FlatElement* first;
  std::uint32_t count = 1;
  std::uint32_t rims = 0;     ///< that follow; they tell a fill
  bool plain = true;          ///< strokes of one profile, of which the nearest spine decides
  std::uint16_t profile = 0;  ///< that, of a list
  const std::uint16_t* items = &kFirst;  ///< counted from `first`
};

/// One over a distance, worked out beside the root rather than behind it, so that a query does not
/// wait for both; finite at no distance.
inline double OneOver(double distance, double square) noexcept {
  constexpr double kTiny = 1e-300;
  return distance * (1.0 / (square + kTiny));
}

/// The band at a height, or one beyond all, also for NaN.
inline std::uint32_t BandOf(const TextureField::CompiledLayer& layer, double y) noexcept {
  // comparisons are written so that a NaN ends here
  const double v = (y - layer.origin.y) * layer.bands_per_m;
  if (!(v >= 0 && v < layer.band_count)) return static_cast<std::uint32_t>(layer.band_count);
  return static_cast<std::uint32_t>(v);
}

/// A letter of a row, and where its origin stands.
struct FoundLetter {
  static constexpr std::uint32_t kNone = 0xffff'ffffu;
  std::uint32_t block = kNone;  ///< its number; none: the point lies beyond the row
  glm::dvec2 origin{0, 0};      ///< [m]
  std::int32_t place = 0;       ///< the same in steps of the raster
  std::uint32_t row = 0;
  /// Where the next one begins at the earliest, in steps of the raster; beyond the slot of a pair
  /// it may begin before that.
  std::int32_t next = 0;
};

/// A place in x in steps of the raster.
inline std::int32_t StepsAlong(const TextureField::CompiledLayer& layer, double x) noexcept {
  return static_cast<std::int32_t>((x - layer.rows.begin) * layer.steps_per_m);
}
/// Steps of a place in y, from the first band on.
inline std::int64_t StepsUp(const TextureField::CompiledLayer& layer, double y) noexcept {
  return static_cast<std::int64_t>((y - layer.origin.y) * layer.steps_per_m);
}

/// All bits where what begins at a place has begun, else none. `after` is a step after here
/// [steps].
inline std::int32_t MaskIfBegun(std::int32_t begin, std::int32_t after) noexcept {
  return (begin - after) >> 31;
}

/// The last of a page's letters in a row that begins at or before the point: at most one is met.
/// `u` is the point's place in the row [slots].
inline FoundLetter FindInPairs(const TextureField::CompiledLayer& layer, std::uint32_t row,
                               glm::dvec2 p, double u) noexcept {
  const Rows& rows = layer.rows;
  const LetterPair pair = rows.pairs[row * rows.length + static_cast<std::uint32_t>(u)];
  const std::int32_t here = StepsAlong(layer, p.x);
  // without a branch, which at random points would be mispredicted
  const std::int32_t second = pair.first() + pair.step();
  const std::int32_t begun = MaskIfBegun(second, here + 1);
  const std::int32_t place = pair.first() + (pair.step() & begun);
  return {pair.block(begun),
          {rows.first_x + static_cast<double>(place) * rows.step, rows.heights[row].y},
          place,
          row,
          second | (Letters::kFar & begun)};
}

/// The same in a book.
inline FoundLetter FindInSlots(const TextureField::CompiledLayer& layer, std::uint32_t row,
                               glm::dvec2 p, double u) noexcept {
  const Rows& rows = layer.rows;
  const std::uint32_t start =
      std::min(static_cast<std::uint32_t>(u), rows.length - 1 - Rows::kWindow);
  const Letters* slot = &rows.slots[row * rows.length + start];
  const std::int32_t here = StepsAlong(layer, p.x);
  // without a branch: what has begun, one after the other, is put in place of what stands before it
  Letters letters = slot[0];
  for (std::uint32_t i = 1; i <= Rows::kWindow; ++i) {
    const std::int64_t begun = MaskIfBegun(slot[i].first(), here + 1);
    letters.bits ^= (slot[i - 1].bits ^ slot[i].bits) & static_cast<std::uint64_t>(begun);
  }
  std::int32_t place = letters.first(), next = place;
  Code code = rows.codes[letters.code(0)], before = code;
  for (std::uint32_t i = 1; i < Letters::kMost; ++i) {
    const Code after = rows.codes[letters.code(i)];
    next += before.step();
    const std::int64_t begun = MaskIfBegun(next, here + 1);
    code.bits ^= (before.bits ^ after.bits) & static_cast<std::uint64_t>(begun);
    place += before.step() & static_cast<std::int32_t>(begun);
    before = after;
  }
  return {code.block(),
          {rows.first_x + static_cast<double>(place) * rows.step, rows.heights[row].y},
          place,
          row,
          place + code.step()};
}

/// The cell of a layer in rows where a point meets a letter.
inline CellPlace PlaceOf(const TextureField::CompiledLayer& layer, const FoundLetter& letter,
                         glm::dvec2 p) noexcept {
  const CellGrid& grid = layer.rows.grid;
  // what the letter has no part in is added first
  const auto x = static_cast<std::uint32_t>((StepsAlong(layer, p.x) + grid.left) - letter.place);
  const auto y = static_cast<std::uint64_t>(StepsUp(layer, p.y) + grid.below -
                                            layer.rows.heights[letter.row].steps);
  return {CellNumber(x, grid.column_shift, grid.columns), CellNumber(y, grid.row_shift, grid.rows)};
}
inline Cell CellOf(const TextureField::CompiledLayer& layer, const FoundLetter& letter,
                   glm::dvec2 p) noexcept {
  const CellGrid& grid = layer.rows.grid;
  const CellPlace place = PlaceOf(layer, letter, p);
  return layer
      .cells[letter.block * layer.rows.cells_per_block + place.row * grid.columns + place.column];
}

inline FoundLetter FindLetter(const TextureField::CompiledLayer& layer, std::uint32_t row,
                              glm::dvec2 p) noexcept {
  const Rows& rows = layer.rows;
  const double u = (p.x - rows.begin) * rows.slots_per_m;
  if (!(u >= 0 && u < rows.slot_count)) return {};
  return rows.pairs.empty() ? FindInSlots(layer, row, p, u) : FindInPairs(layer, row, p, u);
}

/// What a cell of a layer in rows gives at a point of it, from the block's origin.
Sample SampleCellAt(const TextureField::CompiledLayer& layer, const Block& block, Cell cell,
                    glm::dvec2 p) noexcept;
/// What the first layer gives, anywhere on the page.
Sample SampleLayerAt(const TextureField::CompiledLayer& layer, glm::dvec2 p) noexcept;
/// What all layers give, where the first gives `first` and `others` are those that can matter
/// (LayerMap).
Sample SampleWithOthers(const std::vector<TextureField::CompiledLayer>& layers, Sample first,
                        unsigned others, glm::dvec2 p) noexcept;

}  // namespace moontrace
