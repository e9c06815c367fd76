#include "sim/picture/script_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "sim/picture/moon_marks.h"
#include "sim/picture/picture_messages.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"
#include "textures/typeset/fold.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

constexpr double kCell = 24;            ///< side of a cell [mm]
constexpr double kRoom = 15;            ///< for the sign in it [mm]
constexpr double kMargin = 8;           ///< [mm]
constexpr double kTop = 14;             ///< for the title [mm]
constexpr double kName = 2;             ///< height of a name's capital [mm]
constexpr double kNameLine = 3;         ///< from line to line of a long name [mm]
constexpr double kNameRoom = 5;         ///< below the signs [mm]
constexpr std::size_t kNameWidth = 14;  ///< letters of a name side by side

/// Box around all signs that are shown, base line and left edges included [em].
Box CommonBox(const Script& script, std::size_t shown) {
  Box box;
  Include(box, glm::dvec2(0, 0));
  Include(box, glm::dvec2(0.5, 1));
  for (std::size_t i = 0; i < shown; ++i) {
    for (const Stroke& stroke : script.glyphs[i].strokes) {
      for (const Piece& piece : stroke.pieces) Include(box, BoundsOf(piece));
    }
  }
  return Grown(box, script.stroke_width / 2);
}

/// A base line and a top line, thin and grey, to see sizes by.
TrackMark Rule(glm::dvec2 from, double length) {
  TrackMark rule;
  rule.points = {from, from + glm::dvec2(length, 0)};
  rule.stroke = palette::kGroove;
  rule.width = 0.15;
  return rule;
}

/// ASCII that any font for print can show: "U+65E5" for a character beyond. A long name is parted
/// in two behind its last hyphen or blank that fits.
std::vector<std::string> NameBelow(const std::string& name) {
  const std::u32string codes = ToCodePoints(name);
  if (codes.size() == 1 && codes[0] > 0x7E) {
    return {fmt::format("U+{:04X}", static_cast<unsigned>(codes[0]))};
  }
  const std::string shown = OneLine(name);
  if (shown.size() <= kNameWidth) return {shown};
  const std::size_t gap = shown.find_last_of("- ", kNameWidth - 1);
  if (gap == std::string::npos) return {OneLine(shown, kNameWidth - 3)};
  const std::string rest = shown.substr(gap + 1);
  return {shown.substr(0, gap + 1),
          rest.size() > kNameWidth ? OneLine(rest, kNameWidth - 3) : rest};
}

void AppendSign(const Script& script, std::size_t index, const Box& box, glm::dvec2 cell,
                Drawing& drawing) {
  const double scale = kRoom / std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  Box own;
  for (const Stroke& stroke : script.glyphs[index].strokes) {
    for (const Piece& piece : stroke.pieces) Include(own, BoundsOf(piece));
  }
  const double left = 0.5 * (kCell - scale * (own.max.x + own.min.x));
  const glm::dvec2 origin = cell + glm::dvec2(left, kNameRoom + 1 - scale * box.min.y);
  drawing.marks.emplace_back(Rule({cell.x + 2, origin.y}, kCell - 4));
  drawing.marks.emplace_back(Rule({cell.x + 2, origin.y + scale}, kCell - 4));

  TextPage page;
  page.glyphs.push_back({index, origin / 1e3});
  TypeStyle style;
  style.size = scale / 1e3;
  style.width = script.stroke_width * style.size;
  for (Mark& mark : MoonMarks(page, script, style, {0, 0}, palette::kInk)) {
    drawing.marks.push_back(std::move(mark));
  }
  for (const Stroke& stroke : script.glyphs[index].strokes) {
    if (stroke.kind != StrokeKind::kStroke || stroke.pieces.empty()) continue;
    CircleMark start;
    start.center = origin + scale * StartOf(stroke.pieces.front());
    start.radius = 0.7;
    start.stroke = palette::kAway;
    start.width = 0.3;
    drawing.marks.emplace_back(start);
  }
  double line = 1.5;
  for (std::string& name : NameBelow(script.glyphs[index].name)) {
    TextMark words;
    words.at =
        cell + glm::dvec2(0.5 * (kCell - 0.75 * kName * static_cast<double>(name.size())), line);
    words.height = kName;
    words.text = std::move(name);
    words.color = palette::kTip;
    drawing.marks.emplace_back(std::move(words));
    line -= kNameLine;
  }
}

}  // namespace

Drawing ScriptTable(const Script& script) {
  const std::size_t shown = std::min(script.glyphs.size(), kMostInTable);
  const std::size_t columns = std::min(shown, kRowOfTable);
  const std::size_t rows = (shown + kRowOfTable - 1) / kRowOfTable;
  Drawing drawing;
  drawing.width = 2 * kMargin + kCell * static_cast<double>(std::max<std::size_t>(columns, 4));
  drawing.height = 2 * kMargin + kTop + kCell * static_cast<double>(rows);
  drawing.title = say::TableTitle(script);
  drawing.description = say::TableWords(script, shown);
  const double top = drawing.height - kMargin - kTop;
  for (TextMark& line : TextBlock(drawing.title, {kMargin, drawing.height - kMargin},
                                  drawing.width - 2 * kMargin, 4, palette::kInk)) {
    drawing.marks.emplace_back(std::move(line));
  }
  const Box box = CommonBox(script, shown);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t row = i / kRowOfTable;
    const glm::dvec2 cell(kMargin + kCell * static_cast<double>(i % kRowOfTable),
                          top - kCell * static_cast<double>(row + 1));
    AppendSign(script, i, box, cell, drawing);
  }
  return drawing;
}

}  // namespace moontrace
