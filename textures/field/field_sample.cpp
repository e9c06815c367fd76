// The query of the compiled field: everything here runs in the tick.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "textures/base/branchless.h"
#include "textures/field/blend.h"
#include "textures/field/field_find.h"
#include "textures/field/paper_noise.h"

namespace moontrace {

namespace {

using CompiledLayer = TextureField::CompiledLayer;

constexpr double kFar = 1e300;
constexpr double kTiny = 1e-300;
constexpr std::size_t kMostFeet = 32;

/// Where a point lies relative to an element's spine: the distance, how far from the nearer butt
/// end it is, below zero where that stops the element, and the unit direction in which the distance
/// grows.
struct Near {
  double distance = kFar;
  double within = -1;
  glm::dvec2 away{0.0, 0.0};
  /// kFar where a butt end stops the element.
  double Reached() const noexcept { return within >= 0 ? distance : kFar; }
};

// signs are copied and ranges joined, since points on either side are equally likely
inline Near NearestOfLine(const FlatElement& element, glm::dvec2 p) noexcept {
  const double vx = p.x - element.anchor.x, vy = p.y - element.anchor.y;
  const double ux = element.direction.x, uy = element.direction.y;
  const double along = vx * ux + vy * uy;
  const double across = vy * ux - vx * uy;
  const double side = std::copysign(1.0, across);
  return {std::abs(across), Smaller(along, element.length - along), {-side * uy, side * ux}};
}
/// Of an arc, a ring or a dot.
inline Near NearestOfRound(const FlatElement& element, glm::dvec2 p) noexcept {
  const double vx = p.x - element.anchor.x, vy = p.y - element.anchor.y;
  const double along = vx * element.direction.x + vy * element.direction.y;
  const double square = vx * vx + vy * vy, distance = std::sqrt(square);
  // at the centre no direction is nearest: none is chosen
  const double off = distance - element.radius;
  const double scale = std::copysign(OneOver(distance, square), off);
  return {std::abs(off), along - distance * element.cos_half, {scale * vx, scale * vy}};
}

/// Of a line between round caps.
inline Near NearestOfCapped(const FlatElement& element, glm::dvec2 p) noexcept {
  const double vx = p.x - element.anchor.x, vy = p.y - element.anchor.y;
  const double ux = element.direction.x, uy = element.direction.y;
  const double along = Smaller(Larger(vx * ux + vy * uy, 0.0), element.length);
  const double wx = vx - along * ux, wy = vy - along * uy;
  const double square = wx * wx + wy * wy, distance = std::sqrt(square);
  const double scale = OneOver(distance, square);
  return {distance, 0.0, {scale * wx, scale * wy}};
}
inline Near NearestOf(const FlatElement& element, glm::dvec2 p) noexcept {
  if (element.kind == FlatKind::kLine) return NearestOfLine(element, p);
  return element.kind == FlatKind::kCapped ? NearestOfCapped(element, p)
                                           : NearestOfRound(element, p);
}

/// How far within the rim a point lies; zero beyond it.
inline double InsideOf(const FlatProfile& profile, const Near& near) noexcept {
  return IfNotBelowZero(near.within, Larger(profile.half - near.distance, 0.0));
}

/// Displacement and gradient so far within the rim, plus zero at the rim and beyond. No branch
/// depends on the point: the profile's rounded rim, its straight flank and its rounded spine are
/// told by how much of `inside` belongs to the rim and how much lies past the flank. `sign` is
/// minus one for a groove.
inline Sample DisplacementAt(const FlatProfile& profile, double sign, double inside,
                             glm::dvec2 away) noexcept {
  const double k = profile.curvature, signed_k = sign * k;
  const double at_rim = Smaller(inside, profile.rounding);
  const double past_flank = Larger(inside - profile.straight, 0.0);
  const double steepness = k * at_rim - k * past_flank;
  // turned and cleared before they are needed
  const double to_x = IfLess(0.0, inside, 0.0 - sign * away.x, 0.0);
  const double to_y = IfLess(0.0, inside, 0.0 - sign * away.y, 0.0);
  const double height =
      signed_k * at_rim * (inside - 0.5 * at_rim) - 0.5 * signed_k * past_flank * past_flank;
  return {height, {steepness * to_x, steepness * to_y}};
}
/// The same as a magnitude.
inline Magnitude FromInside(const FlatProfile& profile, double inside, glm::dvec2 away) noexcept {
  const Sample raised = DisplacementAt(profile, 1.0, inside, away);
  return {raised.displacement, raised.gradient};
}
inline Magnitude OfNear(const FlatProfile& profile, const Near& near) noexcept {
  return FromInside(profile, InsideOf(profile, near), near.away);
}

/// Of a fill: `from_edge` leads from the outline's nearest point.
inline Magnitude FromRim(const FlatProfile& profile, double inside, glm::dvec2 from_edge) noexcept {
  if (!(inside > 0)) return {};
  return FromInside(profile, std::min(inside, profile.half), -1 / inside * from_edge);
}

/// Vector from the nearest point of an outline to p, and its square.
struct FromOutline {
  double distance2 = kFar;
  glm::dvec2 v{0.0, 0.0};
};
inline FromOutline NearestOfOutline(const FlatFill& fill, glm::dvec2 p) noexcept {
  FromOutline nearest;
  const auto take = [&nearest](glm::dvec2 v) {
    const double d2 = v.x * v.x + v.y * v.y;
    if (d2 < nearest.distance2) nearest = {d2, v};
  };
  for (const FlatEdge& edge : fill.edges) {
    const Near near = NearestOf(edge.spine, p);
    if (near.within >= 0) take(near.distance * near.away);
    take(p - edge.first);
    take(p - edge.last);
  }
  return nearest;
}

inline Magnitude OfFill(const CompiledLayer& layer, const FlatElement& fill,
                        glm::dvec2 p) noexcept {
  const FlatProfile& profile = layer.profiles[fill.profile];
  if (fill.kind == FlatKind::kDisc) {
    const glm::dvec2 v = p - fill.anchor;
    const double distance = std::sqrt(v.x * v.x + v.y * v.y);
    const double inside = fill.radius - distance;
    const double share = distance > 0 ? -inside / distance : 0;
    return FromRim(profile, inside, share * v);
  }
  const FlatFill& outline = layer.fills[fill.fill];
  bool in = false;
  for (const RisingEdge& edge : outline.rising) in ^= Crosses(edge, p);
  if (!in) return {};
  const FromOutline nearest = NearestOfOutline(outline, p);
  return FromRim(profile, std::sqrt(nearest.distance2), nearest.v);
}

/// How far within the rim a point lies, and the direction in which that becomes less.
struct Within {
  double inside = 0;
  glm::dvec2 away{0.0, 0.0};
};
/// As NearestOf, but without a branch on the kind: which of a list's strokes are lines changes from
/// list to list.
inline Within WithinOf(const FlatProfile& profile, const FlatElement& element,
                       glm::dvec2 p) noexcept {
  const double vx = p.x - element.anchor.x, vy = p.y - element.anchor.y;
  const double ux = element.direction.x, uy = element.direction.y;
  const double along = vx * ux + vy * uy, across = vy * ux - vx * uy;
  const double square = vx * vx + vy * vy, distance = std::sqrt(square);
  // lines alone have a length, and neither a radius nor an angle
  const auto for_line = [&element](double line, double round) {
    return IfLess(element.length, kFar, line, round);
  };
  const double off = for_line(across, distance - element.radius);
  const double scale = std::copysign(for_line(1.0, OneOver(distance, square)), off);
  const double within = Smaller(along, element.length - along) - distance * element.cos_half;
  return {InsideOf(profile, {std::abs(off), within, {}}),
          {scale * for_line(-uy, vx), scale * for_line(ux, vy)}};
}
inline Within LargerOf(const Within& a, const Within& b) noexcept {
  const auto of = [&](double from_a, double from_b) {
    return IfLess(a.inside, b.inside, from_b, from_a);
  };
  return {of(a.inside, b.inside), {of(a.away.x, b.away.x), of(a.away.y, b.away.y)}};
}

/// Within a fill that rims tell.
inline Within WithinRims(const FlatProfile& profile, const CellElements& elements,
                         glm::dvec2 p) noexcept {
  Within least{profile.half, {0.0, 0.0}};
  for (std::uint32_t i = elements.count; i < elements.count + elements.rims; ++i) {
    const FlatElement& rim = elements[i];
    const glm::dvec2 v = p - rim.anchor;
    const double length = std::sqrt(v.x * v.x + v.y * v.y);
    const double inside = rim.cos_half * (rim.radius - length);
    const double scale = rim.cos_half / (length + kTiny);
    const auto of = [&](double of_rim, double of_least) {
      return IfLess(inside, least.inside, of_rim, of_least);
    };
    least = {of(Larger(inside, 0.0), least.inside),
             {of(scale * v.x, least.away.x), of(scale * v.y, least.away.y)}};
  }
  return least;
}

/// Of strokes of one profile: the nearest spine has the greatest magnitude.
inline Within WithinList(const FlatProfile& profile, const CellElements& elements,
                         glm::dvec2 p) noexcept {
  Within most;
  for (std::uint32_t i = 0; i < elements.count; ++i) {
    most = LargerOf(most, WithinOf(profile, elements[i], p));
  }
  return elements.rims == 0 ? most : LargerOf(most, WithinRims(profile, elements, p));
}

Foot FootOf(const FlatElement& element, glm::dvec2 p) noexcept {
  Foot foot{.distance = -1, .profile = element.profile};
  if (element.kind > FlatKind::kRing) return foot;
  const Near near = NearestOf(element, p);
  if (!(near.within >= 0)) return foot;
  foot.distance = near.distance;
  foot.gradient = near.away;
  foot.inset = kFar;
  const glm::dvec2 v = p - element.anchor;
  const glm::dvec2 u = element.direction;
  if (element.kind == FlatKind::kLine) {
    const double t = v.x * u.x + v.y * u.y;
    foot.inset = std::min(t, element.length - t);
    foot.inset_gradient = t <= element.length - t ? u : -u;
  } else if (element.kind == FlatKind::kArc) {
    // counted from the arc's middle, so that both ends are alike
    const double turned = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
    const double angle = std::acos(element.cos_half) - std::abs(turned);
    const double distance = std::sqrt(v.x * v.x + v.y * v.y);
    const glm::dvec2 outward = v / std::max(distance, kTiny);
    const glm::dvec2 onward = (turned < 0 ? 1.0 : -1.0) * glm::dvec2(-outward.y, outward.x);
    foot.inset = std::min(element.radius, distance) * angle;
    foot.inset_gradient =
        distance < element.radius ? onward + angle * outward : element.radius / distance * onward;
  }
  return foot;
}

Magnitude OfFading(const CompiledLayer& layer, const FlatElement& element, glm::dvec2 p) noexcept {
  const FlatFade& fade = layer.fades[element.fill];
  const FlatElement& spine = fade.spine;
  const FlatProfile& profile = layer.profiles[element.profile];
  const Near near = NearestOf(spine, p);
  if (!(near.Reached() < profile.half)) return {};
  const glm::dvec2 v = p - spine.anchor, a = spine.direction;
  double u = 0;
  glm::dvec2 rise(0.0, 0.0);  // of u
  if (spine.kind == FlatKind::kLine) {
    u = (v.x * a.x + v.y * a.y) / spine.length;
    rise = a / spine.length;
  } else {
    u = 0.5 + fade.rate * std::atan2(a.x * v.y - a.y * v.x, a.x * v.x + a.y * v.y);
    rise = fade.rate / std::max(v.x * v.x + v.y * v.y, kTiny) * glm::dvec2(-v.y, v.x);
  }
  u = u < 0 ? 0 : u > 1 ? 1 : u;
  const double change = fade.to - fade.from;
  const double q = fade.from + change * u * u * (3 - 2 * u);
  const double d = near.distance / q;
  if (!(d < profile.half)) return {};
  const Magnitude whole = FromInside(profile, profile.half - d, near.away);
  const double slope = whole.gradient.x * near.away.x + whole.gradient.y * near.away.y;
  const double by_q = (2 * q * whole.height - near.distance * slope) * change * 6 * u * (1 - u);
  return {q * q * whole.height, q * whole.gradient + by_q * rise};
}

inline Magnitude OfElement(const CompiledLayer& layer, const FlatElement& element,
                           glm::dvec2 p) noexcept {
  if (element.kind >= FlatKind::kDisc) {
    return element.kind == FlatKind::kFading ? OfFading(layer, element, p)
                                             : OfFill(layer, element, p);
  }
  const FlatProfile& profile = layer.profiles[element.profile];
  const Near near = NearestOf(element, p);
  if (!(near.Reached() < profile.half)) return {};
  return OfNear(profile, near);
}

/// Mixed profiles and fills: magnitudes are compared one by one.
[[gnu::noinline]] Magnitude SampleMixed(const CompiledLayer& layer, const Block& block, Cell cell,
                                        glm::dvec2 p) noexcept {
  const CellElements elements(layer, block, cell);
  Magnitude greatest;
  for (std::size_t i = 0; i < elements.count; ++i) {
    const Magnitude member = OfElement(layer, elements[i], p);
    if (member.height > greatest.height) greatest = member;
  }
  return greatest;
}

/// The lines and arcs of a cell as one point sees them. The first are worked out once and kept;
/// where more crowd in a cell, each of the others is worked out whenever it is asked for.
class CellFeet {
 public:
  CellFeet(const CellElements& elements, std::size_t count, glm::dvec2 p) noexcept
      : elements_(&elements), p_(p), kept_(std::min(count, kMostFeet)) {
    for (std::size_t i = 0; i < kept_; ++i) feet_[i] = FootOf(elements[i], p);
  }
  Foot operator[](std::size_t i) const noexcept {
    return i < kept_ ? feet_[i] : FootOf((*elements_)[i], p_);
  }

 private:
  const CellElements* elements_;
  glm::dvec2 p_;
  std::size_t kept_;
  std::array<Foot, kMostFeet> feet_;
};

/// The same with creases rounded.
[[gnu::noinline]] Magnitude SampleBlended(const CompiledLayer& layer, const Block& block, Cell cell,
                                          glm::dvec2 p) noexcept {
  const CellElements elements(layer, block, cell);
  const CellFeet feet(elements, elements.count, p);
  const std::size_t number = static_cast<std::size_t>(&block - layer.blocks.data());
  const double rho = layer.blend_radii[layer.block_blends[number]];
  const double reach = BlendReach(elements.count, rho);
  Magnitude greatest;
  for (std::size_t i = 0; i < elements.count; ++i) {
    const FlatElement& element = elements[i];
    Magnitude member;
    if (element.kind <= FlatKind::kRing) {
      const Foot own = feet[i];
      const FlatProfile& profile = layer.profiles[element.profile];
      if (own.distance < 0 || own.distance >= profile.half + reach) continue;
      const BlendedDistance blended = Blend(feet, elements.count, i, rho);
      const double d = Larger(blended.distance, 0.0);
      if (d < profile.half) {
        member = FromInside(profile, profile.half - d, blended.gradient);
      }
    } else {
      member = OfElement(layer, element, p);
    }
    if (member.height > greatest.height) greatest = member;
  }
  return greatest;
}

/// Of a cell whose strokes blend, or have several profiles, or are fills.
Magnitude SampleUneven(const CompiledLayer& layer, const Block& block, Cell cell,
                       glm::dvec2 p) noexcept {
  return layer.block_blends[static_cast<std::size_t>(&block - layer.blocks.data())] > 0
             ? SampleBlended(layer, block, cell, p)
             : SampleMixed(layer, block, cell, p);
}

inline Magnitude SampleCell(const CompiledLayer& layer, const Block& block, Cell cell,
                            glm::dvec2 p) noexcept {
  if (cell.listed()) {
    const CellElements elements(layer, block, cell);
    if (!elements.plain) return SampleUneven(layer, block, cell, p);
    const FlatProfile& profile = layer.profiles[elements.profile];
    const Within within = WithinList(profile, elements, p);
    return FromInside(profile, within.inside, within.away);
  }
  const FlatElement& element = layer.elements[block.first_element + cell.element()];
  return OfNear(layer.profiles[element.profile], NearestOf(element, p));
}

/// Flat paper is plus zero, which the sign of a groove would turn round.
inline Sample WithoutMinusZero(double displacement, double x, double y) noexcept {
  return {displacement + 0.0, {x + 0.0, y + 0.0}};
}
inline Sample Sum(const Sample& a, const Sample& b) noexcept {
  return {a.displacement + b.displacement,
          {a.gradient.x + b.gradient.x, a.gradient.y + b.gradient.y}};
}
Sample Signed(const CompiledLayer& layer, const Magnitude& magnitude) noexcept {
  return WithoutMinusZero(layer.sign * magnitude.height, layer.sign * magnitude.gradient.x,
                          layer.sign * magnitude.gradient.y);
}
[[gnu::noinline]] Sample SampleListed(const CompiledLayer& layer, const Block& block, Cell cell,
                                      glm::dvec2 p) noexcept {
  const CellElements elements(layer, block, cell);
  if (!elements.plain) return Signed(layer, SampleUneven(layer, block, cell, p));
  const FlatProfile& profile = layer.profiles[elements.profile];
  const Within within = WithinList(profile, elements, p);
  return DisplacementAt(profile, layer.sign, within.inside, within.away);
}

/// The displacement and gradient of a layer in rows: the way that nearly every query takes. Where
/// all strokes have one profile a query need not wait to learn which. `meanwhile` is called once,
/// while the cell is on its way from memory and no branch depends on it yet.
template <bool kInPairs, bool kOneProfile, class Meanwhile>
[[gnu::always_inline]] inline Sample SampleRows(const CompiledLayer& layer, glm::dvec2 p_P,
                                                Meanwhile meanwhile) noexcept {
  const Rows& rows = layer.rows;
  const double v = (p_P.y - layer.origin.y) * layer.bands_per_m;
  const double u = (p_P.x - rows.begin) * rows.slots_per_m;
  // comparisons are written so that a NaN ends here
  if (!((v >= 0) & (v < layer.band_count) & (u >= 0) & (u < rows.slot_count))) {
    meanwhile();
    return {};
  }
  auto row = static_cast<std::uint32_t>(v);
  if (!rows.of_band.empty()) row = rows.of_band[row];
  const FoundLetter letter = kInPairs ? FindInPairs(layer, row, p_P, u)  //
                                      : FindInSlots(layer, row, p_P, u);
  const Cell cell = CellOf(layer, letter, p_P);
  const Block& block = layer.blocks[letter.block];
  const glm::dvec2 p = p_P - letter.origin;
  meanwhile();
  if (cell.listed()) [[unlikely]]
    return SampleListed(layer, block, cell, p);
  const FlatElement* elements = &layer.elements[block.first_element];
  const FlatElement& element = elements[cell.element()];
  const FlatProfile& profile = layer.profiles[kOneProfile ? 0 : element.profile];
  const Near near = cell.round()    ? NearestOfRound(element, p)
                    : cell.capped() ? NearestOfCapped(element, p)
                                    : NearestOfLine(element, p);
  return DisplacementAt(profile, layer.sign, InsideOf(profile, near), near.away);
}
constexpr auto kNothingMeanwhile = [] {};

[[gnu::noinline]] Sample SampleBook(const CompiledLayer& layer, glm::dvec2 p_P) noexcept {
  return layer.profiles.size() == 1 ? SampleRows<false, true>(layer, p_P, kNothingMeanwhile)
                                    : SampleRows<false, false>(layer, p_P, kNothingMeanwhile);
}

/// Which of the leaves from one on may cover the point, a bit each, and whether all begin before
/// it.
struct Met {
  unsigned leaves = 0;
  bool all_begun = true;
};
inline Met LeavesMet(const Reach* reaches, Reach point) noexcept {
  // without a branch: which of them is met changes from point to point
  Met met;
  Reach begun = kReachSpare;
  for (std::size_t k = 0; k < kLeavesAtOnce; ++k) {
    const Reach not_less = ((point | kReachSpare) - reaches[k]) & kReachSpare;
    met.leaves |= (not_less == kReachSpare ? 1u : 0u) << k;
    begun &= not_less;
  }
  met.all_begun = (begun & kReachBegun) != 0;
  return met;
}

/// `up` is the point's share of the band's height.
Magnitude SampleBuckets(const CompiledLayer& layer, std::uint32_t band, double up,
                        glm::dvec2 p) noexcept {
  const double u = (p.x - layer.origin.x) * layer.buckets_per_m;
  if (!(u >= 0 && u < layer.bucket_count)) return {};
  const std::uint32_t bucket = layer.buckets[band * static_cast<std::uint32_t>(layer.bucket_count) +
                                             static_cast<std::uint32_t>(u)];
  const auto column = static_cast<std::uint32_t>((p.x - layer.origin.x) * layer.reach_per_m);
  const std::uint64_t x = std::min<std::uint64_t>(column, kReachSteps);
  const auto y = static_cast<std::uint32_t>(up * kReachSteps);
  const Reach point = PackReach(x, y, x, y);
  Magnitude greatest;
  std::uint32_t order = 0;
  for (std::size_t i = layer.bands[band] + (bucket << layer.bucket_shift);; i += kLeavesAtOnce) {
    // leaves of the next band may be among them: what is met of those is met in this one too
    Met met = LeavesMet(&layer.reaches[i], point);
    for (; met.leaves != 0; met.leaves &= met.leaves - 1) {
      const Leaf& leaf = layer.leaves[i + static_cast<std::size_t>(std::countr_zero(met.leaves))];
      const Block& block = layer.blocks[leaf.block];
      const glm::dvec2 local = p - leaf.origin;
      // beyond the block's box it is an empty one
      const Cell cell = CellAt(layer, block, PlaceOf(block.grid, StepsOf(layer, local)));
      const Magnitude member = SampleCell(layer, block, cell, local);
      if (member.height > greatest.height ||
          (member.height == greatest.height && member.height > 0 && leaf.order < order)) {
        greatest = member;
        order = leaf.order;
      }
    }
    if (!met.all_begun) return greatest;
  }
}

inline Sample SampleLayer(const CompiledLayer& layer, glm::dvec2 p) noexcept {
  if (!layer.rows.pairs.empty()) return SampleRows<true, false>(layer, p, kNothingMeanwhile);
  if (layer.rows.length > 0) return SampleBook(layer, p);
  const double v = (p.y - layer.origin.y) * layer.bands_per_m;
  if (!(v >= 0 && v < layer.band_count)) return {};
  const auto band = static_cast<std::uint32_t>(v);
  return Signed(layer, SampleBuckets(layer, band, v - band, p));
}

}  // namespace

Sample SampleCellAt(const CompiledLayer& layer, const Block& block, Cell cell,
                    glm::dvec2 p) noexcept {
  if (cell.listed()) return SampleListed(layer, block, cell, p);
  const FlatElement& element = layer.elements[block.first_element + cell.element()];
  const FlatProfile& profile = layer.profiles[element.profile];
  const Near near = NearestOf(element, p);
  return DisplacementAt(profile, layer.sign, InsideOf(profile, near), near.away);
}
Sample SampleLayerAt(const CompiledLayer& layer, glm::dvec2 p) noexcept {
  return SampleLayer(layer, p);
}

/// Layers add; a part of one with the part before is compared with it.
Sample SampleWithOthers(const std::vector<CompiledLayer>& layers, Sample first, unsigned others,
                        glm::dvec2 p) noexcept {
  Sample sum, part = first;
  std::size_t base = 0;  // the layer of which `part` is
  const auto take = [&](std::size_t i) {
    const Sample sample = SampleLayer(layers[i], p);
    if (layers[i].joins && base == i - 1) {
      if (std::abs(sample.displacement) > std::abs(part.displacement)) part = sample;
      return;
    }
    sum = Sum(sum, part);
    part = sample;
    base = i;
  };
  for (; others != 0; others &= others - 1) {
    const auto i = 1 + static_cast<std::size_t>(std::countr_zero(others));
    take(i);
    if (i == LayerMap::kBits) {
      for (std::size_t k = i + 1; k < layers.size(); ++k) take(k);
    }
  }
  return Sum(sum, part);
}

Sample TextureField::SampleAt(glm::dvec2 p_P) const noexcept {
  if (is_page_) [[likely]]
    return SampleRows<true, true>(layers_.front(), p_P, kNothingMeanwhile);
  return SampleLayers(p_P);
}

Sample TextureField::SampleLayers(glm::dvec2 p_P) const noexcept {
  if (layers_.empty()) return paper_.SampleAt(p_P);
  if (layers_.size() == 1 && paper_.empty()) return SampleLayer(layers_.front(), p_P);
  Sample paper;
  unsigned others = 0;
  const auto meanwhile = [&] {
    if (!paper_.empty()) paper = SamplePaper(paper_, p_P);
    others = layers_.front().others.At(p_P);
  };
  Sample sample;
  if (!layers_.front().rows.pairs.empty()) {
    sample = SampleRows<true, false>(layers_.front(), p_P, meanwhile);
  } else {
    meanwhile();
    sample = SampleLayer(layers_.front(), p_P);
  }
  if (others != 0) sample = SampleWithOthers(layers_, sample, others, p_P);
  return paper_.empty() ? sample : Sum(sample, paper);
}

}  // namespace moontrace
