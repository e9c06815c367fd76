#include "sim/view/trace_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/app/messages.h"
#include "sim/view/link_marks.h"
#include "sim/view/moon_marks.h"

namespace moontrace {

namespace {

constexpr double kMillimetres = 1e3;

void Append(std::vector<Mark>& marks, std::vector<Mark> more) {
  for (Mark& mark : more) marks.push_back(std::move(mark));
}

/// The tip's way while it touches: one track from landing to lift.
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

}  // namespace

Drawing TracePicture(const TextPage& page, const Script& script, const TypeStyle& style, bool blank,
                     const std::string& text, const TrialResult& result) {
  const TraceMetrics& total = result.score.total;
  const double size = kMillimetres * style.size;
  const double border = std::max(4.0, 0.4 * size);
  const double print = std::clamp(0.1 * size, 1.5, 2.4);

  Box ink = InkBounds(page, script, style);
  for (const PathPoint& point : result.path) {
    if (point.in_contact) Include(ink, glm::dvec2(point.tip_P));
  }
  Drawing drawing;
  drawing.width = std::max(80.0, kMillimetres * (ink.max.x - ink.min.x) + 2 * border);
  drawing.title = say::TracePictureTitle(script.title, style, blank);
  drawing.description = say::TracePictureWords(text, total);

  const glm::dvec2 below{border, 0};
  const double room = drawing.width - 2 * border;
  std::vector<TextMark> words = TextBlock(fmt::format("{}. {}", drawing.title, drawing.description),
                                          below, room, print, palette::kInk);
  const double first = words.empty() ? 0 : -words.back().at.y + print;
  for (TextMark& line : TextBlock(say::TracePictureLegend(total, style, blank),
                                  below - glm::dvec2(0, first), room, print, palette::kInk)) {
    words.push_back(std::move(line));
  }
  const double words_height = (words.empty() ? 0 : -words.back().at.y) + border;
  drawing.height = kMillimetres * (ink.max.y - ink.min.y) + 2 * border + words_height;

  const glm::dvec2 from_P = ink.min - glm::dvec2(border, border + words_height) / kMillimetres;
  if (!blank) {
    const GrooveLinks links = LinkPage(page, script, style);
    Append(drawing.marks, LinkMarks(links, script, style, from_P, palette::kLink));
  }
  Append(drawing.marks, blank ? CentreLineMarks(page, script, style, from_P, palette::kPaperEdge)
                              : MoonMarks(page, script, style, from_P, palette::kGroove));
  const double line = std::clamp(0.15 * kMillimetres * style.width, 0.1, 0.6);
  Append(drawing.marks, TipTracks(result.path, from_P, line));
  for (const Excursion& left : result.score.left_at) {
    CircleMark ring;
    ring.center = kMillimetres * (left.p_P - from_P);
    ring.radius = 0.6 * kMillimetres * style.width;
    ring.stroke = palette::kAway;
    ring.width = 1.5 * line;
    drawing.marks.emplace_back(ring);
  }
  for (TextMark& mark : words) {
    mark.at.y += words_height;
    drawing.marks.emplace_back(std::move(mark));
  }
  return drawing;
}

}  // namespace moontrace
