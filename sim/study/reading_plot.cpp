#include "sim/study/reading_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "sim/picture/moon_marks.h"
#include "sim/study/study_messages.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostRows = 100;
// All in mm.
constexpr double kBorder = 6, kRow = 6, kLetters = 2.2, kSmall = 1.8, kPanel = 80, kGap = 10;
constexpr double kPerLetter = 0.85 * kLetters;  ///< width of print, about

/// A scale from left to right.
struct Axis {
  double left = 0;          ///< of the panel [mm]
  double from = 0, to = 1;  ///< values at its ends
  double step = 1;          ///< between lines
  double At(double value) const {
    return left + kPanel * std::clamp((value - from) / (to - from), 0.0, 1.0);
  }
};

/// 1, 2 or 5 times a power of ten: some four to eight of them fill the range.
double EvenStep(double range) {
  const double rough = range / 6;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

/// Of a small number, about: a digit is 0.88 of a capital's height wide in common sans-serif fonts,
/// a point half of that [mm].
double WidthOf(const std::string& number) {
  const auto points = static_cast<double>(std::count(number.begin(), number.end(), '.'));
  return 0.88 * kSmall * (static_cast<double>(number.size()) - 0.5 * points);
}

void DrawScale(std::vector<Mark>& marks, const Axis& axis, double bottom, double top,
               const std::string& name) {
  for (double value = axis.from; value < axis.to + 1e-9; value += axis.step) {
    const double x = axis.At(value);
    marks.emplace_back(TrackMark{{{x, bottom}, {x, top}}, palette::kPaperEdge, 0.15});
    const std::string number = fmt::format("{:g}", value);
    const double left = x - 0.5 * WidthOf(number);
    marks.emplace_back(TextMark{{left, bottom - 2 * kSmall}, kSmall, number, palette::kInk});
  }
  marks.emplace_back(TextMark{{axis.left, top + kSmall}, kSmall, name, palette::kInk});
}

/// `pages`: one has no spread.
void DrawEstimate(std::vector<Mark>& marks, const Axis& axis, const Estimate& estimate,
                  double scale, double y, std::size_t pages) {
  if (pages > 1) {
    const double low = axis.At(scale * estimate.low), high = axis.At(scale * estimate.high);
    marks.emplace_back(TrackMark{{{low, y}, {high, y}}, palette::kTip, 0.8});
  }
  CircleMark dot;
  dot.center = {axis.At(scale * estimate.value), y};
  dot.radius = 1;
  dot.fill = palette::kInk;
  marks.emplace_back(dot);
}

}  // namespace

Drawing ReadingPlot(const std::string& title, const ReadingSummary& summary) {
  const std::size_t rows = std::min(summary.cells.size(), kMostRows);
  std::size_t longest = 0;
  double least = 1, slowest = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const ReadingStudyCell& cell = summary.cells[i];
    longest = std::max(longest, cell.condition.size());
    least = std::min(least, cell.right.low);
    slowest = std::max(slowest, cell.seconds.high);
  }
  Drawing drawing;
  Axis right, seconds;
  right.left = kBorder + kPerLetter * static_cast<double>(longest) + kLetters;
  seconds.left = right.left + kPanel + kGap;
  right.step = EvenStep(std::max(1.0, 100 * (1 - least)));
  right.to = 100;
  right.from = right.to - right.step * std::ceil(std::max(1.0, 100 * (1 - least)) / right.step);
  seconds.step = EvenStep(std::max(1.0, slowest));
  seconds.to = seconds.step * std::ceil(std::max(1.0, slowest) / seconds.step);
  drawing.width = seconds.left + kPanel + 2 * kBorder;
  drawing.title = title;
  drawing.description = say::ReadingPlotWords(summary, rows);
  std::vector<TextMark> words =
      TextBlock(fmt::format("{}. {}", drawing.title, drawing.description), {kBorder, 0},
                drawing.width - 2 * kBorder, kLetters, palette::kInk);
  const double words_height = (words.empty() ? 0 : -words.back().at.y) + kBorder;
  const double bottom = words_height + kBorder;
  const double top = bottom + kRow * static_cast<double>(rows);
  drawing.height = top + 2 * kBorder;
  DrawScale(drawing.marks, right, bottom, top, say::ReadingPlotRight());
  DrawScale(drawing.marks, seconds, bottom, top, say::ReadingPlotSeconds());
  for (std::size_t i = 0; i < rows; ++i) {
    const ReadingStudyCell& cell = summary.cells[i];
    const double y = top - kRow * (static_cast<double>(i) + 0.5);
    drawing.marks.emplace_back(
        TextMark{{kBorder, y - 0.5 * kLetters}, kLetters, cell.condition, palette::kInk});
    DrawEstimate(drawing.marks, right, cell.right, 100, y, cell.pages);
    DrawEstimate(drawing.marks, seconds, cell.seconds, 1, y, cell.pages);
  }
  for (TextMark& line : words) {
    line.at.y += words_height;
    drawing.marks.emplace_back(std::move(line));
  }
  return drawing;
}

}  // namespace moontrace
