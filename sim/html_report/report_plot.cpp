#include <fmt/core.h>

#include <algorithm>

#include "sim/console/round_axis.h"
#include "sim/console/wording.h"
#include "sim/html_report/html_text.h"
#include "sim/html_report/report_page.h"

namespace moontrace {

namespace {

// [pixels]; the plot's own area lies within
constexpr double kWidth = 640, kHeight = 280;
constexpr double kLeft = 64, kRight = 620, kTop = 16, kBottom = 236;

double Across(std::size_t i, std::size_t count) {
  if (count < 2) return (kLeft + kRight) / 2;
  return kLeft + (kRight - kLeft) * static_cast<double>(i) / static_cast<double>(count - 1);
}

std::string Axes(const ReportPlot& plot, const std::vector<double>& numbers) {
  std::string svg;
  for (const double number : numbers) {
    const double y = kBottom - (kBottom - kTop) * number / numbers.back();
    svg += fmt::format(
        "<line x1=\"{0}\" y1=\"{2:.1f}\" x2=\"{1}\" y2=\"{2:.1f}\" stroke=\"#767676\" "
        "stroke-width=\"{3}\"/>\n<text x=\"{4}\" y=\"{5:.1f}\" text-anchor=\"end\">{6}</text>\n",
        kLeft, kRight, y, number > 0 ? 0.5 : 2, kLeft - 8, y + 5, say::Short(number, 3));
  }
  svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", kLeft, kBottom + 20,
                     HtmlText(plot.labels.front()));
  if (plot.labels.size() > 1) {
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n", kRight,
                       kBottom + 20, HtmlText(plot.labels.back()));
  }
  return svg + fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", kLeft, kBottom + 40,
                           HtmlText(plot.unit));
}

}  // namespace

std::string PlotSvg(const ReportPlot& plot, std::size_t number) {
  const double greatest = *std::max_element(plot.values.begin(), plot.values.end());
  const double least = greatest > 0 ? greatest : 1;
  const std::vector<double> numbers = RoundAxis(greatest, plot.top > 0 ? plot.top : least);
  const double top = numbers.back();
  std::string line, points;
  for (std::size_t i = 0; i < plot.values.size(); ++i) {
    const double x = Across(i, plot.values.size());
    const double y = kBottom - (kBottom - kTop) * plot.values[i] / top;
    line += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", x, y);
    points += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"#003a70\"/>\n", x, y);
  }
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 {0} {1}\" "
             "aria-labelledby=\"plot-{2}-title plot-{2}-words\">\n"
             "<title id=\"plot-{2}-title\">{3}</title>\n<desc id=\"plot-{2}-words\">{4}</desc>\n"
             "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
             "<g font-family=\"sans-serif\" font-size=\"15\" fill=\"#000000\">\n",
             kWidth, kHeight, number, HtmlText(plot.title), HtmlText(say::PlotWords(plot))) +
         Axes(plot, numbers) +
         fmt::format(
             "<polyline points=\"{}\" fill=\"none\" stroke=\"#003a70\" "
             "stroke-width=\"2.5\"/>\n",
             line) +
         points + "</g>\n</svg>\n";
}

}  // namespace moontrace
