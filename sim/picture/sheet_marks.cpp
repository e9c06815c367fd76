#include "sim/picture/sheet_marks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <utility>

#include "sim/picture/contour.h"
#include "sim/picture/moon_marks.h"
#include "textures/base/units.h"
#include "textures/field/paper.h"
#include "textures/fonts/arc_fit.h"
#include "textures/typeset/rules.h"

namespace moontrace {

namespace {

constexpr double kPerWavelength = 5;  // cells that show a crest's form; twice as many where few
constexpr double kMostCells = 400000, kFewCells = 50000;
constexpr double kBandCells = 50000;  // of one path
constexpr double kUnseen = 0.03;      // [mm]; half of what an eye parts at reading distance
constexpr double kMostPerTile = 24;   // cells along a tile
constexpr double kCrest = 0.25;       // of the amplitude

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

/// The heights above the level of crests, of rows `from` to `to` of a patch's cells.
HeightGrid BandOf(const PaperPatch& patch, glm::dvec2 count, std::size_t from, std::size_t to) {
  HeightGrid band;
  band.columns = static_cast<std::size_t>(count.x);
  band.rows = to - from;
  const glm::dvec2 cell = (patch.box_P.max - patch.box_P.min) / count;
  const auto corner = [&](std::size_t i, std::size_t j) {
    return patch.box_P.min + glm::dvec2(i, j) * cell;
  };
  band.box = {corner(0, from), corner(band.columns, to)};
  const double level = kCrest * patch.texture.amplitude;
  for (std::size_t j = from; j <= to; ++j) {
    for (std::size_t i = 0; i <= band.columns; ++i) {
      band.heights.push_back(Evaluate(patch, corner(i, j)).displacement - level);
    }
  }
  return band;
}

/// Closed, in millimetres, without points too close to others to be seen.
std::vector<Piece> Polygon(const std::vector<glm::dvec2>& corners) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 from = corners[i], to = corners[(i + 1) % corners.size()];
    if (from != to) pieces.emplace_back(Line{kMillimetres * from, kMillimetres * to});
  }
  return MergePieces(pieces, kUnseen);
}

/// One mark a band: readers of SVG refuse a path of ten million characters.
void AddPatch(const PaperPatch& patch, std::vector<Mark>& marks) {
  const glm::dvec2 count = CellCount(patch);
  const auto rows = static_cast<std::size_t>(count.y);
  const auto height = std::max<std::size_t>(1, static_cast<std::size_t>(kBandCells / count.x));
  for (std::size_t from = 0; from < rows; from += height) {
    PathMark mark;
    mark.fill = palette::kRough;
    // one row of cells twice, or a seam would show between the bands
    const HeightGrid band = BandOf(patch, count, from, std::min(from + height + 1, rows));
    for (const std::vector<glm::dvec2>& outline : OutlinesAboveZero(band)) {
      mark.subpaths.push_back(Polygon(outline));
    }
    if (!mark.subpaths.empty()) marks.emplace_back(std::move(mark));
  }
}

}  // namespace

bool CanDraw(const PaperPatch& patch) {
  const glm::dvec2 count = CellCount(patch);
  return count.x * count.y <= kMostCells;
}

std::vector<Mark> TextureMarks(const std::vector<PaperPatch>& patches) {
  std::vector<Mark> marks;
  for (const PaperPatch& patch : patches) {
    if (CanDraw(patch)) AddPatch(patch, marks);
  }
  return marks;
}

std::vector<Mark> RuleMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                            glm::dvec2 from_P) {
  const auto in_drawing = [from_P](const Piece& piece) {
    return Placed(piece, kMillimetres, -kMillimetres * from_P);
  };
  const RaisedLines raised = RaisedLinesOf(page, script, style);
  std::vector<Mark> marks;
  PathMark rules;
  rules.stroke = palette::kRidge;
  rules.width = kMillimetres * RuleProfile(style).width;
  for (const Line& rule : raised.rules) rules.subpaths.push_back({in_drawing(Piece(rule))});
  if (!rules.subpaths.empty()) marks.emplace_back(std::move(rules));
  if (raised.margin.empty()) return marks;
  PathMark margin;
  margin.stroke = palette::kRidge;
  margin.width = kMillimetres * MarginProfile(style).width;
  std::vector<Piece>& path = margin.subpaths.emplace_back();
  for (const Piece& piece : raised.margin) path.push_back(in_drawing(piece));
  marks.emplace_back(std::move(margin));
  return marks;
}

Box RuleBounds(const TextPage& page, const Script& script, const TypeStyle& style) {
  const RaisedLines raised = RaisedLinesOf(page, script, style);
  Box box;
  for (const Line& rule : raised.rules) Include(box, BoundsOf(Piece(rule)));
  for (const Piece& piece : raised.margin) Include(box, BoundsOf(piece));
  return box;
}

}  // namespace moontrace
