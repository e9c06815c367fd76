#pragma once

#include <string>
#include <vector>

#include "sim/html_report/report_messages.h"

namespace moontrace {

/// What a page says at its top: title, outcome, remarks.
struct ReportHead {
  std::string title;
  std::vector<std::string> lines;
};

/// A report as one page, HTML that is well-formed XML too: headings in order, plots as SVG with
/// title, description and the same in a sentence beside them, tables with captions. Nothing is
/// shown by a picture alone, nothing is loaded from elsewhere, and it can be printed.
std::string ReportPage(const ReportHead& head, const std::vector<ReportSection>& sections);

/// The plot as an SVG element; `number` makes its ids.
std::string PlotSvg(const ReportPlot& plot, std::size_t number);

}  // namespace moontrace
