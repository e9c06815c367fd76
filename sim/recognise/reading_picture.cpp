#include "sim/recognise/reading_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sim/console/wording.h"
#include "sim/picture/link_marks.h"
#include "sim/picture/link_messages.h"
#include "sim/picture/moon_marks.h"
#include "sim/picture/print_marks.h"
#include "sim/picture/sheet_marks.h"
#include "sim/picture/sheet_messages.h"
#include "sim/reading/read_text.h"
#include "sim/reading/reading_setup.h"
#include "sim/recognise/recognise_messages.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

/// The tip's path while it touches, searching (kTravel) or following (kStroke), a track each.
std::vector<Mark> Tracks(const std::vector<PathPoint>& path, glm::dvec2 from_P, double width) {
  std::vector<Mark> marks;
  TrackMark track;
  track.width = width;
  TracePhase phase = TracePhase::kAir;
  const auto end_track = [&] {
    track.stroke = phase == TracePhase::kStroke ? palette::kTip : palette::kAway;
    if (track.points.size() > 1) marks.emplace_back(track);
    track.points.clear();
  };
  for (const PathPoint& point : path) {
    if (!point.in_contact || point.phase != phase) end_track();
    phase = point.phase;
    if (point.in_contact && phase != TracePhase::kAir) {
      track.points.push_back(kMillimetres * (glm::dvec2(point.tip_P) - from_P));
    }
  }
  end_track();
  return marks;
}

/// White behind a line of print, so that it can be read where the tip's path passes.
PathMark PlateOf(const TextMark& print) {
  constexpr double kWide = 0.95;  // a letter, in its heights, about
  const double h = print.height;
  const double width = kWide * h * static_cast<double>(CountCharacters(print.text));
  const glm::dvec2 low = print.at - glm::dvec2(0.15 * h, 0.3 * h);
  const glm::dvec2 high = print.at + glm::dvec2(width + 0.15 * h, 1.15 * h);
  PathMark plate;
  plate.fill = Color{1, 1, 1};
  plate.subpaths = {{Line{low, {high.x, low.y}}, Line{{high.x, low.y}, high},
                     Line{high, {low.x, high.y}}, Line{{low.x, high.y}, low}}};
  return plate;
}

/// Where print stands, from the base line down: clear of strokes and of a lower rule [em].
double BelowOf(const TextPage& page, const Script& script, const TypeStyle& style, double height) {
  constexpr double kLeast = 0.35, kGap = 0.3;  // the gap in heights of the print
  const std::vector<PrintRoom> rooms = PrintRooms(page, script, style);
  double strokes = HUGE_VAL;  // [m]
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const PlacedGlyph& placed = page.glyphs[i];
    if (placed.kind == LineKind::kHeading) continue;
    strokes = std::min(strokes, placed.origin_P.y - rooms[i].top);
  }
  if (!std::isfinite(strokes)) return kLeast;
  return std::max(kLeast, (strokes + (1 + kGap) * height / kMillimetres) / style.size);
}

std::vector<Mark> PrintOf(const ReadingResult& result, const Script& script, glm::dvec2 from_P,
                          double height, double below) {
  std::vector<TextMark> print;
  for (const ReadToken& token : result.tokens) {
    const bool known = token.kind == ReadToken::Kind::kSign;
    if (!known && token.kind != ReadToken::Kind::kUnknown) continue;
    const glm::dvec2 at = kMillimetres * (FromEm(token.place, {0, -below}) - from_P);
    print.push_back(
        TextMark{at, height, known ? TextOfSign(token.glyph, script) : "unknown", palette::kInk});
    const double percent = std::floor(100 * token.probability);  // 99 would not be below 99
    if (!known || percent >= 99) continue;
    print.push_back(TextMark{at - glm::dvec2(0, 1.2 * height), 0.8 * height,
                             fmt::format("{} %", percent), palette::kInk});
  }
  std::vector<Mark> marks;
  marks.reserve(2 * print.size());
  for (const TextMark& line : print) marks.emplace_back(PlateOf(line));
  for (TextMark& line : print) marks.emplace_back(std::move(line));
  return marks;
}

Box Drawn(const TextPage& page, const Script& script, const TypeStyle& style, bool blank,
          const ReadingResult& result) {
  Box box = InkBounds(page, script, style);
  for (const PathPoint& point : result.path) {
    if (point.in_contact) Include(box, glm::dvec2(point.tip_P));
  }
  if (!blank) Include(box, RuleBounds(page, script, style));
  return box;
}

void Append(std::vector<Mark>& marks, std::vector<Mark> more) {
  std::move(more.begin(), more.end(), std::back_inserter(marks));
}

}  // namespace

Drawing ReadingPicture(const TextPage& page, const Script& script, const TypeStyle& style,
                       bool blank, const std::string& text, const ReadingResult& result) {
  const double size = kMillimetres * style.size;
  const double border = std::max(4.0, 0.4 * size);
  const double print = std::clamp(0.15 * size, 1.2, 2.4);
  const Box ink = Drawn(page, script, style, blank, result);
  Drawing drawing;
  drawing.width = std::max(80.0, kMillimetres * (ink.max.x - ink.min.x) + 2 * border);
  drawing.title = say::ReadingPictureTitle(script, style);
  std::string read = TextRead(result.tokens, script);
  while (!read.empty() && read.back() == '\n') read.pop_back();
  drawing.description = say::ReadingPictureWords(text, say::Unbroken(read));
  const std::shared_ptr<const GrooveLinks> links = LinksOf(page, script, style);
  std::string legend = say::ReadingPictureLegend(style, IsFollowed(style, script), blank);
  if (!blank) {
    drawing.description += say::SheetWords(style, say::PaperDrawn::kLeftOut);
    legend += say::LinksTraced(links->links.size(), std::nullopt);
  }
  const std::string words = fmt::format("{}. {} {}", drawing.title, drawing.description, legend);
  std::vector<TextMark> lines =
      TextBlock(words, {border, 0}, drawing.width - 2 * border, print, palette::kInk);
  const double words_height = (lines.empty() ? 0 : -lines.back().at.y) + border;
  drawing.height = kMillimetres * (ink.max.y - ink.min.y) + 2 * border + words_height;
  const glm::dvec2 from_P = ink.min - glm::dvec2(border, border + words_height) / kMillimetres;
  if (!blank) {
    Append(drawing.marks, RuleMarks(page, script, style, from_P));
    Append(drawing.marks, LinkMarks(*links, script, style, from_P, palette::kLink));
  }
  Append(drawing.marks, blank ? CentreLineMarks(page, script, style, from_P, palette::kPaperEdge)
                              : MoonMarks(page, script, style, from_P, palette::kGroove));
  // a hand that goes over a line leaves far more of it there
  const double share = IsFollowed(style, script) ? 0.12 : 0.06;
  const double width = std::clamp(share * kMillimetres * style.width, 0.08, 0.5);
  Append(drawing.marks, Tracks(result.path, from_P, width));
  const double below =
      blank ? BelowOf(TextPage(), script, style, print) : BelowOf(page, script, style, print);
  Append(drawing.marks, PrintOf(result, script, from_P, print, below));
  for (TextMark& mark : lines) {
    mark.at.y += words_height;
    drawing.marks.emplace_back(std::move(mark));
  }
  return drawing;
}

}  // namespace moontrace
