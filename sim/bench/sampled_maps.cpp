#include "sim/bench/sampled_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "textures/relief/glyph_group.h"

namespace moontrace {

namespace {

/// Bilinear height and gradient between four heights; u and v are shares of a cell.
Sample Bilinear(const float* below, const float* above, double u, double v,
                glm::dvec2 cells_per_m) noexcept {
  const double a = below[0], b = below[1], c = above[0], d = above[1];
  return {(a * (1 - u) + b * u) * (1 - v) + (c * (1 - u) + d * u) * v,
          {((b - a) * (1 - v) + (d - c) * v) * cells_per_m.x,
           ((c - a) * (1 - u) + (d - b) * u) * cells_per_m.y}};
}

}  // namespace

HeightGrid::HeightGrid(const TextureField& field, glm::dvec2 size, std::size_t columns,
                       std::size_t rows)
    : columns_(columns),
      rows_(rows),
      cells_per_m_(glm::dvec2(columns - 1, rows - 1) / size),
      heights_(columns * rows) {
  std::vector<glm::dvec2> points(columns);
  std::vector<Sample> samples(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      points[column] = glm::dvec2(column, row) / cells_per_m_;
    }
    field.SamplesAt(points, samples);
    for (std::size_t column = 0; column < columns; ++column) {
      heights_[row * columns + column] = static_cast<float>(samples[column].displacement);
    }
  }
}

Sample HeightGrid::SampleAt(glm::dvec2 p) const noexcept {
  double u = p.x * cells_per_m_.x, v = p.y * cells_per_m_.y;
  const auto column = std::min(static_cast<std::size_t>(u > 0 ? u : 0), columns_ - 2);
  const auto row = std::min(static_cast<std::size_t>(v > 0 ? v : 0), rows_ - 2);
  u -= static_cast<double>(column);
  v -= static_cast<double>(row);
  const float* below = &heights_[row * columns_ + column];
  return Bilinear(below, below + columns_, u, v, cells_per_m_);
}

GlyphAtlas::GlyphAtlas(const BenchPage& page, double step) : per_m_(1 / step) {
  std::map<std::uint32_t, Box> boxes;
  std::map<std::uint32_t, std::uint32_t> tile_of;
  double low = 0, high = 0, narrowest = std::numeric_limits<double>::infinity();
  for (const PlacedGlyph& glyph : page.sheet.glyphs) {
    const auto number = static_cast<std::uint32_t>(glyph.glyph);
    if (tile_of.contains(number)) continue;
    Texture texture;
    texture.layers.push_back(
        {Finish(BuildGlyph(page.script.glyphs[glyph.glyph], page.style)), page.style.relief});
    const Box box = texture.layers.front().group->bounds;
    const TextureField field(texture);
    Tile tile{box.min, static_cast<std::uint32_t>(heights_.size()), 0, 0};
    tile.columns = static_cast<std::uint16_t>(std::ceil((box.max.x - box.min.x) * per_m_) + 2);
    tile.rows = static_cast<std::uint16_t>(std::ceil((box.max.y - box.min.y) * per_m_) + 2);
    for (int row = 0; row < tile.rows; ++row) {
      for (int column = 0; column < tile.columns; ++column) {
        const glm::dvec2 p = box.min + step * glm::dvec2(column, row);
        heights_.push_back(static_cast<float>(field.SampleAt(p).displacement));
      }
    }
    tile_of[number] = static_cast<std::uint32_t>(tiles_.size());
    tiles_.push_back(tile);
    boxes[number] = box;
    low = std::min(low, box.min.y);
    high = std::max(high, box.max.y);
    narrowest = std::min(narrowest, box.max.x - box.min.x);
  }
  // lines from the lowest up, letters from left to right
  std::map<double, std::vector<const PlacedGlyph*>> lines;
  for (const PlacedGlyph& glyph : page.sheet.glyphs) {
    lines[glyph.origin_P.y].push_back(&glyph);
  }
  low_ = lines.begin()->first + low;
  pitch_ = lines.size() > 1 ? std::next(lines.begin())->first - lines.begin()->first : high - low;
  places_per_m_ = 1 / std::max(narrowest, step);
  places_ = static_cast<std::size_t>(page.size.x * places_per_m_) + 1;
  for (const auto& [y, glyphs] : lines) {
    baselines_.push_back(y);
    const std::size_t begin = letters_.size();
    letters_.push_back({-1, 0, 0});  // before the first letter there is the first, far to the left
    for (const PlacedGlyph* glyph : glyphs) {
      const auto number = static_cast<std::uint32_t>(glyph->glyph);
      letters_.push_back(
          {glyph->origin_P.x + boxes[number].min.x, glyph->origin_P.x, tile_of[number]});
    }
    letters_[begin].origin = -1e3;
    letters_.push_back({std::numeric_limits<double>::infinity(), 1e3, 0});
    std::size_t at = begin;
    for (std::size_t place = 0; place < places_; ++place) {
      while (letters_[at + 1].begin <= static_cast<double>(place) / places_per_m_) ++at;
      first_.push_back(static_cast<std::uint32_t>(at));
    }
  }
}

Sample GlyphAtlas::SampleAt(glm::dvec2 p) const noexcept {
  const double line = (p.y - low_) / pitch_;
  const double place = p.x * places_per_m_;
  if (!(line >= 0 && line < static_cast<double>(baselines_.size()) && place >= 0 &&
        place < static_cast<double>(places_))) {
    return {};
  }
  const auto number = static_cast<std::size_t>(line);
  std::uint32_t at = first_[number * places_ + static_cast<std::size_t>(place)];
  at += letters_[at + 1].begin <= p.x ? 1 : 0;  // at most one begins within a place
  const Letter& letter = letters_[at];
  const Tile& tile = tiles_[letter.tile];
  double u = (p.x - letter.origin - tile.min.x) * per_m_;
  double v = (p.y - baselines_[number] - tile.min.y) * per_m_;
  if (!(u >= 0 && v >= 0 && u < tile.columns - 1 && v < tile.rows - 1)) return {};
  const auto column = static_cast<std::size_t>(u), row = static_cast<std::size_t>(v);
  u -= static_cast<double>(column);
  v -= static_cast<double>(row);
  const float* below = &heights_[tile.first + row * tile.columns + column];
  return Bilinear(below, below + tile.columns, u, v, {per_m_, per_m_});
}

std::size_t GlyphAtlas::memory_bytes() const {
  return heights_.size() * sizeof(float) + letters_.size() * sizeof(Letter) +
         first_.size() * sizeof(std::uint32_t) + tiles_.size() * sizeof(Tile);
}

}  // namespace moontrace
