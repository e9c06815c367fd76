#include <gtest/gtest.h>

#include "sim/html_report/report_messages.h"
#include "sim/html_report/report_page.h"

namespace moontrace {
namespace {

/// What stands beside the upright axis, from below.
std::vector<std::string> NumbersOf(const ReportPlot& plot) {
  const std::string svg = PlotSvg(plot, 1);
  const std::string before = "text-anchor=\"end\">";
  std::vector<std::string> numbers;
  for (std::size_t at = svg.find(before); at != std::string::npos; at = svg.find(before, at + 1)) {
    const std::size_t from = at + before.size();
    numbers.push_back(svg.substr(from, svg.find('<', from) - from));
  }
  numbers.pop_back();  // the last day
  return numbers;
}

// Before, the axis of the first ended at 10 in steps of 2.5.
TEST(ReportPlot, HasRoundNumbersBesideItsAxis) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(NumbersOf({"Time", "minutes", {"1 May", "2 May"}, {3, 7.3}}),
            Texts({"0", "2", "4", "6", "8"}));
  EXPECT_EQ(NumbersOf({"Sure", "percent", {"1 May", "2 May"}, {10, 60}, 100}),
            Texts({"0", "50", "100"}));
  EXPECT_EQ(NumbersOf({"Errors", "mm", {"1 May", "2 May"}, {0, 0}}), Texts({"0", "0.5", "1"}));
}

// The other lines round down too: 15 of 16 right are 93.7 percent, and 99.96 percent is not 100.
TEST(ReportPlot, TellsPercentAsTheOtherLinesDo) {
  EXPECT_EQ(
      say::PlotWords({"Signs", "percent", {"1 May", "2 May"}, {93.75, 99.96}, 100}),
      "From 93.7 percent on 1 May to 99.9 percent on 2 May; least 93.7 percent, greatest 99.9 "
      "percent.");
}

}  // namespace
}  // namespace moontrace
