#pragma once

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

/// An element ready for the query; a cache line.
struct FlatElement {
  glm::dvec2 anchor{0, 0};     ///< a line's start, else the centre [m]
  glm::dvec2 direction{0, 0};  ///< unit: along a line, to the middle of an arc
  double length = 0;           ///< of a line; radius of an arc, ring, disc [m]
  double cos_half = 0;         ///< cosine of half an arc's sweep
  FlatKind kind = FlatKind::kLine;
  std::uint16_t profile = 0;
  std::uint16_t edge_count = 0;  ///< a fill's outline: `edges` from edge_begin
  std::uint32_t edge_begin = 0;
  std::uint32_t rising_begin = 0, rising_end = 0;  ///< and its crossings
};

/// A piece of a fill's outline with its ends, which its neighbours share.
struct FlatEdge {
  FlatElement spine;
  glm::dvec2 first{0, 0}, last{0, 0};  ///< [m]
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

/// A band of equal height across the layer; the leaves in it stand from left to right.
struct Band {
  std::uint32_t first = 0;  ///< leaf; the next band's first ends it
  std::uint32_t first_bucket = 0;
  std::uint32_t bucket_count = 0;
  double x0 = 0;             ///< [m]
  double buckets_per_m = 0;  ///< [1/m]
  double y = 0;              ///< origin of its leaves, if they share one [m]
};

/// One layer of the tree, flattened: nested groups of a layer are one group, since "the greatest
/// magnitude" does not care how its members are bracketed.
struct TextureField::CompiledLayer {
  double sign = -1;
  double y0 = 0, bands_per_m = 0;
  bool one_y_per_band = true;
  std::vector<Band> bands;             ///< one more than there are, to end the last
  std::vector<std::uint32_t> buckets;  ///< first leaf that reaches into the bucket or beyond
  // leaves: placed blocks, by band, from left to right
  std::vector<double> leaf_x;  ///< origin [m]
  std::vector<double> leaf_y;  ///< empty if one_y_per_band
  std::vector<std::uint16_t> leaf_block;
  std::vector<std::uint32_t> leaf_order;  ///< in the tree, decides ties
  // blocks
  std::vector<Block> blocks;
  std::vector<std::uint32_t> cells;  ///< first item of each cell, and one to end the last
  std::vector<std::uint16_t> items;  ///< element, counted from the block's first
  std::vector<FlatElement> elements;
  std::vector<FlatEdge> edges;
  std::vector<RisingEdge> rising;
  std::vector<FlatProfile> profiles;
};

/// Flattens one layer. Throws InputError for broken profiles and for more than 65535 different
/// groups.
TextureField::CompiledLayer CompileLayer(const Layer& layer);

/// The layer's magnitude and gradient at `p_P`.
Magnitude SampleLayer(const TextureField::CompiledLayer& layer, glm::dvec2 p_P) noexcept;

}  // namespace moontrace
