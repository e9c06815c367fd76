#include "sim/html_report/report_page.h"

#include <fmt/core.h>

#include <string_view>

#include "sim/html_report/html_text.h"

namespace moontrace {

namespace {

constexpr std::string_view kStyle =
    "body { max-width: 50em; margin: 2em auto; padding: 0 1em; font: 1.1em/1.5 sans-serif; }\n"
    "svg { width: 100%; max-width: 44em; border: 1px solid #767676; }\n"
    "table { border-collapse: collapse; }\n"
    "caption { text-align: left; padding-bottom: 0.4em; }\n"
    "th, td { border: 1px solid #767676; padding: 0.2em 0.6em; text-align: left; }\n"
    "tbody th { white-space: nowrap; }\n"
    "thead th, tbody th { background: #eeeeee; }\n"
    "div.wide { overflow-x: auto; }\n"
    "p.lead { font-size: 1.2em; }\n"
    "@page { size: A4; margin: 15mm; }\n"
    "@media print {\n"
    "body { max-width: none; margin: 0; padding: 0; font-size: 10pt; }\n"
    "svg { max-width: 120mm; }\n"
    "svg, tr, li, p { break-inside: avoid; }\n"
    "h2, caption { break-after: avoid; }\n"
    "thead { display: table-header-group; }\n"
    "div.wide { overflow: visible; }\n"
    ".behind { display: none; }\n"
    "}\n";

std::string Paragraphs(const std::vector<std::string>& lines) {
  std::string html;
  for (const std::string& line : lines) html += fmt::format("<p>{}</p>\n", HtmlText(line));
  return html;
}

/// Several lines are a list, so that a screen reader announces how many there are.
std::string LinesOf(const ReportSection& section) {
  if (section.lines.size() < 2) return Paragraphs(section.lines);
  std::string html = "<ul>\n";
  for (const std::string& line : section.lines) {
    html += fmt::format("<li>{}</li>\n", HtmlText(line));
  }
  return html + "</ul>\n";
}

/// A table that is wider than the window is moved within its own region, by keys too.
std::string TableOf(const ReportTable& table, std::size_t number) {
  if (table.columns.empty()) return {};
  std::string html = fmt::format(
      "<div class=\"wide\" role=\"region\" tabindex=\"0\" aria-labelledby=\"table-{0}\">\n"
      "<table>\n<caption id=\"table-{0}\">{1}</caption>\n<thead>\n<tr>",
      number, HtmlText(table.caption));
  for (const std::string& column : table.columns) {
    html += fmt::format("<th scope=\"col\">{}</th>", HtmlText(column));
  }
  html += "</tr>\n</thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", HtmlText(row[i]))
                     : fmt::format("<td>{}</td>", HtmlText(row[i]));
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string Section(const ReportSection& section, std::size_t number) {
  const std::string table = TableOf(section.table, number);
  if (section.lines.empty() && table.empty()) return {};
  const std::string heading = HtmlText(section.heading);
  std::string html = fmt::format("<section{}>\n<h2>{}</h2>\n",
                                 section.behind ? " class=\"behind\"" : "", heading) +
                     LinesOf(section);
  if (section.plot) html += PlotSvg(*section.plot, number);
  if (section.behind) {
    html += fmt::format("<details>\n<summary>{}</summary>\n{}</details>\n", heading, table);
  } else {
    html += table;
  }
  return html + "</section>\n";
}

}  // namespace

std::string ReportPage(const ReportHead& head, const std::vector<ReportSection>& sections) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\" "
      "xml:lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n"
      "<meta name=\"viewport\" content=\"width=device-width\" />\n<title>{0}</title>\n"
      "<style>\n{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n",
      HtmlText(head.title), kStyle);
  for (const std::string& line : head.lines) {
    html += fmt::format("<p class=\"lead\">{}</p>\n", HtmlText(line));
  }
  for (std::size_t i = 0; i < sections.size(); ++i) html += Section(sections[i], i + 1);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace moontrace
