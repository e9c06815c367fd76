#include "sim/reader/sign_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "textures/field/fill.h"

namespace moontrace {
namespace {

constexpr double kSpot = 0.301;       ///< fills that are smaller are spots, Braille's too [em]
constexpr double kSpotFloor = 0.055;  ///< a tip in a spot lies so far within its outline [em]

/// A dot: so small that a tip in it feels no direction.
bool IsSpot(const Stroke& stroke) {
  if (stroke.kind == StrokeKind::kStroke) return false;
  Box box;
  for (const Piece& piece : stroke.pieces) Include(box, BoundsOf(piece));
  return box.max.x - box.min.x < kSpot && box.max.y - box.min.y < kSpot;
}

/// To a stroke's centre line; within a fill the distance to its outline, below zero; to the floor
/// of a spot, 0 there, or to its middle.
double DistanceToStroke(const Stroke& stroke, glm::dvec2 p, SignShapes::Dots dots) {
  if (dots == SignShapes::Dots::kMiddles && IsSpot(stroke)) {
    Box box;
    for (const Piece& piece : stroke.pieces) Include(box, BoundsOf(piece));
    return glm::distance(p, 0.5 * (box.min + box.max));
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const Piece& piece : stroke.pieces) nearest = std::min(nearest, DistanceTo(piece, p));
  if (stroke.kind != StrokeKind::kStroke && IsInside(stroke.pieces, p)) nearest = -nearest;
  return IsSpot(stroke) ? std::max(0.0, nearest + kSpotFloor) : nearest;
}

}  // namespace

SignShapes::SignShapes(const Script& script, const std::vector<std::size_t>& which, Dots dots) {
  for (const std::size_t index : which) {
    const Glyph& glyph = script.glyphs[index];
    if (!glyph.strokes.empty()) signs_.push_back(Make(glyph, index, dots));
  }
  for (Sign& sign : signs_) {
    for (const auto& [name, forms] : script.forms) {
      const std::size_t plain = script.Find(name);
      for (const auto& [form, glyph] : forms) {
        if (plain != Script::npos && script.Find(glyph) == sign.glyph) sign.meaning = plain;
      }
    }
  }
}

SignShapes::Sign SignShapes::Make(const Glyph& glyph, std::size_t index, Dots dots) {
  constexpr double kSpacing = 0.05;  // [em]
  Sign sign;
  sign.glyph = sign.meaning = index;
  sign.advance = glyph.advance;
  sign.dots = std::all_of(glyph.strokes.begin(), glyph.strokes.end(), IsSpot);
  for (const Stroke& stroke : glyph.strokes) {
    for (const Piece& piece : stroke.pieces) {
      Include(sign.bounds, BoundsOf(piece));
      const double length = Length(piece);
      const int count = std::max(1, static_cast<int>(std::lround(length / kSpacing)));
      for (int i = 0; i <= count; ++i) {
        const double s = length * i / count;
        sign.points.push_back({PointAt(piece, s), TangentAt(piece, s)});
      }
    }
  }
  FillTable(glyph, dots, sign);
  return sign;
}

void SignShapes::FillTable(const Glyph& glyph, Dots dots, Sign& sign) {
  const Box box = Grown(sign.bounds, kFarthest);
  Table& table = sign.table;
  table.corner = box.min;
  table.columns = static_cast<int>(std::ceil((box.max.x - box.min.x) * kPerEm));
  table.rows = static_cast<int>(std::ceil((box.max.y - box.min.y) * kPerEm));
  table.cells.reserve(static_cast<std::size_t>(table.columns) *
                      static_cast<std::size_t>(table.rows));
  for (int j = 0; j < table.rows; ++j) {
    for (int i = 0; i < table.columns; ++i) {
      const glm::dvec2 p = box.min + glm::dvec2(i + 0.5, j + 0.5) / kPerEm;
      double nearest = kFarthest;
      for (const Stroke& stroke : glyph.strokes) {
        nearest = std::min(nearest, DistanceToStroke(stroke, p, dots));
      }
      table.cells.push_back(static_cast<float>(nearest));
    }
  }
}

glm::dvec2 SignShapes::AlongLines(const Sign& sign, LinesRun lines, glm::dvec2 p) {
  const double right = sign.bounds.max.x;
  switch (lines) {
    case LinesRun::kLeft:
      return {right - p.x, p.y};
    case LinesRun::kDown:
      return {1 - p.y, p.x + (1 - right) / 2};
    case LinesRun::kRight:
      break;
  }
  return p;
}

/// Cell by cell: they are square, and lie on each other.
SignShapes::Table SignShapes::AlongLines(const Sign& sign, LinesRun lines) {
  const Table& table = sign.table;
  const bool down = lines == LinesRun::kDown;
  const glm::dvec2 upper = table.corner + glm::dvec2(table.columns, table.rows) / kPerEm;
  const glm::dvec2 a = AlongLines(sign, lines, table.corner), b = AlongLines(sign, lines, upper);
  Table along;
  along.corner = glm::min(a, b);
  along.columns = down ? table.rows : table.columns;
  along.rows = down ? table.columns : table.rows;
  along.cells.reserve(table.cells.size());
  for (int row = 0; row < along.rows; ++row) {
    for (int column = 0; column < along.columns; ++column) {
      const int back = along.columns - 1 - column;
      along.cells.push_back(down ? table.At(row, back) : table.At(back, row));
    }
  }
  return along;
}

SignShapes SignShapes::AlongLines(LinesRun lines) const {
  SignShapes along = *this;
  if (lines == LinesRun::kRight) return along;
  for (Sign& sign : along.signs_) {
    const Sign was = sign;
    const double right = was.bounds.max.x;
    sign.bounds = {};
    Include(sign.bounds, AlongLines(was, lines, was.bounds.min));
    Include(sign.bounds, AlongLines(was, lines, was.bounds.max));
    if (lines == LinesRun::kDown) sign.advance = 1 + std::max(was.advance - right, 0.0);
    for (SignPoint& point : sign.points) {
      const glm::dvec2 on = AlongLines(was, lines, point.p + point.tangent);
      point.p = AlongLines(was, lines, point.p);
      point.tangent = on - point.p;
    }
    sign.table = AlongLines(was, lines);
  }
  return along;
}

std::vector<std::size_t> WrittenGlyphs(const Script& script) {
  std::set<std::string> names;
  for (const auto& [character, name] : script.signs) names.insert(name);
  for (const auto& [digit, name] : script.digits) names.insert(name);
  for (const Contraction& contraction : script.contractions) {
    names.insert(contraction.signs.begin(), contraction.signs.end());
  }
  if (!script.numeral_sign.empty()) names.insert(script.numeral_sign);
  for (const auto& [name, forms] : script.forms) {
    if (names.count(name) == 0) continue;
    for (const auto& [form, glyph] : forms) names.insert(glyph);
  }
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < script.glyphs.size(); ++i) {
    if (names.count(script.glyphs[i].name) != 0) which.push_back(i);
  }
  return which;
}

}  // namespace moontrace
