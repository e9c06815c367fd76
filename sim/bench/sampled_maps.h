#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/bench/bench_page.h"
#include "textures/field/field.h"

namespace moontrace {

/// What a query is compared with: the same page as sampled heights, as most programs would keep it.
/// Bilinear height and gradient, floats.

/// The whole sheet.
class HeightGrid {
 public:
  HeightGrid(const TextureField& field, glm::dvec2 size, std::size_t columns, std::size_t rows);
  Sample SampleAt(glm::dvec2 p) const noexcept;
  std::size_t memory_bytes() const { return heights_.size() * sizeof(float); }

 private:
  std::size_t columns_, rows_;
  glm::dvec2 cells_per_m_;
  std::vector<float> heights_;
};

/// Each glyph once, as a texture atlas, and the lines of text: a line is found by its even pitch, a
/// letter in it by a table of places a letter's least width apart.
class GlyphAtlas {
 public:
  /// `step` from height to height [m]. The page is one of evenly spaced lines, its letters in
  /// order, none narrower than a place.
  GlyphAtlas(const BenchPage& page, double step);
  Sample SampleAt(glm::dvec2 p) const noexcept;
  std::size_t memory_bytes() const;

 private:
  struct Tile {
    glm::dvec2 min{0, 0};     ///< from the glyph's origin [m]
    std::uint32_t first = 0;  ///< of its heights
    std::uint16_t columns = 0, rows = 0;
  };
  struct Letter {
    double begin = 0;   ///< left edge on the page [m]
    double origin = 0;  ///< [m]
    std::uint32_t tile = 0;
  };
  double per_m_;                      ///< heights [1/m]
  double low_ = 0, pitch_ = 0;        ///< lower edge of the lowest line, from line to line [m]
  double places_per_m_ = 0;           ///< [1/m]
  std::size_t places_ = 0;            ///< in a line
  std::vector<double> baselines_;     ///< from the lowest line up [m]
  std::vector<std::uint32_t> first_;  ///< by line and place: the last letter that has begun there
  std::vector<Letter> letters_;       ///< line by line, each line ended by one that is far away
  std::vector<Tile> tiles_;
  std::vector<float> heights_;
};

}  // namespace moontrace
