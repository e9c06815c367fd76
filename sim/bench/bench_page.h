#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// The page that everything is measured on: lines of 64 letters and spaces drawn by English letter
/// frequencies, words of English length, 5 mm letters; 64 x 30 is the paper's.
struct BenchPage {
  Script script;
  TypeStyle style;
  TextPage sheet;
  Texture texture;
  glm::dvec2 size{0, 0};  ///< of the sheet [m]
};
/// More pages than one stand above each other, as one sheet.
BenchPage MakeBenchPage(std::size_t pages, std::uint64_t seed);
/// One such page with everything on: every tenth line a heading of 1.5 times the size, groove links
/// within words, line rules, a raised margin, rough paper.
BenchPage MakeRichBenchPage(std::uint64_t seed);

/// A page of 480 signs of 12 mm, links across words asked for and not yet found; without a texture.
BenchPage MakeLinkBenchPage(std::uint64_t seed);

/// Seeded points inside the letters' boxes.
std::vector<glm::dvec2> PointsInLetters(const BenchPage& page, std::size_t count,
                                        std::uint64_t seed);
/// A finger's path: along every line of text with a weave of 2 mm, a point each 50 um (50 mm/s at 1
/// kHz).
std::vector<glm::dvec2> SlidingPoints(const BenchPage& page, std::size_t most);

}  // namespace moontrace
