#include "sim/view/view_marks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr double kPathPoints = 4;  // least length of a drawn piece of the path [points]
constexpr double kGap = 0.25;  // of the em, at least, from the base line to the middle of the print

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

/// How print letters stand on the picture [points, or a metre of page].
struct PrintSize {
  double points = 1;          // a metre of page
  double small = 0, big = 0;  // heights of letters [points]
};

bool Shown(const ViewPage::Letter& letter, const Box& seen, const PrintSize& size) {
  const double em = letter.box_P.max.y - letter.box_P.min.y;
  return em * size.points >= 1.7 * size.small && Overlap(letter.box_P, seen) &&
         letter.print.find_first_not_of(" \n") != std::string::npos;
}

/// Whether print has room below all letters.
bool HasRoomBelow(const ViewPage& page, double height) {
  return std::all_of(page.letters.begin(), page.letters.end(), [height](const auto& letter) {
    return letter.print.empty() || letter.print_top - letter.print_bottom >= height;
  });
}

/// Under the middle of the strokes `drawn`.
ViewMarks::Print PrintBelow(const ViewPage::Letter& letter, const Box& drawn,
                            const PrintSize& size) {
  const double em = letter.box_P.max.y - letter.box_P.min.y;
  const double room = letter.print_top - letter.print_bottom;
  const bool big = em * size.points > 2.5 * size.big && room * size.points >= size.big;
  const double half = 0.5 * (big ? size.big : size.small) / size.points;
  const double y = std::max(std::min(letter.box_P.min.y - kGap * em, letter.print_top - half),
                            letter.print_bottom + half);
  return {{0.5 * (drawn.min.x + drawn.max.x), y}, OneLine(letter.print), big};
}

/// On the base line behind the strokes of letter `i`, if there is room before the next sign's.
std::optional<ViewMarks::Print> PrintBeside(const ViewPage& page, const std::vector<Box>& drawn,
                                            std::size_t i, const PrintSize& size) {
  constexpr double kWide = 0.65, kApart = 0.25;  // of a print letter, in its heights
  const ViewPage::Letter& letter = page.letters[i];
  ViewMarks::Print print{{0, 0}, OneLine(letter.print), false};
  const double height = size.small / size.points;
  const double width = kWide * height * static_cast<double>(CountCharacters(print.text));
  const double from = drawn[i].max.x + 0.5 * page.width;
  double free = HUGE_VAL;
  for (const std::size_t next : {i - 1, i + 1}) {  // lines may run to the left
    if (next >= drawn.size() || drawn[next].min.x <= drawn[i].max.x) continue;
    const bool same_line = page.letters[next].box_P.min.y == letter.box_P.min.y;
    if (same_line) free = std::min(free, drawn[next].min.x - 0.5 * page.width - from);
  }
  if (free < width) return std::nullopt;
  print.at_P = {from + std::min(0.5 * free, 0.5 * width + kApart * height),
                letter.box_P.min.y + 0.5 * height};
  return print;
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
  const PrintSize size{points, print_height, big_print_height};
  const bool below = HasRoomBelow(page, print_height / points);  // one way for a whole page
  for (std::size_t i = 0; i < page.letters.size(); ++i) {
    const ViewPage::Letter& letter = page.letters[i];
    if (!Shown(letter, seen, size)) continue;
    const bool has_strokes = drawn[i].min.x <= drawn[i].max.x;
    if (below || !has_strokes) {
      marks.print.push_back(PrintBelow(letter, has_strokes ? drawn[i] : letter.box_P, size));
    } else if (std::optional<ViewMarks::Print> beside = PrintBeside(page, drawn, i, size)) {
      marks.print.push_back(std::move(*beside));
    }
  }
  return marks;
}

glm::dvec2 UprightPrint(glm::dvec2 middle, glm::dvec2 top, double half) {
  const glm::dvec2 down = middle - top;
  if (std::abs(down.y) < std::abs(down.x) || std::abs(down.y) >= half) return middle;
  return {middle.x, top.y + std::copysign(half, down.y)};
}

}  // namespace moontrace
