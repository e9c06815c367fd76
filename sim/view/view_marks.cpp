#include "sim/view/view_marks.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr double kPathPoints = 4;  // least length of a drawn piece of the path [points]
constexpr double kGap = 0.25;      // of the em, from the base line to the middle of the print below

void AddHand(const ViewMoment& moment, ViewMarks& marks) {
  marks.tip_P = moment.tip_P;
  if (moment.in_contact) marks.proxy_P = moment.proxy_P;
  if (moment.stopped) return;
  marks.force_P = moment.force_P;
  marks.guidance_P = moment.guidance_P;
  marks.bead_P = moment.bead_P;
}

/// Without points that lie nearer to the one before than `step` [m]; where it turns from good to
/// bad stays within a step.
std::vector<ViewMarks::PathPoint> Thinned(const std::vector<ViewMarks::PathPoint>& path,
                                          double step) {
  std::vector<ViewMarks::PathPoint> thin;
  thin.reserve(path.size());
  for (const ViewMarks::PathPoint& point : path) {
    const bool near =
        !thin.empty() && !point.begins && glm::distance(thin.back().p_P, point.p_P) < step;
    if (!near) {
      thin.push_back(point);
    } else {
      thin.back().off = std::max(thin.back().off, point.off);
    }
  }
  return thin;
}

/// What the strokes of each letter reach, for letters within `within_P`; otherwise empty.
std::vector<Box> StrokeBoxes(const ViewPage& page, const Box& within_P) {
  std::vector<Box> boxes(page.letters.size());
  for (const IntendedStroke& stroke : page.strokes) {
    if (stroke.glyph >= boxes.size()) continue;
    if (!Overlap(page.letters[stroke.glyph].box_P, within_P)) continue;
    for (const Piece& piece : stroke.spine_P) Include(boxes[stroke.glyph], BoundsOf(piece));
  }
  return boxes;
}

}  // namespace

ViewMarks MarksOf(const ViewPage& page, const ViewHistory& history, const PageCamera& camera,
                  double aspect, bool print, double picture_height, double print_height,
                  double big_print_height) {
  ViewMarks marks;
  const std::optional<ViewMoment>& now = history.newest();
  if (now && now->present && now->page == page.number) AddHand(*now, marks);
  const double points = picture_height / camera.height;  // a metre of page
  marks.path = Thinned(history.Path(), kPathPoints / points);
  if (const std::optional<std::size_t> stroke = history.stroke()) {
    const IntendedStroke& current = page.strokes[*stroke];
    marks.stroke_P.push_back(current.spine_P);
    if (current.glyph < page.letters.size()) {
      const Box& letter = page.letters[current.glyph].box_P;
      marks.letter_P = Grown(StrokeBoxes(page, letter)[current.glyph], 1.5 * page.width);
    }
  }
  if (!print) return marks;
  const Box seen = VisibleBox(camera, aspect);
  const std::vector<Box> drawn = StrokeBoxes(page, seen);
  for (std::size_t i = 0; i < page.letters.size(); ++i) {
    const ViewPage::Letter& letter = page.letters[i];
    const double em = letter.box_P.max.y - letter.box_P.min.y;
    if (em * points < 1.7 * print_height || !Overlap(letter.box_P, seen)) continue;
    std::string text = OneLine(letter.print);
    if (text.find_first_not_of(' ') == std::string::npos) continue;
    const Box& above = drawn[i].min.x <= drawn[i].max.x ? drawn[i] : letter.box_P;
    const glm::dvec2 at(0.5 * (above.min.x + above.max.x), letter.box_P.min.y - kGap * em);
    marks.print.push_back({at, std::move(text), em * points > 2.5 * big_print_height});
  }
  return marks;
}

}  // namespace moontrace
