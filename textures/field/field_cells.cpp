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

}  // namespace

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

namespace {

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
  double width = 0;  ///< of its profile [m]
  std::vector<RisingEdge> rising;
  std::vector<std::uint16_t> numbers;  ///< of each piece's rim in the block; 0 for lines
};
std::vector<FillRims> RimsOf(const Group& group) {
  std::vector<FillRims> all;
  std::size_t next = group.elements.size() + 1;
  for (std::size_t i = 0; i < group.elements.size(); ++i) {
    const Fill* fill = std::get_if<Fill>(&group.elements[i].shape);
    if (fill == nullptr) continue;
    FillRims rims{i, fill, group.elements[i].profile.width, RisingEdges(fill->outline), {}};
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
std::vector<std::uint16_t> RimsAt(const FillRims& fill, const FlatElement* elements,
                                  glm::dvec2 middle, double reach) {
  const double half = 0.5 * fill.width;
  const auto rim_of = [&](std::uint16_t number) -> const FlatElement& { return elements[number]; };
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

/// The number in the block of the capped line that stands for all that can matter in a cell, or 0.
std::size_t CappedAt(const std::vector<CappedLine>& lines, std::size_t first, const Group& group,
                     const std::vector<std::uint16_t>& items, glm::dvec2 middle, double reach) {
  const auto holds = [&items](std::uint16_t i) {
    return std::find(items.begin(), items.end(), i) != items.end();
  };
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const CappedLine& capped = lines[k];
    if (!holds(capped.line)) continue;
    const auto is_part = [&capped](std::uint16_t i) {
      return i == capped.line || i == capped.caps[0] || i == capped.caps[1];
    };
    if (!std::all_of(items.begin(), items.end(), is_part)) continue;
    // an end without a cap must lie beyond the cell
    const Line& line = std::get<Line>(group.elements[capped.line].shape);
    const double length = glm::length(line.to - line.from);
    const double along = glm::dot(middle - line.from, line.to - line.from) / length;
    const bool at_start = capped.caps[0] != CappedLine::kNone || along >= reach;
    const bool at_end = capped.caps[1] != CappedLine::kNone || along <= length - reach;
    if (at_start && at_end) return first + k;
  }
  return 0;
}

/// What can matter in a cell.
struct CellItems {
  std::vector<std::uint16_t> elements;  ///< of the group; without the fill that rims stand for
  std::vector<std::uint16_t> rims;      ///< by their numbers in the block
  bool plain = false;                   ///< strokes and rims of one profile
  std::uint16_t profile = 0;            ///< the first's
  std::uint16_t one = 0;  ///< the only one, if a cell can name it without a list, in the block
  bool empty() const { return elements.empty() && rims.empty(); }
};

/// Finds what can matter in a part of a block.
class ItemFinder {
 public:
  ItemFinder(const Group& group, const Block& block, const CompiledLayer& layer)
      : group_(group),
        elements_(&layer.elements[block.first_element]),
        fills_(RimsOf(group)),
        capped_(CappedLines(group)) {
    // behind the group's own elements and the rims of its fills
    std::size_t number = 1 + group.elements.size();
    while (!capped_.empty() && elements_[number].kind != FlatKind::kCapped) ++number;
    first_capped_ = number;
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
      const FlatElement& flat = elements_[1 + i];
      if (items.elements.empty()) items.profile = flat.profile;
      const bool is_fill = flat.kind == FlatKind::kDisc || flat.kind == FlatKind::kFill;
      items.plain &= (is_fill || flat.kind < FlatKind::kDisc) && flat.profile == items.profile;
      filled += is_fill ? 1 : 0;
      items.elements.push_back(static_cast<std::uint16_t>(i));
    }
    if (items.plain && filled > 0) {
      items.plain = filled == 1 && PutRims(middle, reach, items);
    }
    if (items.plain) {
      DropCaps(group_, middle, reach, items.elements);
      KeepNearest(group_, middle, reach, items.elements);
      if (items.rims.empty()) items.one = OneOf(items.elements, middle, reach);
    }
    return items;
  }

 private:
  std::uint16_t OneOf(const std::vector<std::uint16_t>& items, glm::dvec2 middle,
                      double reach) const {
    const std::size_t one = items.size() == 1
                                ? items[0] + 1u
                                : CappedAt(capped_, first_capped_, group_, items, middle, reach);
    return static_cast<std::uint16_t>(one < Cell::kCapped ? one : 0);
  }

  /// Puts rims in place of the fill; false where they do not tell it.
  bool PutRims(glm::dvec2 middle, double reach, CellItems& items) const {
    constexpr std::size_t kMostRims = 0xff;
    for (const FillRims& fill : fills_) {
      const auto at = std::find(items.elements.begin(), items.elements.end(), fill.element);
      if (at == items.elements.end()) continue;
      items.rims = RimsAt(fill, elements_, middle, reach);
      if (items.rims.empty() || items.rims.size() > kMostRims) break;
      items.elements.erase(at);
      return true;
    }
    items.rims.clear();
    return false;
  }

  const Group& group_;
  const FlatElement* elements_;  ///< the block's, of which the first is none
  std::vector<FillRims> fills_;
  std::vector<CappedLine> capped_;
  std::size_t first_capped_ = 0;  ///< number of the first one's element in the block
  std::vector<Box> bounds_;
  bool blends_ = false;
};

/// Writes down what a cell holds.
Cell MakeCell(const CellItems& items, const Block& block, CompiledLayer& layer) {
  if (items.empty()) return {};
  // the block's first element is none
  if (items.one != 0) {
    const FlatKind kind = layer.elements[block.first_element + items.one].kind;
    const unsigned of_kind = kind == FlatKind::kLine     ? 0u
                             : kind == FlatKind::kCapped ? Cell::kCapped
                                                         : Cell::kRound;
    return {static_cast<std::uint16_t>(items.one | of_kind)};
  }
  CellList list;
  list.first_item = static_cast<std::uint32_t>(layer.items.size());
  list.count = static_cast<std::uint16_t>(items.elements.size());
  list.rims = static_cast<std::uint8_t>(items.rims.size());
  list.plain = items.plain;
  list.profile = items.profile;
  for (const std::uint16_t element : items.elements) {
    layer.items.push_back(static_cast<std::uint16_t>(element + 1));
  }
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

/// One side of a grid, in steps.
struct GridSide {
  std::int32_t before = 0;  ///< how far before the origin it begins
  std::uint8_t shift = 1;   ///< a cell's side is two to this
  std::uint8_t cells = 1;
};
/// Covers what lies between the two places [steps], and two steps more on either side, with cells
/// no longer than wanted, at least two steps long, or so long that 40 suffice.
GridSide SideOf(double from, double to, double wanted) {
  const double begin = std::floor(from) - 2, length = std::ceil(to) + 2 - begin;
  GridSide side;
  side.before = static_cast<std::int32_t>(-begin);
  const auto count = [&] { return std::ceil(std::ldexp(length, -side.shift)); };
  while (std::ldexp(2, side.shift) <= wanted || count() > 40) ++side.shift;
  side.cells = static_cast<std::uint8_t>(count());
  return side;
}

/// What a grid is for.
struct GridWish {
  Box box;
  double cell = std::numeric_limits<double>::infinity();  ///< side of a cell [m]
};
GridWish WishOf(const Group& group, const Block& block) {
  // cells of a quarter to half of the finest groove: most of them then hold one element or none;
  // coarser for what is not a letter of the plain page: links are many and stand mostly alone
  const bool fades = std::any_of(group.elements.begin(), group.elements.end(),
                                 [](const Element& element) { return !element.fade.IsNone(); });
  return {block.box, (fades ? 1.0 : 0.5) * FinestWidth(group)};
}
void Include(GridWish& wish, const GridWish& other) {
  Include(wish.box, other.box);
  wish.cell = std::min(wish.cell, other.cell);
}

CellGrid GridOf(const GridWish& wish, const CompiledLayer& layer) {
  const glm::dvec2 lead(layer.lead, 0.0);
  const Box in_steps{(wish.box.min - lead) * layer.steps_per_m,
                     (wish.box.max - lead) * layer.steps_per_m};
  const double wanted = wish.cell * layer.steps_per_m;
  const GridSide across = SideOf(in_steps.min.x, in_steps.max.x, wanted);
  const GridSide up = SideOf(in_steps.min.y, in_steps.max.y, wanted);
  CellGrid grid{across.before, up.before, across.shift, up.shift};
  grid.columns = static_cast<std::uint8_t>(across.cells + 1);
  grid.rows = static_cast<std::uint8_t>(up.cells + 1);
  return grid;
}

void FillCells(const Group& group, Block& block, CompiledLayer& layer) {
  const CellGrid& grid = block.grid;
  block.first_cell = static_cast<std::uint32_t>(layer.cells.size());
  block.first_list = static_cast<std::uint32_t>(layer.lists.size());
  layer.cells.resize(layer.cells.size() + grid.cells());

  const ItemFinder finder(group, block, layer);
  double blend_reach = 0;
  if (group.blend_radius > 0) {
    blend_reach = BlendReach(group.elements.size(), group.blend_radius) + group.blend_radius;
  }
  // a cell, and what counting in steps may be wrong by
  const glm::dvec2 size(1u << grid.column_shift, 1u << grid.row_shift);
  const double reach = (0.5 * glm::length(size) + kStepsWrong) / layer.steps_per_m + blend_reach;
  const glm::dvec2 lead(layer.lead, 0.0);
  for (std::uint32_t row = 0; row + 1u < grid.rows; ++row) {
    for (std::uint32_t column = 0; column + 1u < grid.columns; ++column) {
      const glm::dvec2 steps =
          size * (glm::dvec2(column, row) + 0.5) - glm::dvec2(grid.left, grid.below);
      const CellItems items = finder.ItemsAt(steps / layer.steps_per_m + lead, reach);
      layer.cells[block.first_cell + row * grid.columns + column] = MakeCell(items, block, layer);
    }
  }
}

}  // namespace

std::vector<CappedLine> CappedLines(const Group& group) {
  const auto IsSame = [](const Profile& a, const Profile& b) {
    return a.width == b.width && a.rounding == b.rounding && a.depth == b.depth;
  };
  constexpr double kSame = 1e-16;  // rounding of places in a letter [m]
  const std::size_t count = group.elements.size();
  std::vector<CappedLine> lines;
  if (count >= Cell::kCapped) return lines;
  for (std::size_t i = 0; i < count; ++i) {
    const Line* line = std::get_if<Line>(&group.elements[i].shape);
    if (line == nullptr || !group.elements[i].fade.IsNone() || line->from == line->to) continue;
    CappedLine capped{static_cast<std::uint16_t>(i), {CappedLine::kNone, CappedLine::kNone}};
    for (std::size_t k = 0; k < count; ++k) {
      const Dot* dot = std::get_if<Dot>(&group.elements[k].shape);
      if (dot == nullptr || !IsSame(group.elements[k].profile, group.elements[i].profile)) continue;
      if (glm::distance(dot->center, line->from) <= kSame)
        capped.caps[0] = static_cast<std::uint16_t>(k);
      if (glm::distance(dot->center, line->to) <= kSame)
        capped.caps[1] = static_cast<std::uint16_t>(k);
    }
    if (capped.caps != std::array{CappedLine::kNone, CappedLine::kNone}) lines.push_back(capped);
  }
  return lines;
}

void AddCells(const std::vector<const Group*>& groups, CompiledLayer& layer) {
  const bool in_rows = layer.rows.length > 0;
  if (in_rows) {
    GridWish wish;
    for (std::size_t i = 0; i < groups.size(); ++i)
      Include(wish, WishOf(*groups[i], layer.blocks[i]));
    layer.rows.grid = GridOf(wish, layer);
    layer.rows.cells_per_block = layer.rows.grid.cells();
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Block& block = layer.blocks[i];
    block.grid = in_rows ? layer.rows.grid : GridOf(WishOf(*groups[i], block), layer);
    FillCells(*groups[i], block, layer);
  }
}

}  // namespace moontrace
