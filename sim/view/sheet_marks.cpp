#include "sim/view/sheet_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/view/moon_marks.h"
#include "textures/paper.h"
#include "textures/rules.h"

namespace moontrace {

namespace {

constexpr double kMillimetres = 1e3;
constexpr double kPerWavelength = 5;  // cells that show a crest's form; twice as many where few
constexpr double kMostCells = 400000, kFewCells = 50000;
constexpr double kMostPerTile = 24;  // cells along a tile
constexpr double kCrest = 0.25;      // of the amplitude

/// Cells along both sides of a patch.
glm::dvec2 CellCount(const PaperPatch& patch) {
  const glm::dvec2 size = patch.box_P.max - patch.box_P.min;
  const PaperTexture& texture = patch.texture;
  if (texture.kind != PaperKind::kSampled) {
    const glm::dvec2 count = glm::max(glm::ceil(kPerWavelength / texture.wavelength * size), 1.0);
    return 4 * count.x * count.y <= kFewCells ? 2.0 * count : count;
  }
  // two cells a sample
  const glm::dvec2 samples(texture.heights->columns(), texture.heights->rows());
  if (!texture.tiled) return 2.0 * samples;
  return glm::max(glm::ceil(std::min(2.0 * samples.x, kMostPerTile) / texture.wavelength * size),
                  1.0);
}

std::vector<Piece> Polygon(const std::vector<glm::dvec2>& corners) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    pieces.emplace_back(Line{corners[i], corners[(i + 1) % corners.size()]});
  }
  return pieces;
}

/// The part of a cell where the height is above zero, straight between where its sides cross zero.
std::vector<glm::dvec2> Above(const std::array<glm::dvec2, 4>& corners,
                              const std::array<double, 4>& heights) {
  std::vector<glm::dvec2> polygon;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if (heights[i] > 0) polygon.push_back(corners[i]);
    if ((heights[i] > 0) != (heights[next] > 0)) {
      const double share = heights[i] / (heights[i] - heights[next]);
      polygon.push_back(corners[i] + share * (corners[next] - corners[i]));
    }
  }
  return polygon;
}

void AddPatch(const PaperPatch& patch, PathMark& mark) {
  const glm::dvec2 count = CellCount(patch), size = patch.box_P.max - patch.box_P.min;
  const auto columns = static_cast<std::size_t>(count.x), rows = static_cast<std::size_t>(count.y);
  const auto corner = [&](std::size_t i, std::size_t j) {
    return patch.box_P.min + glm::dvec2(i, j) / count * size;
  };
  const double level = kCrest * patch.texture.amplitude;
  std::vector<double> below(columns + 1), above(columns + 1);
  for (std::size_t j = 0; j <= rows; ++j) {
    std::swap(below, above);
    for (std::size_t i = 0; i <= columns; ++i) {
      above[i] = Evaluate(patch, corner(i, j)).displacement - level;
    }
    if (j == 0) continue;
    std::size_t run = 0;  // whole cells before this one
    for (std::size_t i = 0; i <= columns; ++i) {
      const bool whole =
          i < columns && std::min({below[i], below[i + 1], above[i], above[i + 1]}) > 0;
      if (whole) {
        ++run;
        continue;
      }
      if (run > 0) {
        const glm::dvec2 a = kMillimetres * corner(i - run, j - 1), b = kMillimetres * corner(i, j);
        mark.subpaths.push_back(Polygon({a, {b.x, a.y}, b, {a.x, b.y}}));
        run = 0;
      }
      if (i == columns) break;
      const glm::dvec2 a = kMillimetres * corner(i, j - 1), b = kMillimetres * corner(i + 1, j);
      const std::vector<glm::dvec2> part =
          Above({a, {b.x, a.y}, b, {a.x, b.y}}, {below[i], below[i + 1], above[i + 1], above[i]});
      if (part.size() > 2) mark.subpaths.push_back(Polygon(part));
    }
  }
}

Piece InMillimetres(const Piece& piece) { return Placed(piece, kMillimetres, {0, 0}); }

}  // namespace

bool CanDraw(const PaperPatch& patch) {
  const glm::dvec2 count = CellCount(patch);
  return count.x * count.y <= kMostCells;
}

std::vector<Mark> TextureMarks(const std::vector<PaperPatch>& patches) {
  PathMark mark;
  mark.fill = palette::kRough;
  for (const PaperPatch& patch : patches) {
    if (CanDraw(patch)) AddPatch(patch, mark);
  }
  std::vector<Mark> marks;
  if (!mark.subpaths.empty()) marks.emplace_back(std::move(mark));
  return marks;
}

std::vector<Mark> RuleMarks(const TextPage& page, const Script& script, const TypeStyle& style) {
  const RaisedLines raised = RaisedLinesOf(page, script, style);
  std::vector<Mark> marks;
  PathMark rules;
  rules.stroke = palette::kRidge;
  rules.width = kMillimetres * RuleProfile(style).width;
  for (const Line& rule : raised.rules) rules.subpaths.push_back({InMillimetres(Piece(rule))});
  if (!rules.subpaths.empty()) marks.emplace_back(std::move(rules));
  if (raised.margin.empty()) return marks;
  PathMark margin;
  margin.stroke = palette::kRidge;
  margin.width = kMillimetres * MarginProfile(style).width;
  std::vector<Piece>& way = margin.subpaths.emplace_back();
  for (const Piece& piece : raised.margin) way.push_back(InMillimetres(piece));
  marks.emplace_back(std::move(margin));
  return marks;
}

}  // namespace moontrace
