#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "textures/field.h"
#include "textures/fill.h"

namespace moontrace {

/// A profile with everything that a query needs worked out.
struct FlatProfile {
  double half = 0;       ///< w/2 [m]
  double rounding = 0;   ///< r [m]
  double depth = 0;      ///< D [m]
  double slope = 0;      ///< s [m/m]
  double curvature = 0;  ///< s/r [1/m]
  double flank = 0;      ///< D + s r/2, where the straight flank meets the spine [m]
  bool operator==(const FlatProfile&) const = default;
};

enum class FlatKind : std::uint32_t { kLine, kArc, kRing, kDot, kDisc, kFill };

/// An element ready for the query; a cache line. Lines, arcs, rings and dots share one formula
/// without branches, since at random points a branch on the kind would be mispredicted every second
/// time: a dot is a ring of radius zero, a ring an arc without ends.
struct FlatElement {
  glm::dvec2 anchor{0, 0};  ///< a line's start, else the centre [m]
  glm::dvec2 direction{
      0, 0};            ///< unit: along a line, to the middle of an arc; zero for rings and dots
  double radius = 0;    ///< of arc, ring, disc [m]; 0 for lines and dots
  double cos_half = 0;  ///< of half an arc's sweep; -1 for rings and dots, 0 for lines
  double length = 0;    ///< of a line [m]; else infinite
  FlatKind kind = FlatKind::kLine;
  std::uint16_t profile = 0;
  std::uint16_t fill = 0;  ///< number of the outline, if any
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

/// The elements that can matter in one cell of a block: up to three of them in place, else a list.
struct Cell {
  std::uint16_t count = 0;
  std::array<std::uint16_t, 3> items{};  ///< element, counted from the block's first; ascending
  static constexpr std::uint16_t kInPlace = 3;
  /// Where a longer list starts in `items`.
  std::uint32_t list() const noexcept { return items[0] | (std::uint32_t{items[1]} << 16); }
};

/// The elements of one group, shared by all its placements, behind a small grid that says which of
/// them can matter where.
struct Block {
  Box box;
  glm::dvec2 cells_per_m{0, 0};
  std::uint32_t columns = 1, rows = 1;
  std::uint32_t first_cell = 0;
  std::uint32_t first_element = 0;
  double blend_radius = 0;
  std::uint16_t profile = 0;
  bool plain = true;  ///< strokes of one profile, nothing blended: the nearest spine decides
};

/// A placed block. Each band's leaves end with one that stands infinitely far to the right.
struct Leaf {
  double x = 0;             ///< origin [m]
  std::uint32_t order = 0;  ///< in the tree, decides ties
  std::uint16_t block = 0;
};

/// A band of equal height across the layer; the leaves in it stand from left to right.
struct Band {
  double y = 0;             ///< origin of its leaves, if they share one [m]
  std::uint32_t first = 0;  ///< leaf
};

/// One layer of the tree, flattened: nested groups of a layer are one group, since "the greatest
/// magnitude" does not care how its members are bracketed. Bands are cut into buckets; a bucket
/// knows the first leaf that reaches into it, so that lines and letters are found by arithmetic.
struct TextureField::CompiledLayer {
  double sign = -1;
  glm::dvec2 origin{0, 0};   ///< of the first band's first bucket [m]
  double bands_per_m = 0;    ///< [1/m]
  double buckets_per_m = 0;  ///< [1/m]
  double band_count = 0,
         bucket_count = 0;         ///< buckets in a band; whole numbers, compared as doubles
  std::uint32_t bucket_shift = 0;  ///< a bucket holds offset / 2^shift from the band's first leaf
  bool one_y_per_band = true;
  std::vector<Band> bands;
  std::vector<std::uint16_t> buckets;
  std::vector<Leaf> leaves;
  std::vector<double> leaf_y;  ///< [m]; empty if one_y_per_band
  std::vector<Block> blocks;
  std::vector<Cell> cells;
  std::vector<std::uint16_t> items;
  std::vector<FlatElement> elements;
  std::vector<FlatFill> fills;
  std::vector<FlatProfile> profiles;
};

/// Flattens one layer. Throws InputError for broken profiles and for more than 65535 different
/// groups.
TextureField::CompiledLayer CompileLayer(const Layer& layer);

}  // namespace moontrace
