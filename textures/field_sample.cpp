// The query of the compiled field: everything here runs in the tick.
#include <array>
#include <cmath>

#include "textures/blend.h"
#include "textures/field_layer.h"

namespace moontrace {

namespace {

using CompiledLayer = TextureField::CompiledLayer;

constexpr double kFar = 1e300;

/// Vector from the spine to p and its square; the square is kFar where a butt end stops the
/// element.
struct Near {
  double distance2 = kFar;
  glm::dvec2 from_spine{0.0, 0.0};
};

inline Near NearestOf(const FlatElement& element, glm::dvec2 p) noexcept {
  const double vx = p.x - element.anchor.x, vy = p.y - element.anchor.y;
  switch (element.kind) {
    case FlatKind::kLine: {
      const double ux = element.direction.x, uy = element.direction.y;
      const double t = vx * ux + vy * uy;
      if (!(t >= 0 && t <= element.length)) return {};
      const double cross = vy * ux - vx * uy;
      return {cross * cross, {-cross * uy, cross * ux}};
    }
    case FlatKind::kArc:
    case FlatKind::kRing: {
      const double distance = std::sqrt(vx * vx + vy * vy);
      if (element.kind == FlatKind::kArc &&
          !(vx * element.direction.x + vy * element.direction.y >= distance * element.cos_half)) {
        return {};
      }
      const double d = distance - element.length;
      const double share = distance > 0 ? d / distance : 0;
      return {d * d, {share * vx, share * vy}};
    }
    default:
      return {vx * vx + vy * vy, {vx, vy}};
  }
}

/// Height and gradient from the vector to the nearest spine. The rounded spine needs no division.
inline Magnitude FromSpine(const FlatProfile& profile, double distance2,
                           glm::dvec2 from_spine) noexcept {
  const double d = std::sqrt(distance2);
  if (d <= profile.rounding) {
    return {profile.depth - 0.5 * profile.curvature * distance2, -profile.curvature * from_spine};
  }
  if (d <= profile.half - profile.rounding) {
    return {profile.flank - profile.slope * d, -profile.slope / d * from_spine};
  }
  const double to_rim = profile.half - d;
  if (!(to_rim > 0)) return {};
  return {0.5 * profile.curvature * to_rim * to_rim, -profile.curvature * to_rim / d * from_spine};
}

inline Magnitude FromRim(const FlatProfile& profile, double inside, glm::dvec2 from_edge) noexcept {
  if (!(inside > 0)) return {};
  if (inside >= profile.half) return {profile.depth, {0.0, 0.0}};
  const double d = profile.half - inside;
  if (d <= profile.rounding) {
    return {profile.depth - 0.5 * profile.curvature * d * d,
            profile.curvature * d / inside * from_edge};
  }
  if (d <= profile.half - profile.rounding) {
    return {profile.flank - profile.slope * d, profile.slope / inside * from_edge};
  }
  return {0.5 * profile.curvature * inside * inside, profile.curvature * from_edge};
}

/// Distance from an outline to p within it; the edges' own ends are reached, neighbours share them.
inline Near NearestOfOutline(const CompiledLayer& layer, const FlatElement& fill,
                             glm::dvec2 p) noexcept {
  Near nearest;
  const auto take = [&nearest](glm::dvec2 v) {
    const double d2 = v.x * v.x + v.y * v.y;
    if (d2 < nearest.distance2) nearest = {d2, v};
  };
  for (std::uint32_t i = 0; i < fill.edge_count; ++i) {
    const FlatEdge& edge = layer.edges[fill.edge_begin + i];
    const Near near = NearestOf(edge.spine, p);
    if (near.distance2 < nearest.distance2) nearest = near;
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
    const double inside = fill.length - distance;
    const double share = distance > 0 ? -inside / distance : 0;
    return FromRim(profile, inside, share * v);
  }
  bool in = false;
  for (std::uint32_t i = fill.rising_begin; i < fill.rising_end; ++i) {
    in ^= Crosses(layer.rising[i], p);
  }
  if (!in) return {};
  const Near near = NearestOfOutline(layer, fill, p);
  return FromRim(profile, std::sqrt(near.distance2), near.from_spine);
}

/// All strokes of one profile: the nearest spine has the greatest magnitude.
inline Magnitude SamplePlain(const CompiledLayer& layer, const Block& block, std::uint32_t begin,
                             std::uint32_t end, glm::dvec2 p) noexcept {
  Near nearest;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Near near = NearestOf(layer.elements[block.first_element + layer.items[i]], p);
    if (near.distance2 < nearest.distance2) nearest = near;
  }
  const FlatProfile& profile = layer.profiles[block.profile];
  if (nearest.distance2 >= profile.half * profile.half) return {};
  return FromSpine(profile, nearest.distance2, nearest.from_spine);
}

Foot FootOf(const FlatElement& element, glm::dvec2 p) noexcept {
  Foot foot{.distance = -1, .profile = element.profile};
  if (element.kind > FlatKind::kRing) return foot;
  const Near near = NearestOf(element, p);
  if (near.distance2 == kFar) return foot;
  foot.distance = std::sqrt(near.distance2);
  if (foot.distance > 0) foot.gradient = near.from_spine / foot.distance;
  foot.inset = kFar;
  const glm::dvec2 v = p - element.anchor;
  const glm::dvec2 u = element.direction;
  if (element.kind == FlatKind::kLine) {
    const double t = v.x * u.x + v.y * u.y;
    foot.inset = std::fmin(t, element.length - t);
    foot.inset_gradient = t <= element.length - t ? u : -u;
  } else if (element.kind == FlatKind::kArc) {
    // counted from the arc's middle, so that both ends are alike
    const double turned = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
    foot.inset = element.length * (std::acos(element.cos_half) - std::abs(turned));
    const double inward = (turned < 0 ? 1 : -1) * element.length / (v.x * v.x + v.y * v.y);
    foot.inset_gradient = inward * glm::dvec2(-v.y, v.x);
  }
  return foot;
}

/// Mixed profiles, fills, blended creases: magnitudes are compared one by one.
Magnitude SampleMixed(const CompiledLayer& layer, const Block& block, std::uint32_t begin,
                      std::uint32_t end, glm::dvec2 p) noexcept {
  // more lines and arcs than this near one point do not blend: they crowd far below any tip's size
  constexpr std::size_t kMostFeet = 32;
  std::array<Foot, kMostFeet> feet;
  std::size_t foot_count = 0;
  if (block.blend_radius > 0) {
    for (std::uint32_t i = begin; i < end && foot_count < kMostFeet; ++i) {
      const FlatElement& element = layer.elements[block.first_element + layer.items[i]];
      feet[foot_count++] = FootOf(element, p);
    }
  }
  Magnitude greatest;
  for (std::uint32_t i = begin; i < end; ++i) {
    const FlatElement& element = layer.elements[block.first_element + layer.items[i]];
    const FlatProfile& profile = layer.profiles[element.profile];
    Magnitude member;
    if (element.kind >= FlatKind::kDisc) {
      member = OfFill(layer, element, p);
    } else if (i - begin < foot_count && element.kind <= FlatKind::kRing) {
      const std::size_t own = i - begin;
      if (feet[own].distance < 0) continue;
      const BlendedDistance blended = Blend({feet.data(), foot_count}, own, block.blend_radius);
      const double d = std::fmax(blended.distance, 0.0);
      member = FromSpine(profile, d * d, d * blended.gradient);
    } else {
      const Near near = NearestOf(element, p);
      if (near.distance2 < profile.half * profile.half) {
        member = FromSpine(profile, near.distance2, near.from_spine);
      }
    }
    if (member.height > greatest.height) greatest = member;
  }
  return greatest;
}

inline Magnitude SampleBlock(const CompiledLayer& layer, const Block& block,
                             glm::dvec2 p) noexcept {
  const auto column = static_cast<std::uint32_t>((p.x - block.box.min.x) * block.cells_per_m.x);
  const auto row = static_cast<std::uint32_t>((p.y - block.box.min.y) * block.cells_per_m.y);
  const std::uint32_t cell = block.first_cell +
                             (row < block.rows ? row : block.rows - 1) * block.columns +
                             (column < block.columns ? column : block.columns - 1);
  const std::uint32_t begin = layer.cells[cell], end = layer.cells[cell + 1];
  if (begin == end) return {};
  return block.plain ? SamplePlain(layer, block, begin, end, p)
                     : SampleMixed(layer, block, begin, end, p);
}

}  // namespace

Magnitude SampleLayer(const CompiledLayer& layer, glm::dvec2 p) noexcept {
  // comparisons are written so that a NaN ends here
  const double v = (p.y - layer.y0) * layer.bands_per_m;
  if (!(v >= 0 && v < static_cast<double>(layer.bands.size() - 1))) return {};
  const Band& band = layer.bands[static_cast<std::uint32_t>(v)];
  const double u = (p.x - band.x0) * band.buckets_per_m;
  if (!(u >= 0 && u < static_cast<double>(band.bucket_count))) return {};
  const std::uint32_t end = (&band)[1].first;
  Magnitude greatest;
  std::uint32_t order = 0;
  for (std::uint32_t i = layer.buckets[band.first_bucket + static_cast<std::uint32_t>(u)]; i < end;
       ++i) {
    const Block& block = layer.blocks[layer.leaf_block[i]];
    const glm::dvec2 local(p.x - layer.leaf_x[i],
                           p.y - (layer.one_y_per_band ? band.y : layer.leaf_y[i]));
    if (local.x < block.box.min.x) break;
    if (!Contains(block.box, local)) continue;
    const Magnitude member = SampleBlock(layer, block, local);
    if (member.height > greatest.height ||
        (member.height == greatest.height && member.height > 0 && layer.leaf_order[i] < order)) {
      greatest = member;
      order = layer.leaf_order[i];
    }
  }
  return greatest;
}

Sample TextureField::SampleAt(glm::dvec2 p_P) const noexcept {
  Sample sum;
  for (const CompiledLayer& layer : layers_) {
    const Magnitude magnitude = SampleLayer(layer, p_P);
    sum.displacement += layer.sign * magnitude.height;
    sum.gradient += layer.sign * magnitude.gradient;
  }
  return sum;
}

}  // namespace moontrace
