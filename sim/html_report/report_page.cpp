#include "sim/html_report/report_page.h"

#include <fmt/core.h>

#include <set>

#include "sim/html_report/html_text.h"

namespace moontrace {

namespace {

constexpr std::string_view kStyle =
    "body { max-width: 50em; margin: 2em auto; padding: 0 1em; font: 1.1em/1.5 sans-serif; }\n"
    "svg { width: 100%; border: 1px solid #767676; }\n"
    "table { border-collapse: collapse; }\n"
    "th, td { border: 1px solid #767676; padding: 0.2em 0.6em; text-align: left; }\n"
    "div.wide { overflow-x: auto; }\n";

std::string Paragraphs(const std::vector<std::string>& lines) {
  std::string html;
  for (const std::string& line : lines) html += fmt::format("<p>{}</p>\n", HtmlText(line));
  return html;
}

/// Several lines are a list, so that a screen reader announces how many there are.
std::string Section(const ReportSection& section) {
  std::string html = fmt::format("<section>\n<h2>{}</h2>\n", HtmlText(section.heading));
  if (section.lines.size() == 1) {
    html += Paragraphs(section.lines);
  } else {
    html += "<ul>\n";
    for (const std::string& line : section.lines) {
      html += fmt::format("<li>{}</li>\n", HtmlText(line));
    }
    html += "</ul>\n";
  }
  return html + "</section>\n";
}

std::string Plot(const ReportPlot& plot, std::size_t number) {
  return fmt::format("<section>\n<h2>{}</h2>\n<p>{}</p>\n{}</section>\n", HtmlText(plot.title),
                     HtmlText(say::PlotWords(plot)), PlotSvg(plot, number));
}

std::string Matrix(const std::map<std::string, std::map<std::string, int>>& matrix) {
  std::set<std::string> said;
  std::size_t answers = 0;
  for (const auto& row : matrix) {
    for (const auto& cell : row.second) {
      said.insert(cell.first);
      answers += static_cast<std::size_t>(cell.second);
    }
  }
  if (answers == 0) return {};
  std::string html = fmt::format(
      "<section>\n<h2>{}</h2>\n<div class=\"wide\" role=\"region\" tabindex=\"0\" "
      "aria-labelledby=\"matrix\">\n<table>\n<caption id=\"matrix\">{}</caption>\n"
      "<thead>\n<tr><th scope=\"col\">Shown</th>",
      HtmlText(say::MatrixHeading()), HtmlText(say::MatrixWords(answers)));
  for (const std::string& answer : said) {
    html += fmt::format("<th scope=\"col\">{}</th>", HtmlText(answer));
  }
  html += "</tr>\n</thead>\n<tbody>\n";
  for (const auto& row : matrix) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", HtmlText(row.first));
    for (const std::string& answer : said) {
      const auto cell = row.second.find(answer);
      html += fmt::format("<td>{}</td>", cell == row.second.end() ? 0 : cell->second);
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n</div>\n</section>\n";
}

}  // namespace

std::string ReportPage(const ReportHead& head, const std::vector<ReportSection>& sections,
                       const std::vector<ReportPlot>& plots,
                       const std::map<std::string, std::map<std::string, int>>& matrix) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\" "
      "xml:lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n"
      "<meta name=\"viewport\" content=\"width=device-width\" />\n<title>{0}</title>\n"
      "<style>\n{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n",
      HtmlText(head.title), kStyle);
  html += Paragraphs(head.lines);
  for (const ReportSection& section : sections) html += Section(section);
  for (std::size_t i = 0; i < plots.size(); ++i) html += Plot(plots[i], i + 1);
  return html + Matrix(matrix) + "</main>\n</body>\n</html>\n";
}

}  // namespace moontrace
