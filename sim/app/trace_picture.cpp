#include "sim/app/trace_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/app/messages.h"
#include "sim/picture/link_marks.h"
#include "sim/picture/link_messages.h"
#include "sim/picture/moon_marks.h"
#include "sim/picture/sheet_marks.h"
#include "sim/picture/sheet_messages.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

void Append(std::vector<Mark>& marks, std::vector<Mark> more) {
  for (Mark& mark : more) marks.push_back(std::move(mark));
}

/// The tip's path while it touches: one track from landing to lift.
std::vector<Mark> TipTracks(const std::vector<PathPoint>& path, glm::dvec2 from_P, double width) {
  std::vector<Mark> marks;
  TrackMark track;
  const auto end_track = [&] {
    if (track.points.size() > 1) marks.emplace_back(track);
    track.points.clear();
  };
  track.stroke = palette::kTip;
  track.width = width;
  for (const PathPoint& point : path) {
    if (point.phase == TracePhase::kAir || !point.in_contact) {
      end_track();
      continue;
    }
    track.points.push_back(kMillimetres * (glm::dvec2(point.tip_P) - from_P));
  }
  end_track();
  return marks;
}

/// What is drawn is within: strokes, rules, margin, the tip's path.
Box Drawn(const TextPage& page, const Script& script, const TypeStyle& style, bool blank,
          const TrialResult& result) {
  Box box = InkBounds(page, script, style);
  for (const PathPoint& point : result.path) {
    if (point.in_contact) Include(box, glm::dvec2(point.tip_P));
  }
  if (!blank) Include(box, RuleBounds(page, script, style));
  return box;
}

void AddRings(const std::vector<Excursion>& left_at, glm::dvec2 from_P, double radius, double width,
              Drawing& drawing) {
  for (const Excursion& left : left_at) {
    CircleMark ring;
    ring.center = kMillimetres * (left.p_P - from_P);
    ring.radius = radius;
    ring.stroke = palette::kAway;
    ring.width = width;
    drawing.marks.emplace_back(ring);
  }
}

std::string Legend(const GrooveLinks& links, const TypeStyle& style, bool blank,
                   const TrialResult& result) {
  std::optional<std::size_t> left;
  if (result.links_left) left = result.links_left->size();
  const bool rings = result.score.total.excursions > 0 || left.value_or(0) > 0;
  if (blank) return say::TracePictureLegend(style, blank, rings);  // nothing else lies there
  return say::TracePictureLegend(style, blank, rings) + say::LinksTraced(links.links.size(), left);
}

}  // namespace

Drawing TracePicture(const TextPage& page, const Script& script, const TypeStyle& style, bool blank,
                     const std::string& text, const TrialResult& result) {
  const TraceMetrics& total = result.score.total;
  const double size = kMillimetres * style.size;
  const double border = std::max(4.0, 0.4 * size);
  const double print = std::clamp(0.1 * size, 1.5, 2.4);

  const Box ink = Drawn(page, script, style, blank, result);
  const std::shared_ptr<const GrooveLinks> links = LinksOf(page, script, style);
  Drawing drawing;
  drawing.width = std::max(80.0, kMillimetres * (ink.max.x - ink.min.x) + 2 * border);
  drawing.title = say::TracePictureTitle(script.title, style, blank);
  drawing.description = say::TracePictureWords(text, total);
  if (!blank) drawing.description += say::SheetWords(style, say::PaperDrawn::kLeftOut);

  const glm::dvec2 below{border, 0};
  const double room = drawing.width - 2 * border;
  std::vector<TextMark> words = TextBlock(fmt::format("{}. {}", drawing.title, drawing.description),
                                          below, room, print, palette::kInk);
  const double first = words.empty() ? 0 : -words.back().at.y + print;
  for (TextMark& line : TextBlock(Legend(*links, style, blank, result),
                                  below - glm::dvec2(0, first), room, print, palette::kInk)) {
    words.push_back(std::move(line));
  }
  const double words_height = (words.empty() ? 0 : -words.back().at.y) + border;
  drawing.height = kMillimetres * (ink.max.y - ink.min.y) + 2 * border + words_height;

  const glm::dvec2 from_P = ink.min - glm::dvec2(border, border + words_height) / kMillimetres;
  if (!blank) {
    Append(drawing.marks, RuleMarks(page, script, style, from_P));
    Append(drawing.marks, LinkMarks(*links, script, style, from_P, palette::kLink));
  }
  Append(drawing.marks, blank ? CentreLineMarks(page, script, style, from_P, palette::kPaperEdge)
                              : MoonMarks(page, script, style, from_P, palette::kGroove));
  const double line = std::clamp(0.15 * kMillimetres * style.width, 0.1, 0.6);
  Append(drawing.marks, TipTracks(result.path, from_P, line));
  const double radius = 0.6 * kMillimetres * style.width;
  AddRings(result.score.left_at, from_P, radius, 1.5 * line, drawing);
  if (result.links_left) AddRings(*result.links_left, from_P, radius, 1.5 * line, drawing);
  for (TextMark& mark : words) {
    mark.at.y += words_height;
    drawing.marks.emplace_back(std::move(mark));
  }
  return drawing;
}

}  // namespace moontrace
