// Flattens the tree: runs outside the tick, may allocate and throw.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "textures/blend.h"
#include "textures/error.h"
#include "textures/field_layer.h"

namespace moontrace {

namespace {

using CompiledLayer = TextureField::CompiledLayer;

constexpr double kTurn = 2 * std::numbers::pi;

/// A group with elements of its own, where it stands on the page.
struct Leaf {
  const Group* group = nullptr;
  glm::dvec2 origin{0, 0};
  std::uint16_t block = 0;
  std::uint32_t order = 0;
  Box box;  ///< on the page
};

void CollectLeaves(const Group& group, glm::dvec2 origin, int nesting, std::vector<Leaf>& leaves) {
  if (nesting > 64) throw InputError("groups are nested deeper than 64: flatten them");
  if (leaves.size() >= (1u << 24)) throw InputError("more than 2^24 groups on one page: split it");
  if (!group.elements.empty()) {
    leaves.push_back({&group, origin, 0, static_cast<std::uint32_t>(leaves.size()), {}});
  }
  for (const Placement& placement : group.placements) {
    CollectLeaves(*placement.group, origin + placement.origin, nesting + 1, leaves);
  }
}

FlatProfile Flatten(const Profile& profile) {
  Check(profile);
  const double slope = GreatestSlope(profile);
  return {profile.width / 2,
          profile.rounding,
          profile.depth,
          slope,
          slope / profile.rounding,
          profile.depth + slope * profile.rounding / 2};
}

std::uint16_t ProfileNumber(const Profile& profile, CompiledLayer& layer) {
  const FlatProfile flat = Flatten(profile);
  const auto found = std::find(layer.profiles.begin(), layer.profiles.end(), flat);
  if (found != layer.profiles.end()) {
    return static_cast<std::uint16_t>(found - layer.profiles.begin());
  }
  if (layer.profiles.size() >= 65535) throw InputError("more than 65535 different profiles");
  layer.profiles.push_back(flat);
  return static_cast<std::uint16_t>(layer.profiles.size() - 1);
}

FlatElement FlattenPiece(const Piece& piece) {
  FlatElement flat;
  if (const Line* line = std::get_if<Line>(&piece)) {
    flat.kind = FlatKind::kLine;
    flat.anchor = line->from;
    flat.length = glm::length(line->to - line->from);
    if (flat.length > 0) flat.direction = (line->to - line->from) / flat.length;
    return flat;
  }
  const Arc& arc = std::get<Arc>(piece);
  const double middle = arc.start + 0.5 * arc.sweep;
  flat.kind = std::abs(arc.sweep) >= kTurn ? FlatKind::kRing : FlatKind::kArc;
  flat.anchor = arc.center;
  flat.length = arc.radius;
  flat.direction = {std::cos(middle), std::sin(middle)};
  flat.cos_half = std::cos(0.5 * arc.sweep);
  return flat;
}

FlatElement FlattenFill(const Fill& fill, CompiledLayer& layer) {
  if (fill.outline.size() == 1) {
    const FlatElement ring = FlattenPiece(fill.outline.front());
    if (ring.kind == FlatKind::kRing) {
      FlatElement disc = ring;
      disc.kind = FlatKind::kDisc;
      return disc;
    }
  }
  if (fill.outline.size() > 65535) throw InputError("a filled outline of more than 65535 pieces");
  FlatElement flat;
  flat.kind = FlatKind::kFill;
  flat.edge_begin = static_cast<std::uint32_t>(layer.edges.size());
  flat.edge_count = static_cast<std::uint16_t>(fill.outline.size());
  for (const Piece& piece : fill.outline) {
    layer.edges.push_back({FlattenPiece(piece), StartOf(piece), EndOf(piece)});
  }
  flat.rising_begin = static_cast<std::uint32_t>(layer.rising.size());
  for (const RisingEdge& edge : RisingEdges(fill.outline)) layer.rising.push_back(edge);
  flat.rising_end = static_cast<std::uint32_t>(layer.rising.size());
  return flat;
}

FlatElement Flatten(const Element& element, CompiledLayer& layer) {
  FlatElement flat;
  if (const Fill* fill = std::get_if<Fill>(&element.shape)) {
    flat = FlattenFill(*fill, layer);
  } else if (const Dot* dot = std::get_if<Dot>(&element.shape)) {
    flat.kind = FlatKind::kDot;
    flat.anchor = dot->center;
  } else if (const Line* line = std::get_if<Line>(&element.shape)) {
    flat = FlattenPiece(Piece(*line));
  } else {
    flat = FlattenPiece(Piece(std::get<Arc>(element.shape)));
  }
  flat.profile = ProfileNumber(element.profile, layer);
  return flat;
}

/// Whether the element can matter within `reach` of a point (a cell's middle): never false by
/// mistake.
bool CanMatter(const Element& element, glm::dvec2 middle, double reach) {
  if (const Fill* fill = std::get_if<Fill>(&element.shape)) {
    if (IsInside(fill->outline, middle)) return true;
    return std::any_of(fill->outline.begin(), fill->outline.end(),
                       [&](const Piece& piece) { return DistanceTo(piece, middle) <= reach; });
  }
  reach += 0.5 * element.profile.width;
  if (const Dot* dot = std::get_if<Dot>(&element.shape)) {
    return glm::length(middle - dot->center) <= reach;
  }
  const Piece piece = std::holds_alternative<Line>(element.shape)
                          ? Piece(std::get<Line>(element.shape))
                          : Piece(std::get<Arc>(element.shape));
  return DistanceTo(piece, middle) <= reach;
}

/// Fills a block's grid: for each cell the elements that can matter there, in the group's order.
void AddCells(const Group& group, double blend_reach, Block& block, CompiledLayer& layer) {
  // cells of about half the finest groove; few enough that all glyphs of a script stay in the cache
  const glm::dvec2 size = block.box.max - block.box.min;
  double finest = glm::length(size);
  for (const Element& element : group.elements) {
    finest = std::min(finest, element.profile.width);
  }
  const auto count = [finest](double length) {
    const double wanted = std::ceil(length / (0.6 * finest));
    return static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 24.0));
  };
  block.columns = count(size.x);
  block.rows = count(size.y);
  block.cells_per_m = glm::dvec2(block.columns, block.rows) / size;
  block.first_cell = static_cast<std::uint32_t>(layer.cells.size());

  // the cell grown by a hair, so that rounding of a query's cell never hides an element
  const glm::dvec2 cell = size / glm::dvec2(block.columns, block.rows);
  const double reach = 0.5 * glm::length(cell) * (1 + 1e-9) + blend_reach;
  for (std::uint32_t row = 0; row < block.rows; ++row) {
    for (std::uint32_t column = 0; column < block.columns; ++column) {
      const glm::dvec2 middle = block.box.min + cell * (glm::dvec2(column, row) + 0.5);
      layer.cells.push_back(static_cast<std::uint32_t>(layer.items.size()));
      for (std::size_t i = 0; i < group.elements.size(); ++i) {
        if (CanMatter(group.elements[i], middle, reach)) {
          layer.items.push_back(static_cast<std::uint16_t>(i));
        }
      }
    }
  }
  layer.cells.push_back(static_cast<std::uint32_t>(layer.items.size()));
}

Block MakeBlock(const Group& group, CompiledLayer& layer) {
  if (group.elements.size() > 65535) throw InputError("a group of more than 65535 elements");
  Block block;
  block.first_element = static_cast<std::uint32_t>(layer.elements.size());
  block.blend_radius = group.blend_radius;
  block.plain = group.blend_radius == 0;
  std::size_t blending = 0;
  for (const Element& element : group.elements) {
    layer.elements.push_back(Flatten(element, layer));
    const FlatElement& flat = layer.elements.back();
    if (&element == &group.elements.front()) block.profile = flat.profile;
    block.plain &= flat.kind < FlatKind::kDisc && flat.profile == block.profile;
    blending += flat.kind <= FlatKind::kRing ? 1 : 0;
  }
  // an element can change the result where it is within the blend radius of one that reaches
  const double reach = BlendReach(blending, group.blend_radius);
  for (const Element& element : group.elements) {
    Include(block.box, Grown(BoundsOf(element), reach));
  }
  // room for rounding on either side, and never a box without area
  block.box = Grown(block.box, 1e-12);
  AddCells(group, group.blend_radius > 0 ? reach + group.blend_radius : 0, block, layer);
  return block;
}

void AddBlocks(std::vector<Leaf>& leaves, CompiledLayer& layer) {
  std::map<const Group*, std::uint16_t> numbers;
  for (Leaf& leaf : leaves) {
    const auto [at, is_new] =
        numbers.try_emplace(leaf.group, static_cast<std::uint16_t>(layer.blocks.size()));
    if (is_new) {
      if (layer.blocks.size() >= 65535) throw InputError("more than 65535 different groups");
      layer.blocks.push_back(MakeBlock(*leaf.group, layer));
    }
    leaf.block = at->second;
    leaf.box = Moved(layer.blocks[leaf.block].box, leaf.origin);
  }
}

/// Chooses bands: one for each line of text where lines are evenly spaced, else of a typical
/// height.
void ChooseBands(const std::vector<Leaf>& leaves, CompiledLayer& layer) {
  Box all;
  std::vector<double> lines, heights;
  for (const Leaf& leaf : leaves) {
    Include(all, leaf.box);
    lines.push_back(leaf.origin.y);
    heights.push_back(leaf.box.max.y - leaf.box.min.y);
  }
  std::nth_element(heights.begin(),
                   heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2),
                   heights.end());
  std::sort(lines.begin(), lines.end());
  double pitch = all.max.y - all.min.y;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i] - lines[i - 1] > 1e-9 * pitch) pitch = std::min(pitch, lines[i] - lines[i - 1]);
  }
  double above = 0, below = 0;
  for (const Leaf& leaf : leaves) {
    above = std::max(above, leaf.box.max.y - leaf.origin.y);
    below = std::max(below, leaf.origin.y - leaf.box.min.y);
  }
  const double most_bands = 4.0 * static_cast<double>(leaves.size()) + 16;
  double height = std::max(pitch, (all.max.y - all.min.y) / most_bands);
  // letters hang around their base line: share what is left of the pitch above and below
  layer.y0 = lines.front() - below - 0.5 * std::max(height - above - below, 0.0);
  if (height < 0.5 * heights[heights.size() / 2]) {
    height = std::max(heights[heights.size() / 2], (all.max.y - all.min.y) / most_bands);
    layer.y0 = all.min.y;
  }
  layer.y0 = std::min(layer.y0, all.min.y);
  layer.bands_per_m = 1 / height;
  layer.bands.resize(2 + static_cast<std::size_t>((all.max.y - layer.y0) * layer.bands_per_m));
}

/// Writes one band's leaves, already sorted by their left edges, and the buckets that find them.
void AddBand(const std::vector<const Leaf*>& leaves, CompiledLayer& layer, Band& band) {
  band.first = static_cast<std::uint32_t>(layer.leaf_x.size());
  band.first_bucket = static_cast<std::uint32_t>(layer.buckets.size());
  if (leaves.empty()) return;
  double right = leaves.front()->box.max.x;
  for (const Leaf* leaf : leaves) {
    right = std::max(right, leaf->box.max.x);
    layer.leaf_x.push_back(leaf->origin.x);
    layer.leaf_y.push_back(leaf->origin.y);
    layer.leaf_block.push_back(leaf->block);
    layer.leaf_order.push_back(leaf->order);
    layer.one_y_per_band &= leaf->origin.y == leaves.front()->origin.y;
  }
  band.y = leaves.front()->origin.y;
  band.x0 = leaves.front()->box.min.x;
  const double buckets = 2.0 * static_cast<double>(leaves.size());
  band.buckets_per_m = buckets / (right - band.x0);
  // computed as a query computes it, so that rounding cannot part them
  const auto bucket_of = [&band](double x) {
    return static_cast<std::uint32_t>((x - band.x0) * band.buckets_per_m);
  };
  band.bucket_count = bucket_of(right) + 1;
  std::uint32_t filled = 0;
  for (std::uint32_t i = 0; i < leaves.size(); ++i) {
    for (const std::uint32_t last = bucket_of(leaves[i]->box.max.x); filled <= last; ++filled) {
      layer.buckets.push_back(band.first + i);
    }
  }
}

void AddLeaves(const std::vector<Leaf>& leaves, CompiledLayer& layer) {
  std::vector<std::vector<const Leaf*>> by_band(layer.bands.size() - 1);
  const auto band_of = [&layer](double y) {
    return static_cast<std::size_t>((y - layer.y0) * layer.bands_per_m);
  };
  for (const Leaf& leaf : leaves) {
    for (std::size_t i = band_of(leaf.box.min.y); i <= band_of(leaf.box.max.y); ++i) {
      by_band[i].push_back(&leaf);
    }
  }
  for (std::size_t i = 0; i < by_band.size(); ++i) {
    std::stable_sort(by_band[i].begin(), by_band[i].end(),
                     [](const Leaf* a, const Leaf* b) { return a->box.min.x < b->box.min.x; });
    AddBand(by_band[i], layer, layer.bands[i]);
  }
  layer.bands.back().first = static_cast<std::uint32_t>(layer.leaf_x.size());
  if (layer.one_y_per_band) layer.leaf_y = {};
}

void Shrink(CompiledLayer& layer) {
  layer.buckets.shrink_to_fit();
  layer.leaf_x.shrink_to_fit();
  layer.leaf_block.shrink_to_fit();
  layer.leaf_order.shrink_to_fit();
}

}  // namespace

CompiledLayer CompileLayer(const Layer& layer) {
  CompiledLayer compiled;
  compiled.sign = layer.relief == Relief::kEngraved ? -1 : 1;
  std::vector<Leaf> leaves;
  CollectLeaves(*layer.group, {0, 0}, 0, leaves);
  for (const Leaf& leaf : leaves) {
    if (!std::isfinite(leaf.origin.x) || !std::isfinite(leaf.origin.y)) {
      throw InputError("a group stands at a place that is not a number: check its origin");
    }
  }
  AddBlocks(leaves, compiled);
  ChooseBands(leaves, compiled);
  AddLeaves(leaves, compiled);
  Shrink(compiled);
  return compiled;
}

}  // namespace moontrace
