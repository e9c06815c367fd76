// Flattens the tree: runs outside the tick, may allocate and throw.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <map>

#include "textures/base/error.h"
#include "textures/base/overload.h"
#include "textures/field/blend.h"
#include "textures/field/field_place.h"

namespace moontrace {

namespace {

using CompiledLayer = TextureField::CompiledLayer;

constexpr double kStepsPerWidth = 128;  ///< the fewest in the finest groove

void CollectLeaves(const Group& group, glm::dvec2 origin, int nesting,
                   std::vector<PlacedGroup>& leaves) {
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
          profile.width / 2 - profile.rounding,
          profile.depth,
          slope,
          slope / profile.rounding};
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

std::uint16_t BlendNumber(double radius, CompiledLayer& layer) {
  std::vector<double>& radii = layer.blend_radii;
  const auto number = std::find(radii.begin(), radii.end(), radius) - radii.begin();
  if (number == std::ssize(radii)) radii.push_back(radius);
  return static_cast<std::uint16_t>(number);
}

FlatElement FlattenRound(glm::dvec2 center, double radius) {
  FlatElement flat;
  flat.kind = radius > 0 ? FlatKind::kRing : FlatKind::kDot;
  flat.anchor = center;
  flat.radius = radius;
  flat.cos_half = -1;
  return flat;
}

FlatElement FlattenLine(const Line& line) {
  FlatElement flat;
  flat.anchor = line.from;
  flat.length = glm::length(line.to - line.from);
  if (flat.length > 0) flat.direction = (line.to - line.from) / flat.length;
  return flat;
}

/// What an empty cell holds: a line that ends before it begins.
FlatElement Nothing() {
  FlatElement nothing;
  nothing.direction = {1, 0};
  nothing.length = -1;
  return nothing;
}

FlatElement FlattenArc(const Arc& arc) {
  FlatElement flat = FlattenRound(arc.center, arc.radius);
  if (IsWhole(arc)) return flat;
  const double middle = arc.start + 0.5 * arc.sweep;
  flat.kind = FlatKind::kArc;
  flat.direction = DirectionOf(middle);
  flat.cos_half = std::cos(0.5 * arc.sweep);
  return flat;
}

FlatElement FlattenPiece(const Piece& piece) {
  return std::visit(Overload{[](const Line& line) { return FlattenLine(line); },
                             [](const Arc& arc) { return FlattenArc(arc); }},
                    piece);
}

FlatElement FlattenFill(const Fill& fill, CompiledLayer& layer) {
  if (fill.outline.size() == 1) {
    FlatElement disc = FlattenPiece(fill.outline.front());
    if (disc.kind == FlatKind::kRing) {
      disc.kind = FlatKind::kDisc;
      return disc;
    }
  }
  if (layer.fills.size() >= 65535) throw InputError("more than 65535 filled outlines on a page");
  FlatElement flat;
  flat.kind = FlatKind::kFill;
  flat.fill = static_cast<std::uint16_t>(layer.fills.size());
  FlatFill& outline = layer.fills.emplace_back();
  for (const Piece& piece : fill.outline) {
    outline.edges.push_back({FlattenPiece(piece), StartOf(piece), EndOf(piece)});
  }
  outline.rising = RisingEdges(fill.outline);
  return flat;
}

void FlattenFade(const Element& element, FlatElement& flat, CompiledLayer& layer) {
  if (layer.fades.size() >= 65535) throw InputError("more than 65535 fading strokes on a page");
  const double rate =
      std::visit(Overload{
                     [&flat](const Arc& arc) {
                       return (arc.sweep < 0 ? -0.5 : 0.5) / std::acos(flat.cos_half);
                     },
                     [](const Line&) { return 0.0; },
                     [](const Dot&) { return 0.0; },
                     [](const Fill&) { return 0.0; },
                 },
                 element.shape);
  layer.fades.push_back({flat, element.fade.from, element.fade.to, rate});
  flat.kind = FlatKind::kFading;
  flat.fill = static_cast<std::uint16_t>(layer.fades.size() - 1);
}

FlatElement Flatten(const Element& element, CompiledLayer& layer) {
  FlatElement flat = std::visit(Overload{
                                    [](const Line& line) { return FlattenLine(line); },
                                    [](const Arc& arc) { return FlattenArc(arc); },
                                    [](const Dot& dot) { return FlattenRound(dot.center, 0); },
                                    [&layer](const Fill& fill) { return FlattenFill(fill, layer); },
                                },
                                element.shape);
  flat.profile = ProfileNumber(element.profile, layer);
  if (!element.fade.IsNone() && flat.kind <= FlatKind::kArc) FlattenFade(element, flat, layer);
  return flat;
}

/// Whether the element can matter within `reach` of a point (a cell's middle): never false by
/// mistake.
bool CanMatter(const Element& element, glm::dvec2 middle, double reach) {
  const double from_spine = reach + 0.5 * element.profile.width;
  const auto fill_can = [reach, middle](const Fill& fill) {
    if (IsInside(fill.outline, middle)) return true;
    return std::any_of(fill.outline.begin(), fill.outline.end(),
                       [&](const Piece& piece) { return DistanceTo(piece, middle) <= reach; });
  };
  return std::visit(
      Overload{
          [=](const Line& line) { return DistanceTo(line, middle) <= from_spine; },
          [=](const Arc& arc) { return DistanceTo(arc, middle) <= from_spine; },
          [=](const Dot& dot) { return glm::length(middle - dot.center) <= from_spine; },
          fill_can,
      },
      element.shape);
}

/// How much of a disc lies beside a spine, between its butt ends.
enum class Beside { kNot, kPartly, kWholly };

Beside BesideOf(const Line& line, glm::dvec2 middle, double reach) {
  const double length = glm::length(line.to - line.from);
  if (!(length > 0)) return Beside::kPartly;
  const double along = glm::dot(middle - line.from, line.to - line.from) / length;
  if (along < -reach || along > length + reach) return Beside::kNot;
  return along >= reach && along <= length - reach ? Beside::kWholly : Beside::kPartly;
}

Beside BesideOf(const Arc& arc, glm::dvec2 middle, double reach) {
  if (IsWhole(arc)) return Beside::kWholly;
  const glm::dvec2 v = middle - arc.center;
  // the rays that bound the arc's sector, as far as the disc reaches
  const double far = glm::length(v) + reach;
  for (const double end : {arc.start, arc.start + arc.sweep}) {
    if (DistanceTo(Line{{0, 0}, far * DirectionOf(end)}, v) <= reach) return Beside::kPartly;
  }
  return AngleAlong(arc, v) <= std::abs(arc.sweep) ? Beside::kWholly : Beside::kNot;
}

/// Between which bounds an element's distance lies in the disc of radius `reach` about a cell's
/// middle; infinite where a butt end stops it.
struct Distances {
  double least = 0, greatest = 0;  ///< [m]
};
Distances DistancesOf(const Element& element, glm::dvec2 middle, double reach) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto of = [reach](Beside beside, double to_spine) -> Distances {
    if (beside == Beside::kNot) return {kInfinite, kInfinite};
    return {to_spine - reach, beside == Beside::kWholly ? to_spine + reach : kInfinite};
  };
  return std::visit(
      Overload{
          [=](const Line& line) {
            return of(BesideOf(line, middle, reach), DistanceTo(line, middle));
          },
          [=](const Arc& arc) { return of(BesideOf(arc, middle, reach), DistanceTo(arc, middle)); },
          [=](const Dot& dot) { return of(Beside::kWholly, glm::length(middle - dot.center)); },
          [](const Fill&) {
            return Distances{0, kInfinite};
          },
      },
      element.shape);
}

/// Of strokes of one profile the nearest decides: leaves out what is never the nearest in the cell.
void KeepNearest(const Group& group, glm::dvec2 middle, double reach,
                 std::vector<std::uint16_t>& items) {
  if (items.size() < 2) return;
  std::vector<double> least;
  double nearest = std::numeric_limits<double>::max();
  for (const std::uint16_t i : items) {
    const Distances distances = DistancesOf(group.elements[i], middle, reach);
    least.push_back(distances.least);
    nearest = std::min(nearest, distances.greatest);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (least[i] <= nearest) items[kept++] = items[i];
  }
  items.resize(kept);
}

/// Whether an element covers all of the disc, so that no point of its spine is ever nearer there
/// than the spine itself.
bool CoversAsSpine(const Element& element, glm::dvec2 middle, double reach, glm::dvec2 of_spine) {
  constexpr double kOnSpine = 1e-16;  // rounding of places in a letter [m]
  const auto covers = [&](const auto& piece) {
    return BesideOf(piece, middle, reach) == Beside::kWholly &&
           DistanceTo(piece, of_spine) <= kOnSpine;
  };
  return std::visit(Overload{[&](const Line& line) { return covers(line); },
                             [&](const Arc& arc) { return covers(arc); },
                             [](const Dot&) { return false; }, [](const Fill&) { return false; }},
                    element.shape);
}

/// Of strokes of one profile: leaves out the caps on a stroke that the cell lies beside.
void DropCaps(const Group& group, glm::dvec2 middle, double reach,
              std::vector<std::uint16_t>& items) {
  std::erase_if(items, [&](std::uint16_t i) {
    const Dot* dot = std::get_if<Dot>(&group.elements[i].shape);
    return dot != nullptr && std::any_of(items.begin(), items.end(), [&](std::uint16_t other) {
             return CoversAsSpine(group.elements[other], middle, reach, dot->center);
           });
  });
}

/// The elements that can matter within `reach` of a cell's middle, in the group's order. `bounds`
/// are the elements' own, which rule most of them out at once.
Cell MakeCell(const Group& group, const Block& block, const std::vector<Box>& bounds,
              glm::dvec2 middle, double reach, CompiledLayer& layer) {
  std::vector<std::uint16_t> items;
  for (std::size_t i = 0; i < group.elements.size(); ++i) {
    if (!Contains(Grown(bounds[i], reach), middle)) continue;
    if (CanMatter(group.elements[i], middle, reach)) items.push_back(static_cast<std::uint16_t>(i));
  }
  if (items.empty()) return {};
  const BlockLists& lists = layer.block_lists[block.more];
  const bool plain =
      lists.blend == 0 && std::all_of(items.begin(), items.end(), [&](std::uint16_t i) {
        const FlatElement& flat = layer.elements[block.first_element + 1u + i];
        return flat.kind < FlatKind::kDisc && flat.profile == block.profile;
      });
  if (plain) {
    DropCaps(group, middle, reach, items);
    KeepNearest(group, middle, reach, items);
  }
  // the block's first element is none
  for (std::uint16_t& item : items) ++item;
  if (plain && items.size() == 1 && items.front() < Cell::kListed) return {items.front()};
  const std::size_t list = layer.lists.size() - lists.first_list;
  layer.lists.push_back(static_cast<std::uint32_t>(2 * layer.items.size() + (plain ? 1 : 0)));
  layer.items.push_back(static_cast<std::uint16_t>(items.size()));
  layer.items.insert(layer.items.end(), items.begin(), items.end());
  return {static_cast<std::uint16_t>(list | Cell::kListed)};
}

double FinestWidth(const Group& group) {
  double finest = std::numeric_limits<double>::infinity();
  for (const Element& element : group.elements) {
    finest = std::min(finest, element.profile.width);
  }
  return finest;
}

/// One side of a block's grid, in steps.
struct GridSide {
  std::int32_t before = 0;     ///< how far before the origin it begins
  std::uint32_t per_step = 0;  ///< cells, in parts of 2^32
  std::uint8_t cells = 1;
  double size = 0;  ///< of a cell
};
/// Covers what lies between the two places [steps], and two steps more on either side, with cells
/// of about the wanted size, at most 40.
GridSide SideOf(double from, double to, double wanted) {
  const double begin = std::floor(from) - 2, length = std::ceil(to) + 2 - begin;
  GridSide side;
  side.before = static_cast<std::int32_t>(-begin);
  side.cells = static_cast<std::uint8_t>(std::clamp(std::ceil(length / wanted), 1.0, 40.0));
  side.per_step = static_cast<std::uint32_t>(std::floor(0x1p32 * side.cells / length));
  side.size = 0x1p32 / side.per_step;
  return side;
}

/// Fills a block's grid: for each cell the elements that can matter there, in the group's order.
void AddCells(const Group& group, Block& block, CompiledLayer& layer) {
  // cells of a third of the finest groove: most of them then hold one element or none; coarser for
  // what is not a letter of the plain page: links are many and stand mostly alone
  const bool fades = std::any_of(group.elements.begin(), group.elements.end(),
                                 [](const Element& element) { return !element.fade.IsNone(); });
  const double share = fades ? 1.0 : 0.33;
  const double wanted = share * FinestWidth(group) * layer.steps_per_m;
  const Box in_steps{(block.box.min - glm::dvec2(layer.lead, 0.0)) * layer.steps_per_m,
                     (block.box.max - glm::dvec2(layer.lead, 0.0)) * layer.steps_per_m};
  const GridSide across = SideOf(in_steps.min.x, in_steps.max.x, wanted);
  const GridSide up = SideOf(in_steps.min.y, in_steps.max.y, wanted);
  block.left = across.before;
  block.below = up.before;
  block.columns_per_step = across.per_step;
  block.rows_per_step = up.per_step;
  block.columns = across.cells + 1;
  block.rows = up.cells + 1;
  block.first_cell = static_cast<std::uint32_t>(layer.cells.size());
  layer.block_lists[block.more].first_list = static_cast<std::uint32_t>(layer.lists.size());
  layer.cells.resize(layer.cells.size() + std::size_t{block.columns} * block.rows);

  std::vector<Box> bounds;
  for (const Element& element : group.elements) bounds.push_back(BoundsOf(element));
  double blend_reach = 0;
  if (group.blend_radius > 0) {
    blend_reach = BlendReach(group.elements.size(), group.blend_radius) + group.blend_radius;
  }
  // a cell, and a step to either side and a hair, which counting in steps may be wrong by
  const glm::dvec2 size(across.size, up.size);
  const double reach = (0.5 * glm::length(size) + kStepsWrong) / layer.steps_per_m + blend_reach;
  for (std::uint32_t row = 0; row < up.cells; ++row) {
    for (std::uint32_t column = 0; column < across.cells; ++column) {
      const glm::dvec2 steps =
          size * (glm::dvec2(column, row) + 0.5) - glm::dvec2(block.left, block.below);
      const glm::dvec2 middle = steps / layer.steps_per_m + glm::dvec2(layer.lead, 0.0);
      layer.cells[block.first_cell + row * block.columns + column] =
          MakeCell(group, block, bounds, middle, reach, layer);
    }
  }
}

Block MakeBlock(const Group& group, CompiledLayer& layer) {
  if (group.elements.size() > 65534) throw InputError("a group of more than 65534 elements");
  Block block;
  block.first_element = static_cast<std::uint32_t>(layer.elements.size());
  layer.elements.push_back(Nothing());
  const BlockLists lists{0, BlendNumber(group.blend_radius, layer)};
  std::size_t blending = 0;
  for (const Element& element : group.elements) {
    layer.elements.push_back(Flatten(element, layer));
    const FlatElement& flat = layer.elements.back();
    if (&element == &group.elements.front()) block.profile = flat.profile;
    blending += flat.kind <= FlatKind::kRing ? 1 : 0;
  }
  block.more = static_cast<std::uint32_t>(layer.block_lists.size());
  layer.block_lists.push_back(lists);
  // an element can change the result where it is within the blend radius of one that reaches
  const double reach = BlendReach(blending, group.blend_radius);
  for (const Element& element : group.elements) {
    Include(block.box, Grown(BoundsOf(element), reach));
  }
  // room for rounding on either side, and never a box without area
  block.box = Grown(block.box, 1e-12);
  return block;
}

void AddBlocks(std::vector<PlacedGroup>& leaves, CompiledLayer& layer) {
  std::map<const Group*, std::uint16_t> numbers;
  for (PlacedGroup& leaf : leaves) {
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

/// A rectangle that no element reaches: the layer's box, cut back from the side that costs least
/// area for each element in turn. Large where elements stand around, as a raised margin does; not
/// looked for between many groups, as of text.
Box HoleIn(const std::vector<PlacedGroup>& leaves) {
  constexpr std::size_t kFew = 16;
  if (leaves.size() > kFew) return {};
  Box hole;
  std::vector<Box> boxes;
  for (const PlacedGroup& leaf : leaves) {
    Include(hole, leaf.box);
    const double reach = BlendReach(leaf.group->elements.size(), leaf.group->blend_radius);
    for (const Element& element : leaf.group->elements) {
      boxes.push_back(Grown(Moved(BoundsOf(element), leaf.origin), reach + 1e-9));
    }
  }
  const auto area = [](const Box& box) {
    const glm::dvec2 size = glm::max(box.max - box.min, 0.0);
    return size.x * size.y;
  };
  for (const Box& box : boxes) {
    if (!Overlap(hole, box)) continue;
    std::array<Box, 4> cut{hole, hole, hole, hole};
    cut[0].min.x = box.max.x;
    cut[1].max.x = box.min.x;
    cut[2].min.y = box.max.y;
    cut[3].max.y = box.min.y;
    hole = *std::max_element(cut.begin(), cut.end(),
                             [&area](const Box& a, const Box& b) { return area(a) < area(b); });
    if (area(hole) == 0) return {};
  }
  return hole;
}

}  // namespace

CompiledLayer CompileLayer(const Layer& layer) {
  CompiledLayer compiled;
  compiled.sign = layer.relief == Relief::kEngraved ? -1 : 1;
  std::vector<PlacedGroup> leaves;
  CollectLeaves(*layer.group, {0, 0}, 0, leaves);
  for (const PlacedGroup& leaf : leaves) {
    if (!std::isfinite(leaf.origin.x) || !std::isfinite(leaf.origin.y)) {
      throw InputError("a group stands at a place that is not a number: check its origin");
    }
  }
  AddBlocks(leaves, compiled);
  compiled.hole = HoleIn(leaves);
  double finest = std::numeric_limits<double>::infinity();
  for (const FlatProfile& profile : compiled.profiles) finest = std::min(finest, 2 * profile.half);
  compiled.steps_per_m = kStepsPerWidth / finest;
  AddPlaces(leaves, compiled);
  std::vector<bool> done(compiled.blocks.size());
  for (const PlacedGroup& leaf : leaves) {
    if (done[leaf.block]) continue;
    done[leaf.block] = true;
    AddCells(*leaf.group, compiled.blocks[leaf.block], compiled);
  }
  return compiled;
}

}  // namespace moontrace
