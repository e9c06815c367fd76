#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "textures/field/field.h"
#include "textures/field/fill.h"
#include "textures/field/large_array.h"

namespace moontrace {

/// A profile with everything that a query needs worked out.
struct FlatProfile {
  double half = 0;       ///< w/2 [m]
  double rounding = 0;   ///< r [m]
  double straight = 0;   ///< w/2 - r, where the straight flank meets the spine's rounding [m]
  double depth = 0;      ///< D [m]
  double slope = 0;      ///< s [m/m]
  double curvature = 0;  ///< s/r [1/m]
  bool operator==(const FlatProfile&) const = default;
};

/// kRim: an arc of a fill's outline, of use only in cells where arcs alone tell the fill. kCapped:
/// a line and the round caps at its ends, of use only in cells where no others matter.
enum class FlatKind : std::uint32_t {
  kLine,
  kArc,
  kRing,
  kDot,
  kDisc,
  kFill,
  kFading,
  kRim,
  kCapped
};

/// An element ready for the query; a cache line. Arcs, rings and dots share one formula without
/// branches, since at random points branches are mispredicted: a dot is a ring of radius zero, a
/// ring an arc without ends. A line has one of its own, which needs no root.
struct FlatElement {
  glm::dvec2 anchor{0, 0};  ///< a line's start, else the centre [m]
  glm::dvec2 direction{
      0, 0};          ///< unit: along a line, to the middle of an arc; zero for rings and dots
  double radius = 0;  ///< of arc, ring, disc [m]; 0 for lines and dots
  /// Of half an arc's sweep; -1 for rings and dots, 0 for lines. Of a rim: 1 where the fill lies
  /// inside its circle, -1 outside.
  double cos_half = 0;
  double length = std::numeric_limits<double>::infinity();  ///< of a line [m]; else infinite
  FlatKind kind = FlatKind::kLine;
  std::uint16_t profile = 0;
  std::uint16_t fill = 0;  ///< number of the outline or of the fade, if any
};

/// A piece of a fill's outline with its ends, which its neighbours share.
struct FlatEdge {
  FlatElement spine;
  glm::dvec2 first{0, 0}, last{0, 0};  ///< [m]
};

/// A filled outline: its edges and what counts a ray's crossings.
struct FlatFill {
  std::vector<FlatEdge> edges;
  std::vector<RisingEdge> rising;
};

/// A line or an arc that becomes smaller along its spine (Fade in element.h).
struct FlatFade {
  FlatElement spine;
  double from = 1, to = 1;  ///< q at start and end
  double rate = 0;          ///< of an arc: share of it for an angle, below zero clockwise [1/rad]
};

/// What can matter in one cell of a block's grid: one element, by its number in the block, of which
/// the first is none; or, listed, several, by the list's number in the block. So is one that is no
/// stroke, or where strokes blend. The kind of the one stroke is told too, so that a query need not
/// wait for it.
struct Cell {
  static constexpr std::uint16_t kListed = 0x8000u, kRound = 0x4000u, kCapped = 0x2000u;
  std::uint16_t code = 0;  ///< 0, the element's number and its kind, or kListed and the list's
  bool empty() const noexcept { return code == 0; }
  bool listed() const noexcept { return code >= kListed; }
  bool round() const noexcept { return (code & kRound) != 0; }
  bool capped() const noexcept { return (code & kCapped) != 0; }
  std::uint32_t element() const noexcept { return code & (kCapped - 1u); }
  std::uint32_t list() const noexcept { return code & (kListed - 1u); }
};

/// How the cells of a block lie. They are found in whole steps, since these are known before the
/// place itself. The last column and row are empty: there ends a query beyond the grid.
struct CellGrid {
  std::int32_t left = 0, below = 0;              ///< of the origin, how far the grid begins [steps]
  std::uint8_t column_shift = 0, row_shift = 0;  ///< a cell's sides are two to these [steps]
  std::uint8_t columns = 2, rows = 2;            ///< with the empty ones
  std::uint32_t cells() const noexcept { return std::uint32_t{columns} * rows; }
};

/// The elements of one group, shared by all its placements, behind a grid of cells that says which
/// of them can matter where; a cache line.
struct Block {
  Box box;
  CellGrid grid;
  std::uint32_t first_cell = 0;
  std::uint32_t first_element = 0;
  std::uint32_t first_list = 0;
};

/// How far a point may lie from where its steps say, in x and y together [steps].
inline constexpr double kStepsWrong = 1.5;

/// A cell that holds more than one stroke.
struct CellList {
  std::uint32_t first_item = 0;  ///< among the layer's: the elements' numbers, then the rims'
  std::uint16_t count = 0;       ///< of elements
  std::uint8_t rims = 0;         ///< that tell a fill
  bool plain = false;            ///< strokes of one profile: the nearest spine decides
  std::uint16_t profile = 0;     ///< of these
};

/// Where a leaf's box lies in its band, coarsely and never less than it does: four numbers of 15
/// bits, a spare bit above each. Its left and lower edge are kept as they are, its right and upper
/// one counted backwards, so that a point lies in the box only if none of the point's own four
/// numbers is less: one subtraction tells, and eight bytes a leaf stay in the cache.
using Reach = std::uint64_t;

inline constexpr std::uint64_t kReachSteps = 0x7ffe;          // along a side
inline constexpr Reach kReachSpare = 0x8000'8000'8000'8000u;  // the spare bits
inline constexpr Reach kReachBegun = 0x8000u;                 // that of the left edge
inline constexpr Reach kReachNowhere = 0x7fffu;               // right of every point
/// How many leaves a query looks at together.
inline constexpr std::size_t kLeavesAtOnce = 4;

/// Edges in steps, each at most kReachSteps. A point is a box without size.
inline Reach PackReach(std::uint64_t left, std::uint64_t low, std::uint64_t right,
                       std::uint64_t high) noexcept {
  return left | low << 16 | (kReachSteps - right) << 32 | (kReachSteps - high) << 48;
}

/// A placed block in a bucket's list. Each band's leaves end with one that stands infinitely far to
/// the right.
struct Leaf {
  glm::dvec2 origin{0, 0};  ///< [m]
  std::uint32_t order = 0;  ///< in the tree, decides ties
  std::uint16_t block = 0;
};

/// The letter in which a slot begins and the one that may begin in it, in eight bytes.
struct LetterPair {
  static constexpr std::int32_t kMostSteps = 0xffff;
  static constexpr std::uint32_t kMostBlocks = 0x1000;
  std::uint64_t bits = 0;  ///< 24 of the first's place in steps, 16 to the second, 12 of each block
  std::int32_t first() const noexcept { return static_cast<std::int32_t>(bits & 0xff'ffffu); }
  std::int32_t step() const noexcept { return static_cast<std::int32_t>(bits >> 24 & 0xffffu); }
  /// Of the second where all bits of the mask are set, of the first where none is.
  std::uint32_t block(std::int32_t second) const noexcept {
    return static_cast<std::uint32_t>(bits >> (40 + (second & 12)) & 0xfffu);
  }
};

/// Up to five letters that follow each other in a row, in eight bytes.
struct Letters {
  static constexpr std::uint32_t kMost = 5;
  static constexpr std::int32_t kFar = (1 << 24) - 1;  ///< beyond every letter
  std::uint64_t bits = 0;                              ///< 24 of `first`, then eight of each code
  /// Where the first stands, in steps of the raster.
  std::int32_t first() const noexcept { return static_cast<std::int32_t>(bits & 0xff'ffffu); }
  std::uint8_t code(std::uint32_t i) const noexcept {
    return static_cast<std::uint8_t>(bits >> (24 + 8 * i));
  }
};

/// A block, and where the next one in the row stands.
struct Code {
  std::uint64_t bits = 0;  ///< 32 of the step to the next origin, in steps of the raster; the block
  std::int32_t step() const noexcept { return static_cast<std::int32_t>(bits); }
  std::uint32_t block() const noexcept { return static_cast<std::uint32_t>(bits >> 32); }
};
inline Code MakeCode(std::int32_t step, std::uint16_t block) noexcept {
  return {static_cast<std::uint32_t>(step) | std::uint64_t{block} << 32};
}

/// Where a row's letters stand.
struct RowHeight {
  double y = 0;            ///< [m]
  std::int64_t steps = 0;  ///< the same from the first band on, cut to steps
};

/// Evenly set text: placed blocks that stand apart from each other on a raster, those of one band
/// at one height. A band is a row of slots, so that a letter is found by arithmetic and one visit
/// to memory. A page's slots are so narrow that at most one letter begins in each. In a book a slot
/// is for five letters, found where the first of them begins, or, where letters crowd, up to
/// `kWindow` further on; a slot left empty repeats the letters before: two bytes a letter keep a
/// book in the processor's cache.
struct Rows {
  static constexpr std::uint32_t kWindow = 2;
  double first_x = 0;            ///< where the raster starts [m]
  double step = 0;               ///< of the raster [m], the layer's
  double begin = 0;              ///< of the first slot [m], left of the first letter
  double slots_per_m = 0;        ///< [1/m]
  double slot_count = 0;         ///< in a row, a whole number; a point beyond it meets nothing
  std::uint32_t length = 0;      ///< slots stored of each row
  LargeArray<LetterPair> pairs;  ///< of a page, else the following two
  LargeArray<Letters> slots;
  std::array<Code, 256> codes{};
  std::vector<RowHeight> heights;
  /// That of every block, so that a cell is found without a visit to the block; block by block.
  CellGrid grid;
  std::uint32_t cells_per_block = 0;
  /// The row that each band meets, where lines are unevenly spaced; else empty: bands are rows.
  std::vector<std::uint32_t> of_band;
};

struct CompiledPart;

/// Which of a field's layers beyond the first can matter where, so that a query of a page with
/// rules, margins and links mostly asks for its letters alone: the page in squares, with a bit for
/// each layer. Those from the fourth on share the last bit.
class LayerMap {
 public:
  static constexpr std::size_t kBits = 4;

  /// Of no layers.
  LayerMap() = default;
  /// Of all parts but the first.
  explicit LayerMap(const std::vector<CompiledPart>& parts);

  /// Zero also for a point that is not finite. Bit i is that of the layer i + 1.
  unsigned At(glm::dvec2 p_P) const noexcept {
    const double u = (p_P.x - origin_P_.x) * per_m_, v = (p_P.y - origin_P_.y) * per_m_;
    // comparisons are written so that a NaN ends here
    if (!((u >= 0) & (u < columns_) & (v >= 0) & (v < rows_))) return 0;
    const std::uint32_t square =
        static_cast<std::uint32_t>(v) * static_cast<std::uint32_t>(columns_) +
        static_cast<std::uint32_t>(u);
    return static_cast<unsigned>(pairs_[square / 2]) >> (4 * (square % 2)) & 0xfu;
  }
  std::size_t memory_bytes() const noexcept { return pairs_.capacity(); }

 private:
  glm::dvec2 origin_P_{0, 0};
  double per_m_ = 0;                 ///< [1/m]
  double columns_ = 0, rows_ = 0;    ///< whole numbers, compared as doubles
  std::vector<std::uint8_t> pairs_;  ///< of squares, the first in the lower four bits
};

/// One layer of the tree, flattened: nested groups of a layer are one group, since "the greatest
/// magnitude" does not care how its members are bracketed. It is cut into bands of equal height;
/// what stands in them is kept as rows, or, if it overlaps or stands anyhow, in buckets of equal
/// width: a bucket knows the first leaf that reaches into it.
struct TextureField::CompiledLayer {
  double sign = -1;
  /// Of one layer with the one before, so that the greater magnitude counts; else they add.
  bool joins = false;
  LayerMap others;           ///< of a field's first layer: those beyond it
  glm::dvec2 origin{0, 0};   ///< of the first band's first bucket [m]
  double bands_per_m = 0;    ///< [1/m]
  double steps_per_m = 0;    ///< of the blocks' grids [1/m]
  double lead = 0;           ///< where steps in x are counted from, beside a block's origin [m]
  double buckets_per_m = 0;  ///< [1/m]
  double reach_per_m = 0;    ///< steps of Reach in x [1/m]
  double band_count = 0,
         bucket_count = 0;  ///< buckets in a band, 0 with rows; whole numbers, compared as doubles
  std::uint32_t bucket_shift = 0;    ///< a bucket holds offset / 2^shift from the band's first leaf
  Rows rows;                         ///< else the following three
  std::vector<std::uint32_t> bands;  ///< first leaf of each
  std::vector<std::uint16_t> buckets;
  std::vector<Leaf> leaves;   ///< of each band from left to right
  LargeArray<Reach> reaches;  ///< of each leaf, and some beyond the last that cover nothing
  LargeArray<Block> blocks;
  std::vector<double> blend_radii{0.0};  ///< [m]
  LargeArray<Cell> cells;
  std::vector<std::uint16_t> block_blends;  ///< number of each block's blend radius; 0: none
  std::vector<CellList> lists;
  std::vector<std::uint16_t> items;
  LargeArray<FlatElement> elements;  ///< each in one cache line
  std::vector<FlatFill> fills;
  std::vector<FlatFade> fades;
  std::vector<FlatProfile> profiles;
};

}  // namespace moontrace
