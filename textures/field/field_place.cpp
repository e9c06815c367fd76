// Where placed groups are found: bands of a layer and what stands in them. Runs outside the tick.
#include "textures/field/field_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "textures/field/blend.h"

namespace moontrace {

namespace {

using CompiledLayer = TextureField::CompiledLayer;

/// Chooses bands: one for each line of text where lines are evenly spaced, else of a typical
/// height.
void ChooseBands(const std::vector<PlacedGroup>& leaves, const Box& all, CompiledLayer& layer) {
  std::vector<double> lines, heights;
  double above = 0, below = 0;
  for (const PlacedGroup& leaf : leaves) {
    lines.push_back(leaf.origin.y);
    heights.push_back(leaf.box.max.y - leaf.box.min.y);
    above = std::max(above, leaf.box.max.y - leaf.origin.y);
    below = std::max(below, leaf.origin.y - leaf.box.min.y);
  }
  std::nth_element(heights.begin(),
                   heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2),
                   heights.end());
  const double typical = heights[heights.size() / 2];
  std::sort(lines.begin(), lines.end());
  const double whole = all.max.y - all.min.y;
  double pitch = whole;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i] - lines[i - 1] > 1e-9 * whole) pitch = std::min(pitch, lines[i] - lines[i - 1]);
  }
  const double least = whole / (4.0 * static_cast<double>(leaves.size()) + 16);
  // letters hang around their base line: what is left of the pitch is shared above and below
  const bool even = pitch >= 0.5 * typical;
  const double height = std::max(even ? pitch : typical, least);
  const double slack = 0.5 * std::max(height - above - below, 0.0);
  layer.origin.y = even ? std::min(lines.front() - below - slack, all.min.y) : all.min.y;
  layer.bands_per_m = 1 / height;
  layer.band_count = std::floor((all.max.y - layer.origin.y) * layer.bands_per_m) + 1;
}

/// Chooses buckets of about a quarter of a letter; few where leaves are scattered over many bands.
void ChooseBuckets(std::size_t leaf_count, std::size_t longest_band, const Box& all,
                   CompiledLayer& layer) {
  const double wanted = 4.0 * static_cast<double>(longest_band);
  const double most = std::floor((8.0 * static_cast<double>(leaf_count) + 64) / layer.band_count);
  layer.origin.x = all.min.x;
  layer.buckets_per_m = std::clamp(most, 1.0, wanted) / (all.max.x - all.min.x);
  layer.bucket_count = std::floor((all.max.x - layer.origin.x) * layer.buckets_per_m) + 1;
  layer.reach_per_m = kReachSteps / (all.max.x - all.min.x);
  while ((longest_band >> layer.bucket_shift) > 65535) ++layer.bucket_shift;
}

/// Computed as a query computes its own, so that rounding cannot part them.
Reach ReachOf(const Box& box, double band, const CompiledLayer& layer) {
  const auto step = [](double share) {
    return static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0 * kReachSteps));
  };
  const auto across = [&](double x) { return step((x - layer.origin.x) * layer.reach_per_m); };
  const auto up = [&](double y) {
    const double v = (y - layer.origin.y) * layer.bands_per_m;
    return step((v - band) * kReachSteps);
  };
  return PackReach(across(box.min.x), up(box.min.y), across(box.max.x), up(box.max.y));
}

/// Writes one band's leaves, already sorted by their left edges, and the buckets that find them.
void AddBand(const std::vector<const PlacedGroup*>& leaves, CompiledLayer& layer) {
  const auto band = static_cast<double>(layer.bands.size());
  layer.bands.push_back(static_cast<std::uint32_t>(layer.leaves.size()));
  std::size_t filled = 0;
  const auto buckets = static_cast<std::size_t>(layer.bucket_count);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const PlacedGroup& leaf = *leaves[i];
    layer.leaves.push_back({leaf.origin, leaf.order, leaf.block});
    layer.reaches.push_back(ReachOf(leaf.box, band, layer));
    // computed as a query computes it, so that rounding cannot part them
    const auto last =
        static_cast<std::size_t>((leaf.box.max.x - layer.origin.x) * layer.buckets_per_m);
    for (; filled <= last && filled < buckets; ++filled) {
      layer.buckets.push_back(static_cast<std::uint16_t>(i >> layer.bucket_shift));
    }
  }
  for (; filled < buckets; ++filled) {
    layer.buckets.push_back(static_cast<std::uint16_t>(leaves.size() >> layer.bucket_shift));
  }
  layer.leaves.push_back({{std::numeric_limits<double>::infinity(), 0.0}, 0, 0});
  layer.reaches.push_back(kReachNowhere);
}

}  // namespace

double ReachIn(const PlacedGroup& place) {
  constexpr double kHair = 1e-9;  // more than all rounding of places on a page [m]
  return BlendReach(place.group->elements.size(), place.group->blend_radius) + kHair;
}

Box BoxOf(const Element& element, const PlacedGroup& place) {
  return Grown(Moved(BoundsOf(element), place.origin), ReachIn(place));
}

void AddPlaces(const std::vector<PlacedGroup>& places, CompiledLayer& layer) {
  Box all;
  for (const PlacedGroup& place : places) Include(all, place.box);
  ChooseBands(places, all, layer);
  Bands bands(static_cast<std::size_t>(layer.band_count));
  const auto band_of = [&layer](double y) {
    return static_cast<std::size_t>((y - layer.origin.y) * layer.bands_per_m);
  };
  for (const PlacedGroup& place : places) {
    const std::size_t last = band_of(place.box.max.y);
    for (std::size_t i = band_of(place.box.min.y); i <= last; ++i) bands[i].push_back(&place);
  }
  for (auto& band : bands) {
    std::stable_sort(band.begin(), band.end(), [](const PlacedGroup* a, const PlacedGroup* b) {
      return a->box.min.x < b->box.min.x;
    });
  }
  if (AddRows(bands, all, layer) || AddUnevenRows(places, all, layer)) {
    for (RowHeight& row : layer.rows.heights) {
      row.steps =
          static_cast<std::int64_t>(std::floor((row.y - layer.origin.y) * layer.steps_per_m));
    }
    return;
  }
  std::size_t longest = 1;
  for (const auto& band : bands) longest = std::max(longest, band.size());
  ChooseBuckets(places.size(), longest, all, layer);
  for (const auto& band : bands) AddBand(band, layer);
  layer.reaches.insert(layer.reaches.end(), kLeavesAtOnce - 1, kReachNowhere);
  layer.buckets.shrink_to_fit();
  layer.reaches.shrink_to_fit();
  layer.leaves.shrink_to_fit();
}

}  // namespace moontrace
