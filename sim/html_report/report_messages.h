#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/records/report_facts.h"

namespace moontrace {

/// A table of a page; the first cell of a row is its head.
struct ReportTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// One plot of a report's page: a value for each day or week.
struct ReportPlot {
  std::string title;
  std::string unit;                 ///< of the axis
  std::vector<std::string> labels;  ///< days, or weeks by their Monday
  std::vector<double> values;
  double top = 0;  ///< of the axis; 0: the greatest value's
};

/// One subject of a report, told alike in lines and on a page.
struct ReportSection {
  std::string heading;
  std::vector<std::string> lines;      ///< on both
  std::vector<std::string> row_lines;  ///< in place of the table, where there are lines only
  ReportTable table;                   ///< none without columns
  std::optional<ReportPlot> plot;      ///< its words are among the lines
  bool behind = false;                 ///< opened by who wants it; no lines
};

/// The sentences of `moontrace report` and of its page.
namespace say {

std::string NoReportLearner();
std::string TwoReportLearners();
std::string TwoReportFiles();
std::string NoTrialsYet(std::string_view learner);
std::string NoTrialsOf(std::string_view learner, std::string_view course);
std::string CourseOfReport(std::string_view course, std::string_view why);
/// Three sentences above all else: where the learner is, what to do next, what is hard.
std::vector<std::string> ReportSentences(std::string_view learner, const Course& course,
                                         const ReportFacts& facts);
std::string NotThePedagogy();
/// Of devices, that of the newest session last; at least one.
std::string WorkedWith(const std::vector<std::string>& devices);
std::string PartlySimulated(std::size_t trials);
std::string ReportIn();
std::string ReportTitle(std::string_view learner, const Course& course);

/// Signs, plots, answers, confusions, speed and size, weeks, days, help, conditions. `most`: days
/// as lines at most, the rest is counted; a table has all.
std::vector<ReportSection> ReportSections(const Course& course, const ReportFacts& facts,
                                          std::size_t most);
/// Weeks as plots, or days where these are of two weeks at most; one for each thing that was done.
std::vector<ReportPlot> ReportPlots(const ReportFacts& facts);
/// The plot in a sentence: first, last, least, greatest.
std::string PlotWords(const ReportPlot& plot);

namespace help {
inline constexpr const char* kReport =
    "says what a learner is sure of, what to practise, how quickly and at what size";
inline constexpr const char* kReportLearnerToo = "the same, as moontrace learn takes it.";
inline constexpr const char* kReportLearner =
    "the learner, as moontrace records list names them; without, the only one.";
inline constexpr const char* kReportCourse =
    "name of a course or path of its folder. Default the one last learnt.";
inline constexpr const char* kReportHtml = "write a page with headings and plots to this file.";
inline constexpr const char* kReportCsv = "write a table with a row for each trial to this file.";
}  // namespace help

}  // namespace say

}  // namespace moontrace
