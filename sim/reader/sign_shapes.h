#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "textures/field/piece.h"
#include "textures/fonts/script.h"

namespace moontrace {

/// A point of a sign's centre lines. All in em, as Glyph.
struct SignPoint {
  glm::dvec2 p{0, 0};
  glm::dvec2 tangent{1, 0};  ///< unit
};

/// How lines run over the paper.
enum class LinesRun { kRight, kLeft, kDown };

/// The signs that a reader knows, made ready for asking how far a felt point lies from each.
class SignShapes {
 public:
  /// A coordinate beyond a sign's own box by more than this is as far as it gets [em].
  static constexpr double kFarthest = 0.4;

  /// What stands for a small dot: the floor that a tip in it keeps to, or its middle.
  enum class Dots { kFloors, kMiddles };

  /// Distances to a sign's lines, at the middles of cells.
  struct Table {
    glm::dvec2 corner{0, 0};  ///< lower left [em]
    int columns = 0, rows = 0;
    std::vector<float> cells;  ///< row by row from below [em]
    float At(int column, int row) const noexcept {
      return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column)];
    }
  };
  static constexpr double kPerEm = 50;  ///< cells of a table

  SignShapes() = default;
  /// `which`: indices into the script's glyphs. Glyphs without strokes are left out.
  SignShapes(const Script& script, const std::vector<std::size_t>& which,
             Dots dots = Dots::kFloors);

  std::size_t size() const { return signs_.size(); }
  /// Index into the script's glyphs.
  std::size_t GlyphOf(std::size_t sign) const { return signs_[sign].glyph; }
  /// The glyph that means the same in its plain form: of other forms of a sign that sign's.
  std::size_t MeaningOf(std::size_t sign) const { return signs_[sign].meaning; }
  bool IsDots(std::size_t sign) const { return signs_[sign].dots; }          ///< and nothing else
  double Advance(std::size_t sign) const { return signs_[sign].advance; }    ///< [em]
  const Box& Bounds(std::size_t sign) const { return signs_[sign].bounds; }  ///< of centre lines
  /// Along its strokes, 0.05 em apart; of fills the outline.
  const std::vector<SignPoint>& Points(std::size_t sign) const { return signs_[sign].points; }
  /// To the nearest centre line, or floor or middle of a dot; within a larger fill the distance to
  /// its outline, below zero; at most kFarthest [em]. From a table of 0.02 em.
  double Distance(std::size_t sign, glm::dvec2 p) const noexcept {
    const Table& table = signs_[sign].table;
    const int i = static_cast<int>((p.x - table.corner.x) * kPerEm);
    const int j = static_cast<int>((p.y - table.corner.y) * kPerEm);
    if (p.x < table.corner.x || p.y < table.corner.y || i >= table.columns || j >= table.rows) {
      return kFarthest;
    }
    return table.At(i, j);
  }
  const Table& TableOf(std::size_t sign) const { return signs_[sign].table; }

  /// The signs as they follow each other in such lines, which themselves are mirrored or turned so
  /// that they run to the right. Leftwards a sign begins at the right edge of its strokes;
  /// downwards it stands in the middle of an em, begins at that em's upper edge, and has the same
  /// gap behind it as in a line to the right (layout.h).
  SignShapes AlongLines(LinesRun lines) const;
  /// Where the origin of a sign lies then [em].
  glm::dvec2 OriginAlongLines(std::size_t sign, LinesRun lines) const {
    return AlongLines(signs_[sign], lines, {0, 0});
  }

 private:
  struct Sign {
    std::size_t glyph = 0, meaning = 0;
    double advance = 0;
    bool dots = false;
    Box bounds;
    std::vector<SignPoint> points;
    Table table;
  };
  static Sign Make(const Glyph& glyph, std::size_t index, Dots dots);
  static glm::dvec2 AlongLines(const Sign& sign, LinesRun lines, glm::dvec2 p);
  static Table AlongLines(const Sign& sign, LinesRun lines);
  static void FillTable(const Glyph& glyph, Dots dots, Sign& sign);

  std::vector<Sign> signs_;
};

/// Every glyph of a script that some text can become: bound to a character, a digit, a group of
/// letters, the numeral sign, and the other forms of those.
std::vector<std::size_t> WrittenGlyphs(const Script& script);

}  // namespace moontrace
