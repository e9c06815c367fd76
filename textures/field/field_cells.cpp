// The grid of a block: which of its elements can matter where. Runs outside the tick.
#include "textures/field/field_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "textures/base/overload.h"
#include "textures/base/units.h"
#include "textures/field/blend.h"

namespace moontrace {

namespace {

using CompiledLayer = TextureField::CompiledLayer;

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

/// A fill of a group, whose outline's arcs are rims in the block.
struct FillRims {
  std::size_t element = 0;
  const Fill* fill = nullptr;
  std::vector<RisingEdge> rising;
  std::vector<std::uint16_t> numbers;  ///< of each piece's rim in the block; 0 for lines
};
std::vector<FillRims> RimsOf(const Group& group) {
  std::vector<FillRims> all;
  std::size_t next = group.elements.size() + 1;
  for (std::size_t i = 0; i < group.elements.size(); ++i) {
    const Fill* fill = std::get_if<Fill>(&group.elements[i].shape);
    if (fill == nullptr) continue;
    FillRims rims{i, fill, RisingEdges(fill->outline), {}};
    for (const Piece& piece : fill->outline) {
      rims.numbers.push_back(ArcOf(piece) ? static_cast<std::uint16_t>(next++) : 0);
    }
    all.push_back(std::move(rims));
  }
  return next <= 0xffff ? all : std::vector<FillRims>();
}

/// How far a point lies within a fill, at most `half`; zero outside [m].
double InsideOf(const FillRims& rims, glm::dvec2 p, double half) {
  bool in = false;
  for (const RisingEdge& edge : rims.rising) in ^= Crosses(edge, p);
  double inside = in ? half : 0;
  for (const Piece& piece : rims.fill->outline) inside = std::min(inside, DistanceTo(piece, p));
  return inside;
}

/// How far a point lies within a rim; below zero outside [m].
double InsideOf(const FlatElement& rim, glm::dvec2 p) {
  return rim.cos_half * (rim.radius - glm::length(p - rim.anchor));
}

/// The rims of a fill that tell how far each point of a cell lies within it: the least of what they
/// say. None where a line or a corner is near, or where rims do not tell.
std::vector<std::uint16_t> RimsAt(const FillRims& fill, const Block& block, glm::dvec2 middle,
                                  double reach, const CompiledLayer& layer) {
  const double half = layer.profiles[block.profile].half;
  const auto rim_of = [&](std::uint16_t number) -> const FlatElement& {
    return layer.elements[block.first_element + number];
  };
  std::vector<std::uint16_t> rims;
  const std::vector<Piece>& outline = fill.fill->outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (DistanceTo(outline[i], middle) > reach + half) continue;
    const std::optional<Arc> arc = ArcOf(outline[i]);
    if (!arc || BesideOf(*arc, middle, reach) != Beside::kWholly) return {};
    rims.push_back(fill.numbers[i]);
  }
  if (rims.empty()) {
    // deep inside: any rim that says so for the whole cell
    const auto deep = [&](std::uint16_t number) {
      return number != 0 && InsideOf(rim_of(number), middle) >= reach + half;
    };
    const auto any = std::find_if(fill.numbers.begin(), fill.numbers.end(), deep);
    if (any == fill.numbers.end()) return {};
    rims.push_back(*any);
  }
  // rims may also bound parts of the fill that lie beside each other: tried, all around the cell
  constexpr double kSame = 1e-12;  // [m]
  for (int eighth = 0; eighth < 9; ++eighth) {
    const glm::dvec2 p = middle + (eighth == 8 ? 0.0 : reach) * DirectionOf(eighth * kTurn / 8);
    double inside = half;
    for (const std::uint16_t rim : rims) inside = std::min(inside, InsideOf(rim_of(rim), p));
    if (std::abs(std::max(inside, 0.0) - InsideOf(fill, p, half)) > kSame) return {};
  }
  return rims;
}

/// What can matter in a cell.
struct CellItems {
  std::vector<std::uint16_t> elements;  ///< of the group; without the fill that rims stand for
  std::vector<std::uint16_t> rims;      ///< by their numbers in the block
  bool plain = false;                   ///< strokes of the block's profile, and rims
  bool empty() const { return elements.empty() && rims.empty(); }
  /// Whether a cell can name what matters without a list.
  bool IsOne() const {
    return plain && rims.empty() && elements.size() == 1 && elements[0] + 1 < Cell::kListed;
  }
};

/// Finds what can matter in a part of a block.
class ItemFinder {
 public:
  ItemFinder(const Group& group, const Block& block, const CompiledLayer& layer)
      : group_(group), block_(block), layer_(layer), fills_(RimsOf(group)) {
    for (const Element& element : group.elements) bounds_.push_back(BoundsOf(element));
    blends_ = layer.block_blends[static_cast<std::size_t>(&block - layer.blocks.data())] > 0;
  }

  /// What can matter within `reach` of a point, in the group's order.
  CellItems ItemsAt(glm::dvec2 middle, double reach) const {
    CellItems items;
    std::size_t filled = 0;
    items.plain = !blends_;
    for (std::size_t i = 0; i < group_.elements.size(); ++i) {
      // the boxes rule most out at once
      if (!Contains(Grown(bounds_[i], reach), middle)) continue;
      if (!CanMatter(group_.elements[i], middle, reach)) continue;
      const FlatElement& flat = layer_.elements[block_.first_element + 1 + i];
      const bool is_fill = flat.kind == FlatKind::kDisc || flat.kind == FlatKind::kFill;
      items.plain &= (is_fill || flat.kind < FlatKind::kDisc) && flat.profile == block_.profile;
      filled += is_fill ? 1 : 0;
      items.elements.push_back(static_cast<std::uint16_t>(i));
    }
    if (items.plain && filled > 0) {
      items.plain = filled == 1 && PutRims(middle, reach, items);
    }
    if (items.plain) {
      DropCaps(group_, middle, reach, items.elements);
      KeepNearest(group_, middle, reach, items.elements);
    }
    return items;
  }

 private:
  /// Puts rims in place of the fill; false where they do not tell it.
  bool PutRims(glm::dvec2 middle, double reach, CellItems& items) const {
    constexpr std::size_t kMostRims = 0xff;
    for (const FillRims& fill : fills_) {
      const auto at = std::find(items.elements.begin(), items.elements.end(), fill.element);
      if (at == items.elements.end()) continue;
      items.rims = RimsAt(fill, block_, middle, reach, layer_);
      if (items.rims.empty() || items.rims.size() > kMostRims) break;
      items.elements.erase(at);
      return true;
    }
    items.rims.clear();
    return false;
  }

  const Group& group_;
  const Block& block_;
  const CompiledLayer& layer_;
  std::vector<FillRims> fills_;
  std::vector<Box> bounds_;
  bool blends_ = false;
};

/// Writes down what a cell holds.
Cell MakeCell(const CellItems& items, const Block& block, CompiledLayer& layer) {
  if (items.empty()) return {};
  // the block's first element is none
  if (items.IsOne()) return {static_cast<std::uint16_t>(items.elements[0] + 1)};
  CellList list;
  list.first_item = static_cast<std::uint32_t>(layer.items.size());
  list.count = static_cast<std::uint16_t>(items.elements.size());
  list.rims = static_cast<std::uint8_t>(items.rims.size());
  list.plain = items.plain;
  for (const std::uint16_t element : items.elements) {
    layer.items.push_back(static_cast<std::uint16_t>(element + 1));
  }
  std::copy_n(layer.items.begin() + list.first_item, std::min<std::size_t>(2, list.count),
              list.elements.begin());
  layer.items.insert(layer.items.end(), items.rims.begin(), items.rims.end());
  const std::size_t number = layer.lists.size() - block.first_list;
  layer.lists.push_back(list);
  return {static_cast<std::uint16_t>(number | Cell::kListed)};
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
  // each longer than a step
  const double most = std::min(40.0, length - 1);
  side.cells = static_cast<std::uint8_t>(std::clamp(std::ceil(length / wanted), 1.0, most));
  side.per_step = static_cast<std::uint32_t>(std::floor(0x1p32 * side.cells / length));
  side.size = 0x1p32 / side.per_step;
  return side;
}

}  // namespace

void AddCells(const Group& group, Block& block, CompiledLayer& layer) {
  // cells of a third of the finest groove: most of them then hold one element or none; coarser for
  // what is not a letter of the plain page: links are many and stand mostly alone
  const bool fades = std::any_of(group.elements.begin(), group.elements.end(),
                                 [](const Element& element) { return !element.fade.IsNone(); });
  const double wanted = (fades ? 1.0 : 0.33) * FinestWidth(group) * layer.steps_per_m;
  const glm::dvec2 lead(layer.lead, 0.0);
  const Box in_steps{(block.box.min - lead) * layer.steps_per_m,
                     (block.box.max - lead) * layer.steps_per_m};
  const GridSide across = SideOf(in_steps.min.x, in_steps.max.x, wanted);
  const GridSide up = SideOf(in_steps.min.y, in_steps.max.y, wanted);
  block.left = across.before;
  block.below = up.before;
  block.columns_per_step = across.per_step;
  block.rows_per_step = up.per_step;
  block.columns = across.cells + 1;
  block.rows = up.cells + 1;
  block.first_cell = static_cast<std::uint32_t>(layer.cells.size());
  block.first_list = static_cast<std::uint32_t>(layer.lists.size());
  layer.cells.resize(layer.cells.size() + std::size_t{block.columns} * block.rows);

  const ItemFinder finder(group, block, layer);
  double blend_reach = 0;
  if (group.blend_radius > 0) {
    blend_reach = BlendReach(group.elements.size(), group.blend_radius) + group.blend_radius;
  }
  // a cell, and what counting in steps may be wrong by
  const glm::dvec2 size(across.size, up.size);
  const double reach = (0.5 * glm::length(size) + kStepsWrong) / layer.steps_per_m + blend_reach;
  for (std::uint32_t row = 0; row < up.cells; ++row) {
    for (std::uint32_t column = 0; column < across.cells; ++column) {
      const glm::dvec2 steps =
          size * (glm::dvec2(column, row) + 0.5) - glm::dvec2(block.left, block.below);
      const CellItems items = finder.ItemsAt(steps / layer.steps_per_m + lead, reach);
      layer.cells[block.first_cell + row * block.columns + column] = MakeCell(items, block, layer);
    }
  }
}

}  // namespace moontrace
