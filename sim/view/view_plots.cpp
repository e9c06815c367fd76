#include "sim/view/view_plots.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "sim/view/view_messages.h"

namespace moontrace {

namespace {

constexpr double kShown = 10;  // [s]

struct Kind {
  const char* title;
  double ViewHistory::Point::*value;
  Color color;
  Color contrast;    // on black
  double least_top;  // of the axis, so that noise does not fill it
};

constexpr std::array<Kind, 4> kKinds = {
    {{say::plot::kForce, &ViewHistory::Point::force, {0.00, 0.45, 0.70}, {0.34, 0.71, 0.91}, 1},
     {say::plot::kError, &ViewHistory::Point::error, {0.84, 0.37, 0.00}, {1.00, 0.60, 0.20}, 0.5},
     {say::plot::kLateness,
      &ViewHistory::Point::lateness_us,
      {0.00, 0.50, 0.36},
      {0.20, 0.90, 0.65},
      100},
     {say::plot::kHeat, &ViewHistory::Point::heat, {0.65, 0.30, 0.50}, {0.95, 0.65, 0.82}, 100}}};

void Set(float (&to)[3], const Color& color) {
  to[0] = static_cast<float>(color.red);
  to[1] = static_cast<float>(color.green);
  to[2] = static_cast<float>(color.blue);
}

void Set(float (&to)[4], const Color& color) {
  to[0] = static_cast<float>(color.red);
  to[1] = static_cast<float>(color.green);
  to[2] = static_cast<float>(color.blue);
  to[3] = 1;
}

Color Between(const Color& a, const Color& b, double share) {
  return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
          a.blue + share * (b.blue - a.blue)};
}

/// 1, 2 or 5 times a power of ten, not below `value`: an axis that is easy to read.
double RoundTop(double value, double least) {
  double top = least;
  for (int i = 0; top < value && i < 60; ++i) top *= i % 3 == 1 ? 2.5 : 2;
  return top;
}

/// Line and axes.
void SetLine(mjvFigure& figure, const Kind& kind, const ViewHistory& history, double now) {
  float* next = figure.linedata[0];
  int count = 0;
  double most = 0;
  for (const ViewHistory::Point& point : history.points()) {
    const double value = point.*kind.value;
    if (count >= mjMAXLINEPNT || value < 0) continue;
    *next++ = static_cast<float>(point.time - now);
    *next++ = static_cast<float>(value);
    most = std::max(most, value);
    ++count;
  }
  figure.linepnt[0] = count;
  figure.range[0][0] = static_cast<float>(-kShown);
  figure.range[0][1] = 0;
  figure.range[1][0] = 0;
  figure.range[1][1] = static_cast<float>(RoundTop(most, kind.least_top));
}

}  // namespace

struct ViewPlots::State {
  std::array<mjvFigure, kKinds.size()> figures;  // some 0.8 MB each
};

ViewPlots::ViewPlots() : state_(std::make_unique<State>()) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    mjvFigure& figure = state_->figures.at(i);
    mjv_defaultFigure(&figure);
    std::strncpy(figure.title, kKinds.at(i).title, sizeof figure.title - 1);
    std::strncpy(figure.xformat, "%.0f", sizeof figure.xformat - 1);
    std::strncpy(figure.yformat, "%.4g", sizeof figure.yformat - 1);
    std::strncpy(figure.minwidth, "0000", sizeof figure.minwidth - 1);
    figure.flg_extend = 0;
    figure.flg_legend = 0;
    figure.flg_ticklabel[0] = figure.flg_ticklabel[1] = 1;
    figure.gridsize[0] = 3;
    figure.gridsize[1] = 3;
    figure.linewidth = 2;
    figure.gridwidth = 1;
  }
  mjvFigure& last = state_->figures.back();
  std::strncpy(last.xlabel, say::plot::kTime, sizeof last.xlabel - 1);
}

ViewPlots::~ViewPlots() = default;

void ViewPlots::Draw(const ViewHistory& history, const ViewColors& colors, const PixelBox& box,
                     const mjrContext_& context) {
  const bool dark = colors.back.red < 0.5;
  const double now = history.points().empty() ? 0 : history.points().back().time;
  int top = box.y + box.height;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const Kind& kind = kKinds.at(i);
    mjvFigure& figure = state_->figures.at(i);
    Set(figure.figurergba, colors.back);
    Set(figure.panergba, colors.pane);
    Set(figure.textrgb, colors.text);
    Set(figure.gridrgb, Between(colors.pane, colors.text, 0.25));
    Set(figure.linergb[0], dark ? kind.contrast : kind.color);
    SetLine(figure, kind, history, now);
    // the last has a line more, for the axis of time
    const int left = static_cast<int>(kKinds.size() - i);
    const int height = (top - box.y) / left;
    // room for two or three numbers beside the axis, with title and time above and below
    figure.gridsize[1] = height > 9 * context.charHeight ? 3 : 2;
    mjr_figure({box.x, top - height, box.width, height}, &figure, &context);
    top -= height;
  }
}

}  // namespace moontrace
