#include "textures/field/field.h"

#include <cmath>
#include <utility>

#include "textures/base/digest.h"
#include "textures/field/field_place.h"

namespace moontrace {

namespace {

/// How much steeper than its profile a crease can be where blending rounds it: 1 and twice the
/// greatest slope of the weight, 1.5 / rho, times the greatest pull, rho / 4 (blend.h).
constexpr double kBlendSteepens = 1.75;

void Add(Digest& digest, glm::dvec2 v) {
  digest.Add(v.x);
  digest.Add(v.y);
}

void Add(Digest& digest, const FlatElement& element) {
  Add(digest, element.anchor);
  Add(digest, element.direction);
  digest.Add(element.length);
  digest.Add(element.radius);
  digest.Add(element.cos_half);
  digest.Add(static_cast<std::uint64_t>(element.kind));
  digest.Add(static_cast<std::uint64_t>(element.profile));
}

void Add(Digest& digest, const Rows& rows) {
  digest.Add(rows.first_x);
  digest.Add(rows.step);
  for (const LetterPair pair : rows.pairs) digest.Add(pair.bits);
  for (const Letters& letters : rows.slots) {
    digest.Add(static_cast<std::uint64_t>(letters.first()));
    for (std::uint32_t i = 0; i < Letters::kMost; ++i) {
      const Code& code = rows.codes[letters.code(i)];
      digest.Add(static_cast<std::uint64_t>(code.step()));
      digest.Add(std::uint64_t{code.block()});
    }
  }
  for (const RowHeight& height : rows.heights) digest.Add(height.y);
  for (const std::uint32_t row : rows.of_band) digest.Add(std::uint64_t{row});
}

void Add(Digest& digest, const PaperField& paper) {
  for (const FlatPatch& patch : paper.patches()) {
    Add(digest, patch.box.min);
    Add(digest, patch.box.max);
    digest.Add(patch.fade_per_m);
    digest.Add(static_cast<std::uint64_t>(patch.kind));
    digest.Add(patch.amplitude);
    Add(digest, patch.wave);
    digest.Add(std::uint64_t{patch.seed} * 2 + (patch.tiled ? 1 : 0));
    if (patch.heights == nullptr) continue;
    digest.Add(std::uint64_t{patch.heights->columns()});
    for (const float height : patch.heights->heights()) digest.Add(static_cast<double>(height));
  }
}

template <class T, class Allocator>
std::size_t Bytes(const std::vector<T, Allocator>& values) {
  return values.capacity() * sizeof(T);
}

}  // namespace

TextureField::TextureField() = default;
TextureField::~TextureField() = default;
TextureField::TextureField(TextureField&&) noexcept = default;
TextureField& TextureField::operator=(TextureField&&) noexcept = default;

TextureField::TextureField(const Texture& texture) : paper_(texture.paper) {
  double slope_bound = 0;
  std::vector<CompiledPart> parts;
  for (const Layer& layer : texture.layers) {
    if (layer.group == nullptr || layer.group->bounds.min.x > layer.group->bounds.max.x) continue;
    const std::size_t first = parts.size();
    for (CompiledPart& part : CompileLayer(layer)) parts.push_back(std::move(part));
    double slope = 0, steepest = 0, curvature = 0, depth = 0;
    for (std::size_t i = first; i < parts.size(); ++i) {
      const bool blends = parts[i].layer.blend_radii.size() > 1;
      for (const FlatProfile& profile : parts[i].layer.profiles) {
        slope = std::fmax(slope, profile.slope);
        steepest = std::fmax(steepest, (blends ? kBlendSteepens : 1) * profile.slope);
        curvature = std::fmax(curvature, profile.curvature);
        depth = std::fmax(depth, profile.depth);
      }
    }
    greatest_slope_ += slope;
    greatest_curvature_ += curvature;
    greatest_displacement_ += depth;
    (layer.relief == Relief::kEmbossed ? greatest_rise_ : greatest_fall_) += depth;
    slope_bound += steepest;
  }
  const LayerMap others(parts);
  for (CompiledPart& part : parts) layers_.push_back(std::move(part.layer));
  if (!layers_.empty()) layers_.front().others = others;
  is_page_ = layers_.size() == 1 && !layers_.front().rows.pairs.empty() &&
             layers_.front().profiles.size() == 1 && paper_.empty();
  greatest_slope_ += paper_.bounds().slope;
  slope_bound += paper_.bounds().slope;
  greatest_curvature_ += paper_.bounds().curvature;
  greatest_displacement_ += paper_.bounds().displacement;
  greatest_rise_ += paper_.bounds().displacement;
  greatest_fall_ += paper_.bounds().displacement;
  if (slope_bound > 0) inverse_slope_bound_ = 1 / slope_bound;
}

std::size_t TextureField::memory_bytes() const noexcept {
  std::size_t bytes = sizeof *this + Bytes(layers_) + paper_.memory_bytes();
  for (const CompiledLayer& layer : layers_) {
    bytes += layer.others.memory_bytes() + Bytes(layer.rows.slots) + Bytes(layer.rows.pairs) +
             Bytes(layer.rows.heights) + Bytes(layer.rows.of_band) + Bytes(layer.bands) +
             Bytes(layer.buckets) + Bytes(layer.leaves) + Bytes(layer.reaches) +
             Bytes(layer.blocks) + Bytes(layer.blend_radii) + Bytes(layer.cells) +
             Bytes(layer.items) + Bytes(layer.lists) + Bytes(layer.block_blends) +
             Bytes(layer.elements) + Bytes(layer.fills) + Bytes(layer.fades) +
             Bytes(layer.profiles);
    for (const FlatFill& fill : layer.fills) bytes += Bytes(fill.edges) + Bytes(fill.rising);
  }
  return bytes;
}

std::uint64_t TextureField::Hash() const noexcept {
  Digest digest;
  for (const CompiledLayer& layer : layers_) {
    digest.Add(layer.sign);
    if (layer.joins) digest.Add(std::uint64_t{1});
    Add(digest, layer.rows);
    for (const std::uint32_t first : layer.bands) digest.Add(std::uint64_t{first});
    for (const Leaf& leaf : layer.leaves) {
      Add(digest, leaf.origin);
      digest.Add(std::uint64_t{leaf.block});
    }
    for (const std::uint16_t blend : layer.block_blends) digest.Add(layer.blend_radii[blend]);
    for (const FlatElement& element : layer.elements) Add(digest, element);
    for (const FlatFade& fade : layer.fades) {
      Add(digest, fade.spine);
      for (const double value : {fade.from, fade.to, fade.rate}) digest.Add(value);
    }
    for (const FlatFill& fill : layer.fills) {
      for (const FlatEdge& edge : fill.edges) Add(digest, edge.spine);
    }
    for (const FlatProfile& profile : layer.profiles) {
      digest.Add(profile.half);
      digest.Add(profile.rounding);
      digest.Add(profile.depth);
    }
  }
  Add(digest, paper_);
  return digest.value();
}

}  // namespace moontrace
