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
#include "textures/field/field_cells.h"
#include "textures/field/field_place.h"

namespace moontrace {

namespace {

using CompiledLayer = TextureField::CompiledLayer;

constexpr double kMostSteps = 0x1p28;   ///< from a group's origin
constexpr double kFarthest = 1e6;       ///< from the page's, so that steps can be counted [m]
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
  // one without length has no direction, and so no place beside it
  flat.direction = flat.length > 0 ? (line.to - line.from) / flat.length : glm::dvec2(1, 0);
  if (!(flat.length > 0)) flat.length = -1;
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

/// The arcs of a fill's outline as rims, with the side on which the fill lies.
void AddRims(const Fill& fill, std::uint16_t profile, CompiledLayer& layer) {
  constexpr double kHair = 1e-8;  // [m]
  for (const Piece& piece : fill.outline) {
    const std::optional<Arc> arc = ArcOf(piece);
    if (!arc) continue;
    FlatElement rim = FlattenRound(arc->center, arc->radius);
    rim.kind = FlatKind::kRim;
    rim.profile = profile;
    const glm::dvec2 middle = DirectionOf(arc->start + 0.5 * SweepOf(*arc));
    rim.cos_half = IsInside(fill.outline, arc->center + (arc->radius - kHair) * middle) ? 1 : -1;
    layer.elements.push_back(rim);
  }
}

Block MakeBlock(const Group& group, CompiledLayer& layer) {
  if (group.elements.size() > 65534) throw InputError("a group of more than 65534 elements");
  Block block;
  block.first_element = static_cast<std::uint32_t>(layer.elements.size());
  layer.elements.push_back(Nothing());
  std::size_t blending = 0;
  for (const Element& element : group.elements) {
    layer.elements.push_back(Flatten(element, layer));
    const FlatElement& flat = layer.elements.back();
    blending += flat.kind <= FlatKind::kRing ? 1 : 0;
  }
  for (const Element& element : group.elements) {
    const Fill* fill = std::get_if<Fill>(&element.shape);
    if (fill != nullptr) AddRims(*fill, ProfileNumber(element.profile, layer), layer);
  }
  for (const CappedLine& capped : CappedLines(group)) {
    FlatElement line = layer.elements[block.first_element + 1 + capped.line];
    line.kind = FlatKind::kCapped;
    layer.elements.push_back(line);
  }
  layer.block_blends.push_back(BlendNumber(group.blend_radius, layer));
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

/// Whether some elements of both could matter at one point. Takes from `work` what is looked at,
/// and gives up when it is used up.
bool Meet(const PlacedGroup& a, const PlacedGroup& b, double& work) {
  const auto boxes = [](const PlacedGroup& place, const Box& within) {
    std::vector<Box> found;
    for (const Element& element : place.group->elements) {
      const Box box = BoxOf(element, place);
      if (Overlap(box, within)) found.push_back(box);
    }
    return found;
  };
  if (!Overlap(a.box, b.box)) return false;
  work -= static_cast<double>(a.group->elements.size() + b.group->elements.size());
  const std::vector<Box> others = boxes(b, a.box);
  for (const Box& box : boxes(a, b.box)) {
    work -= static_cast<double>(others.size());
    if (work < 0) return false;
    const auto overlaps = [&box](const Box& other) { return Overlap(box, other); };
    if (std::any_of(others.begin(), others.end(), overlaps)) return true;
  }
  return false;
}

/// Numbers of the places that meet one that comes before them in the tree: it counts at a tie. None
/// where these are more than half, or so much crowds together that looking for them would take
/// long.
std::vector<std::size_t> Overlapping(const std::vector<PlacedGroup>& places) {
  double work = 1e6 + 200 * static_cast<double>(places.size());  // boxes of elements
  Box all;
  double height = 0;
  for (const PlacedGroup& place : places) {
    Include(all, place.box);
    height += (place.box.max.y - place.box.min.y) / static_cast<double>(places.size());
  }
  const double bands = std::min((all.max.y - all.min.y) / height, 1e4);
  const auto band_of = [&](double y) {
    return static_cast<std::size_t>((y - all.min.y) / (all.max.y - all.min.y) * bands);
  };
  std::vector<std::vector<std::size_t>> in_band(static_cast<std::size_t>(bands) + 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t last = band_of(places[i].box.max.y);
    for (std::size_t k = band_of(places[i].box.min.y); k <= last; ++k) in_band[k].push_back(i);
  }
  std::vector<bool> overlaps(places.size());
  std::vector<std::size_t> found;
  for (std::vector<std::size_t>& band : in_band) {
    std::sort(band.begin(), band.end(), [&places](std::size_t a, std::size_t b) {
      return places[a].box.min.x < places[b].box.min.x;
    });
    for (std::size_t i = 0; i < band.size(); ++i) {
      const Box& box = places[band[i]].box;
      for (std::size_t k = i + 1; k < band.size(); ++k) {
        const PlacedGroup& other = places[band[k]];
        if (other.box.min.x > box.max.x) break;
        const std::size_t later = std::max(band[i], band[k]);
        const bool meet = !overlaps[later] && Meet(places[band[i]], other, work);
        if (--work < 0) return {};
        if (!meet) continue;
        overlaps[later] = true;
        found.push_back(later);
        if (2 * found.size() > places.size()) return {};
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Without cells, which take the longest.
CompiledPart Place(std::vector<PlacedGroup> places, Relief relief) {
  CompiledPart part;
  CompiledLayer& compiled = part.layer;
  compiled.sign = relief == Relief::kEngraved ? -1 : 1;
  AddBlocks(places, compiled);
  double finest = std::numeric_limits<double>::infinity();
  for (const FlatProfile& profile : compiled.profiles) finest = std::min(finest, 2 * profile.half);
  double longest = 0;
  for (const Block& block : compiled.blocks) {
    const glm::dvec2 far = glm::max(glm::abs(block.box.min), glm::abs(block.box.max));
    longest = std::max({longest, far.x, far.y});
  }
  // coarser where a group is so large that its steps could not be counted
  compiled.steps_per_m = std::min(kStepsPerWidth / finest, kMostSteps / longest);
  AddPlaces(places, compiled);
  part.places = std::move(places);
  return part;
}

void AddCells(CompiledPart& part) {
  std::vector<const Group*> groups(part.layer.blocks.size());
  for (const PlacedGroup& place : part.places) groups[place.block] = place.group;
  AddCells(groups, part.layer);
}

bool IsInRows(const CompiledPart& part) { return part.layer.rows.length > 0; }

/// Makes two parts of one where that puts the first of them in rows.
void SplitOff(std::vector<CompiledPart>& parts, Relief relief) {
  const std::vector<PlacedGroup>& places = parts.front().places;
  const std::vector<std::size_t> overlapping = Overlapping(places);
  if (overlapping.empty()) return;
  std::vector<PlacedGroup> letters, links;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_link = links.size() < overlapping.size() && overlapping[links.size()] == i;
    (is_link ? links : letters).push_back(places[i]);
  }
  CompiledPart rows = Place(std::move(letters), relief);
  if (!IsInRows(rows)) return;
  parts.clear();
  parts.push_back(std::move(rows));
  parts.push_back(Place(std::move(links), relief));
  parts.back().layer.joins = true;
}

}  // namespace

std::vector<CompiledPart> CompileLayer(const Layer& layer) {
  std::vector<PlacedGroup> places;
  CollectLeaves(*layer.group, {0, 0}, 0, places);
  for (const PlacedGroup& place : places) {
    if (!(std::abs(place.origin.x) <= kFarthest && std::abs(place.origin.y) <= kFarthest)) {
      throw InputError(
          "a group stands at a place that is not a number, or beyond 1000 km: check its origin");
    }
  }
  std::vector<CompiledPart> parts;
  parts.push_back(Place(std::move(places), layer.relief));
  if (!IsInRows(parts.front())) SplitOff(parts, layer.relief);
  for (CompiledPart& part : parts) AddCells(part);
  return parts;
}

}  // namespace moontrace
