#include "sim/view/view_plots.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/console/round_axis.h"
#include "sim/view/view_messages.h"

namespace moontrace {

namespace {

constexpr double kShown = 10;            // [s]
constexpr double kTimes[] = {10, 5, 0};  // numbers on the axis of time, before now [s]

struct Kind {
  const char* title;
  double ViewHistory::Point::*value;
  double least_top;  // of the axis, so that noise does not fill it
};

constexpr std::array<Kind, 4> kKinds = {
    {{say::plot::kForce, &ViewHistory::Point::force, 1},
     {say::plot::kError, &ViewHistory::Point::error, 0.4},
     {say::plot::kLateness, &ViewHistory::Point::lateness_us, 100},
     {say::plot::kHeat, &ViewHistory::Point::heat, 100}}};

/// One figure: its pane, and how the picture's points follow from time and value.
struct Figure {
  PixelBox pane;
  double now = 0, top = 1;

  glm::dvec2 At(double time, double value) const {
    return {pane.x + (1 + (time - now) / kShown) * pane.width,
            pane.y + std::clamp(value / top, 0.0, 1.0) * pane.height};
  }
};

void DrawAxes(const Figure& figure, const std::vector<double>& numbers, const ViewColors& colors,
              Canvas& canvas) {
  const PixelBox& pane = figure.pane;
  const Color grid = Mixed(colors.pane, colors.text, 0.18);
  const int half = canvas.TextHeight(false) / 2;
  canvas.Fill(pane, colors.pane);
  for (const double number : numbers) {
    const int y = static_cast<int>(std::lround(figure.At(figure.now, number).y));
    canvas.Fill({pane.x, y, pane.width, 1}, grid);
    const std::string text = fmt::format("{:.6g}", number);
    const int x = pane.x - canvas.TextWidth(text, false) - half / 2;
    canvas.Text(text, x, y - half, false, colors.text);
  }
  for (const double before : kTimes) {
    const int x = static_cast<int>(std::lround(figure.At(figure.now - before, 0).x));
    canvas.Fill({x, pane.y, 1, pane.height}, grid);
    const std::string text = before > 0 ? fmt::format("-{:.6g}", before) : "0";
    const int left = x - canvas.TextWidth(text, false) / 2;
    canvas.Text(text, left, pane.y - 2 * half - half / 2, false, colors.text);
  }
  canvas.Frame(pane, 1, colors.edge);
}

void DrawCurve(const Figure& figure, const ViewHistory& history, double ViewHistory::Point::*value,
               const Color& color, Canvas& canvas) {
  constexpr double kGap = 0.1;  // without a point the curve is broken [s]
  std::vector<glm::dvec2> curve;
  double last = figure.now;
  const auto finish = [&] {
    if (curve.size() > 1) canvas.Line(curve, 1.8, color);
    curve.clear();
  };
  for (const ViewHistory::Point& point : history.points()) {
    if (point.*value < 0 || point.time < figure.now - kShown) continue;
    if (point.time - last > kGap) finish();
    curve.push_back(figure.At(point.time, point.*value));
    last = point.time;
  }
  finish();
}

}  // namespace

void DrawPlots(const ViewHistory& history, const ViewLook& look, const PixelBox& box,
               Canvas& canvas) {
  const ViewColors colors = ColorsOf(look);
  const std::array<Color, kKinds.size()> curves = CurveColors(look);
  canvas.Fill(box, colors.back);
  const int row = canvas.TextHeight(false), gap = row / 2;
  const int time_row = row + gap;  // the axis of time has its name once, below
  const int each = (box.height - time_row - gap) / static_cast<int>(kKinds.size());
  const double now = history.points().empty() ? 0 : history.points().back().time;
  const int left = canvas.TextWidth("0000", false) + gap;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const Kind& kind = kKinds.at(i);
    const int top = box.y + box.height - static_cast<int>(i) * each - gap;
    const int bottom = top - each + row + 2 * gap;
    Figure figure{{box.x + left, bottom, box.width - left - 2 * gap, top - bottom - row - gap},
                  now};
    if (figure.pane.empty()) continue;
    double most = 0;
    for (const ViewHistory::Point& point : history.points()) {
      most = std::max(most, point.*kind.value);
    }
    const std::vector<double> numbers = RoundAxis(most, kind.least_top);
    figure.top = numbers.back();
    canvas.Text(kind.title, figure.pane.x, top - row, false, colors.text);
    DrawAxes(figure, numbers, colors, canvas);
    DrawCurve(figure, history, kind.value, curves.at(i), canvas);
  }
  const int width = canvas.TextWidth(say::plot::kTime, false);
  canvas.Text(say::plot::kTime, box.x + box.width - width - gap, box.y + gap, false, colors.text);
}

}  // namespace moontrace
