#include "textures/field/paper_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "textures/base/error.h"
#include "textures/base/units.h"
#include "textures/field/paper_noise.h"
#include "textures/field/paper_shape.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostPatches = 4096;
constexpr std::size_t kMostCells = 64;  // along a side

struct SineCosine {
  double sine, cosine;
};

/// Of 2 pi t, to 1e-13: Taylor's series within an eighth turn, its angle doubled twice. Without
/// branch and call; the library's functions take the time of a whole query.
inline SineCosine OfTurns(double t) noexcept {
  constexpr double kWhole = 0x1.8p52;  // adding it leaves no room for a fraction
  const double x = 0.25 * kTurn * (t - ((t + kWhole) - kWhole));
  const double q = x * x;
  const double s =
      x * (1 + q * (-1.0 / 6 +
                    q * (1.0 / 120 +
                         q * (-1.0 / 5040 + q * (1.0 / 362880 + q * (-1.0 / 39916800 +
                                                                     q * (1.0 / 6227020800)))))));
  const double c =
      1 + q * (-1.0 / 2 +
               q * (1.0 / 24 + q * (-1.0 / 720 +
                                    q * (1.0 / 40320 +
                                         q * (-1.0 / 3628800 +
                                              q * (1.0 / 479001600 + q * (-1.0 / 87178291200)))))));
  const double s2 = 2 * s * c, c2 = 1 - 2 * s * s;
  return {2 * s2 * c2, 1 - 2 * s2 * s2};
}

inline Sample OfWave(double amplitude, glm::dvec2 wave, glm::dvec2 p) noexcept {
  const SineCosine at = OfTurns(wave.x * p.x + wave.y * p.y);
  const double slope = kTurn * amplitude * at.cosine;
  return {amplitude * at.sine, {slope * wave.x, slope * wave.y}};
}

inline Sample OfHeights(const FlatPatch& patch, glm::dvec2 p) noexcept {
  const double u = p.x * patch.wave.x, v = p.y * patch.wave.y;
  const HeightSample at = patch.tiled ? patch.heights->Tiled(u, v) : patch.heights->Stretched(u, v);
  return {patch.amplitude * at.height,
          {patch.amplitude * at.gradient.x * patch.wave.x,
           patch.amplitude * at.gradient.y * patch.wave.y}};
}

/// `p_P` lies in the patch's box.
inline Sample OfPatch(const FlatPatch& patch, glm::dvec2 p_P) noexcept {
  const glm::dvec2 p(p_P.x - patch.box.min.x, p_P.y - patch.box.min.y);
  Sample sample;
  switch (patch.kind) {
    case PaperKind::kSine:
      sample = OfWave(patch.amplitude, patch.wave, p);
      break;
    case PaperKind::kGrid: {
      sample = OfWave(patch.amplitude, patch.wave, p);
      const Sample other = OfWave(patch.amplitude, {-patch.wave.y, patch.wave.x}, p);
      sample.displacement += other.displacement;
      sample.gradient += other.gradient;
      break;
    }
    case PaperKind::kNoise:
      sample = OfNoise(patch, p);
      break;
    case PaperKind::kSampled:
      sample = OfHeights(patch, p);
      break;
  }
  if (IsIn(patch.core, p_P)) return sample;
  Multiply(sample.gradient, sample.displacement,
           FadeAt(p.x, patch.box.max.x - p_P.x, patch.fade_per_m),
           FadeAt(p.y, patch.box.max.y - p_P.y, patch.fade_per_m));
  return sample;
}

FlatPatch Flatten(const PaperPatch& patch) {
  Check(patch);
  const PaperTexture& texture = patch.texture;
  FlatPatch flat;
  flat.box = patch.box_P;
  const double fade = FadeLength(flat.box, patch.fade);
  flat.core = Grown(flat.box, -fade);
  flat.fade_per_m = 1 / fade;
  flat.kind = texture.kind;
  flat.seed = texture.seed;
  flat.amplitude = texture.amplitude;
  const glm::dvec2 normal(std::cos(texture.angle), std::sin(texture.angle));
  switch (texture.kind) {
    case PaperKind::kGrid:
      flat.amplitude *= 0.5;
      [[fallthrough]];
    case PaperKind::kSine:
      flat.wave = normal / texture.wavelength;
      break;
    case PaperKind::kNoise:
      flat.amplitude *= std::numbers::sqrt2;
      flat.wave = glm::dvec2(kCellsPerWavelength / texture.wavelength);
      break;
    case PaperKind::kSampled: {
      flat.heights = texture.heights;
      flat.tiled = texture.tiled;
      const glm::dvec2 count(flat.heights->columns(), flat.heights->rows());
      flat.wave = texture.tiled ? glm::dvec2(count.x / texture.wavelength)
                                : (count - 1.0) / (flat.box.max - flat.box.min);
      break;
    }
  }
  const glm::dvec2 size = flat.box.max - flat.box.min;
  if (std::max(size.x, size.y) * std::max(std::abs(flat.wave.x), std::abs(flat.wave.y)) > 1e9) {
    throw InputError("texture wavelength is too short for the sheet: choose a longer one");
  }
  return flat;
}

}  // namespace

PaperField::PaperField(const std::vector<PaperPatch>& patches) {
  if (patches.size() > kMostPatches) throw InputError("more than 4096 paper textures on a page");
  std::vector<PaperBounds> bounds;
  for (const PaperPatch& patch : patches) {
    patches_.push_back(Flatten(patch));
    bounds.push_back(BoundsOf(patch));
    Include(box_, patch.box_P);
  }
  // patches that meet at a point all overlap each one of them
  for (std::size_t i = 0; i < patches.size(); ++i) {
    PaperBounds sum;
    for (std::size_t j = 0; j < patches.size(); ++j) {
      if (!Overlap(patches[i].box_P, patches[j].box_P)) continue;
      sum.displacement += bounds[j].displacement;
      sum.slope += bounds[j].slope;
      sum.curvature += bounds[j].curvature;
    }
    bounds_.displacement = std::max(bounds_.displacement, sum.displacement);
    bounds_.slope = std::max(bounds_.slope, sum.slope);
    bounds_.curvature = std::max(bounds_.curvature, sum.curvature);
  }
  if (!patches_.empty()) AddCells();
}

void PaperField::AddCells() {
  const std::size_t count = patches_.size() == 1 ? 1 : std::min(kMostCells, 4 * patches_.size());
  columns_ = count;
  cells_per_m_ = static_cast<double>(count) / (box_.max - box_.min);
  // computed as a query computes it, so that rounding cannot part them
  const auto cell_of = [count](double from_edge, double per_m) {
    return std::min(static_cast<std::size_t>(from_edge * per_m), count - 1);
  };
  std::vector<std::vector<std::uint16_t>> cells(count * count);
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const Box& box = patches_[i].box;
    const std::size_t left = cell_of(box.min.x - box_.min.x, cells_per_m_.x);
    const std::size_t right = cell_of(box.max.x - box_.min.x, cells_per_m_.x);
    const std::size_t top = cell_of(box.max.y - box_.min.y, cells_per_m_.y);
    for (std::size_t row = cell_of(box.min.y - box_.min.y, cells_per_m_.y); row <= top; ++row) {
      for (std::size_t column = left; column <= right; ++column) {
        cells[row * count + column].push_back(static_cast<std::uint16_t>(i));
      }
    }
  }
  for (const auto& cell : cells) {
    first_.push_back(static_cast<std::uint32_t>(items_.size()));
    items_.insert(items_.end(), cell.begin(), cell.end());
  }
  first_.push_back(static_cast<std::uint32_t>(items_.size()));
}

Sample PaperField::SampleAt(glm::dvec2 p_P) const noexcept {
  if (!IsIn(box_, p_P)) return {};
  return patches_.size() == 1 ? OfPatch(patches_.front(), p_P) : SampleCell(p_P);
}

Sample PaperField::SampleCell(glm::dvec2 p_P) const noexcept {
  const auto column = static_cast<std::size_t>((p_P.x - box_.min.x) * cells_per_m_.x);
  const auto row = static_cast<std::size_t>((p_P.y - box_.min.y) * cells_per_m_.y);
  const std::size_t cell = std::min(row, columns_ - 1) * columns_ + std::min(column, columns_ - 1);
  Sample sum;
  for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
    const FlatPatch& patch = patches_[items_[i]];
    if (!IsIn(patch.box, p_P)) continue;
    const Sample sample = OfPatch(patch, p_P);
    sum.displacement += sample.displacement;
    sum.gradient += sample.gradient;
  }
  return sum;
}

std::size_t PaperField::memory_bytes() const noexcept {
  std::size_t bytes = first_.capacity() * sizeof(std::uint32_t) +
                      items_.capacity() * sizeof(std::uint16_t) +
                      patches_.capacity() * sizeof(FlatPatch);
  // an array that several patches share is counted once
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const auto& heights = patches_[i].heights;
    bool counted = heights == nullptr;
    for (std::size_t j = 0; j < i; ++j) counted |= patches_[j].heights == heights;
    if (!counted) bytes += heights->memory_bytes();
  }
  return bytes;
}

}  // namespace moontrace
