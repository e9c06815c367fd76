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

bool HasRulesAcross(const TypeStyle& style) {
  return style.rules.lines && style.lines != LineDirection::kVertical;
}

/// From the base line, without a raised margin.
PrintRoom RoomOf(const Reach& reach, double scale, const TypeStyle& style) {
  const double pitch = scale * style.line_pitch;
  if (!HasRulesAcross(style)) return {reach.low, reach.high - pitch};
  const double rule = RuleGap(style) + RuleProfile(style).width;
  return {reach.ridge_low - rule, reach.ridge_high + rule - pitch};
}

std::size_t LastLine(const TextPage& page) {
  std::size_t last = 0;
  for (const PlacedGlyph& placed : page.glyphs) last = std::max(last, placed.line);
  return last;
}

/// By kinds of line; below one that stands on the last line only there is nothing.
std::map<LineKind, PrintRoom> RoomsOfKinds(const TextPage& page, const Script& script,
                                           const TypeStyle& style) {
  std::map<LineKind, PrintRoom> rooms;
  for (const auto& [kind, reach] : ReachOf(page, script, style)) {
    rooms[kind] = RoomOf(reach, ScaleOf(kind, style), style);
    const bool alone =
        std::none_of(page.glyphs.begin(), page.glyphs.end(),
                     [kind = kind, last = LastLine(page)](const PlacedGlyph& placed) {
                       return placed.kind == kind && placed.line != last;
                     });
    if (alone) rooms[kind].bottom = -HUGE_VAL;
  }
  return rooms;
}

/// Of a capital [m]; between rules what fits there, which may be nothing.
double HeightOf(const PrintRoom& room, double scale, const TypeStyle& style) {
  const double gap = style.line_pitch - style.size;
  const double wanted =
      scale * std::clamp(kShare * style.size, kSmallest, std::max(kSmallest, 0.5 * gap));
  const double fitting = std::min(wanted, (room.top - room.bottom) / kBlock);
  return HasRulesAcross(style) ? fitting : std::max(0.5 * wanted, fitting);
}

void CheckHeight(double height, const PrintRoom& room, double scale, const TypeStyle& style) {
  if (height >= kSmallest - 1e-9) return;
  const double pitch = scale * style.line_pitch;
  const double least = pitch - (room.top - room.bottom) + kBlock * kSmallest;
  throw InputError(
      fmt::format("line pitch {:.4g} mm leaves no room for print between the rules: choose "
                  "{:.4g} mm or more",
                  InMillimetres(pitch), std::ceil(InMillimetres(least) * 100) / 100));
}

/// The lower edge of a raised margin, from rim to rim; without one far below.
PrintRoom LowerMargin(const TextPage& page, const Script& script, const TypeStyle& style) {
  PrintRoom ridge{-HUGE_VAL, -HUGE_VAL};
  if (!style.rules.margin) return ridge;
  Box box;
  for (const Piece& piece : RaisedLinesOf(page, script, style).margin) {
    Include(box, BoundsOf(piece));
  }
  const double half = 0.5 * MarginProfile(style).width;
  if (box.min.y <= box.max.y) ridge = {box.min.y + half, box.min.y - half};
  return ridge;
}

}  // namespace

std::vector<PrintRoom> PrintRooms(const TextPage& page, const Script& script,
                                  const TypeStyle& style) {
  std::map<LineKind, PrintRoom> kinds = RoomsOfKinds(page, script, style);
  const PrintRoom margin = LowerMargin(page, script, style);
  const std::size_t last = LastLine(page);
  std::vector<PrintRoom> rooms;
  for (const PlacedGlyph& placed : page.glyphs) {
    const double scale = ScaleOf(placed.kind, style);
    const PrintRoom room = kinds[placed.kind];  // guide lines may be alone
    const double needed = kBlock * std::max(HeightOf(room, scale, style), kSmallest);
    PrintRoom& there = rooms.emplace_back(
        PrintRoom{placed.origin_P.y + room.top, placed.origin_P.y + room.bottom});
    if (placed.line == last) there.bottom = page.sheet_P.min.y;
    if (margin.top <= there.bottom || margin.bottom >= there.top) continue;
    if (there.top - margin.top >= needed) {
      there.bottom = margin.top;
    } else {
      there = {margin.bottom, page.sheet_P.min.y};
    }
  }
  return rooms;
}

std::vector<Mark> PrintMarks(const TextPage& page, const Script& script, const TypeStyle& style,
                             std::string_view source) {
  const std::map<LineKind, PrintRoom> kinds = RoomsOfKinds(page, script, style);
  const std::vector<PrintRoom> rooms = PrintRooms(page, script, style);
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < page.glyphs.size(); ++i) {
    const PlacedGlyph& placed = page.glyphs[i];
    if (placed.source_begin == placed.source_end) continue;
    const double scale = ScaleOf(placed.kind, style);
    const PrintRoom& room = kinds.at(placed.kind);
    const double height = HeightOf(room, scale, style);
    CheckHeight(height, room, scale, style);
    TextMark mark;
    mark.height = kMillimetres * height;
    mark.at =
        kMillimetres * glm::dvec2(placed.origin_P.x + scale * style.size * FootShift(style.form),
                                  rooms[i].top - (kGap + 1) * height);
    mark.text = source.substr(placed.source_begin, placed.source_end - placed.source_begin);
    mark.color = palette::kTip;
    marks.emplace_back(std::move(mark));
  }
  return marks;
}

}  // namespace moontrace
