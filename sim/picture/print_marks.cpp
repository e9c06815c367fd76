#include "sim/picture/print_marks.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "sim/picture/moon_marks.h"
#include "textures/base/error.h"
#include "textures/base/units.h"
#include "textures/typeset/layout.h"
#include "textures/typeset/reshape.h"
#include "textures/typeset/rules.h"

namespace moontrace {

namespace {

constexpr double kShare = 0.25;     // of the letter that the print is high
constexpr double kSmallest = 5e-4;  // [m]
constexpr double kGap = 0.35;       // over the print, in its heights
constexpr double kBlock = 1.6;      // gap, capital and what hangs below the line, in its heights

/// How far strokes reach from the base line [m].
struct Reach {
  double low = 0, high = 0;              ///< as drawn, the groove's width included
  double ridge_low = 0, ridge_high = 0;  ///< as line rules keep away: that width round dots too
};

/// By kinds of line, as drawn of the signs that stand for print, as rules keep away of all but
/// guide lines, which lead to the next line: a numeral sign stands for no print.
std::map<LineKind, Reach> ReachOf(const TextPage& page, const Script& script,
                                  const TypeStyle& style) {
  std::map<LineKind, Reach> reach;
  for (const PlacedGlyph& placed : page.glyphs) {
    if (IsGuide(script.glyphs[placed.glyph])) continue;
    const bool printed = placed.source_begin != placed.source_end;
    const double scale = ScaleOf(placed.kind, style), half = 0.5 * scale * style.width;
    Reach& own = reach[placed.kind];
    for (const Stroke& stroke : script.glyphs[placed.glyph].strokes) {
      const double drawn = stroke.kind == StrokeKind::kStroke ? half : 0;
      for (const Piece& piece : stroke.pieces) {
        const Box box = BoundsOf(Placed(piece, scale * style.size, {0, 0}));
        if (printed) {
          own.low = std::min(own.low, box.min.y - drawn);
          own.high = std::max(own.high, box.max.y + drawn);
        }
        own.ridge_low = std::min(own.ridge_low, box.min.y - half);
        own.ridge_high = std::max(own.ridge_high, box.max.y + half);
      }
    }
  }
  return reach;
}

/// Height of a capital, and where it stands below the base line [m].
struct Print {
  double height = 0, below = 0;
};

Print PrintOf(const Reach& reach, double scale, const TypeStyle& style) {
  const double gap = style.line_pitch - style.size;
  const double wanted =
      scale * std::clamp(kShare * style.size, kSmallest, std::max(kSmallest, 0.5 * gap));
  const double pitch = scale * style.line_pitch;
  const auto fitting = [&](double room) { return std::min(wanted, room / kBlock); };
  if (style.rules.lines && style.lines != LineDirection::kVertical) {
    const double rule = RuleGap(style) + RuleProfile(style).width;
    const double room = pitch - (reach.ridge_high - reach.ridge_low) - 2 * rule;
    const double height = fitting(room);
    if (height < kSmallest - 1e-9) {
      throw InputError(
          fmt::format("line pitch {:.4g} mm leaves no room for print between the rules: choose "
                      "{:.4g} mm or more",
                      InMillimetres(pitch),
                      std::ceil(InMillimetres(pitch - room + kBlock * kSmallest) * 100) / 100));
    }
    return {height, rule - reach.ridge_low + (kGap + 1) * height};
  }
  const double height = std::max(0.5 * wanted, fitting(pitch - (reach.high - reach.low)));
  return {height, -reach.low + (kGap + 1) * height};
}

}  // namespace

std::vector<Mark> PrintMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                             std::string_view source) {
  const std::map<LineKind, Reach> reach = ReachOf(page, script, style);
  std::vector<Mark> marks;
  for (const PlacedGlyph& placed : page.glyphs) {
    if (placed.source_begin == placed.source_end) continue;
    const double scale = ScaleOf(placed.kind, style);
    const Print print = PrintOf(reach.at(placed.kind), scale, style);
    const glm::dvec2 foot(scale * style.size * FootShift(style.form), -print.below);
    TextMark mark;
    mark.height = kMillimetres * print.height;
    mark.at = kMillimetres * (placed.origin_P + foot);
    mark.text = source.substr(placed.source_begin, placed.source_end - placed.source_begin);
    mark.color = palette::kTip;
    marks.emplace_back(std::move(mark));
  }
  return marks;
}

}  // namespace moontrace
