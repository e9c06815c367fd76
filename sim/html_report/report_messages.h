#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/records/report_facts.h"

namespace moontrace {

/// A report in words, in order. The text face gives the lines, the page the headings too.
struct ReportSection {
  std::string heading;
  std::vector<std::string> lines;
};

/// One plot of a report's page: a value for each day.
struct ReportPlot {
  std::string title;
  std::string unit;                 ///< of the axis
  std::vector<std::string> labels;  ///< days
  std::vector<double> values;
  double top = 0;  ///< of the axis; 0: the greatest value's
};

/// The sentences of `moontrace report` and of its page.
namespace say {

std::string NoReportLearner();
std::string TwoReportFiles();
std::string NoTrialsYet(std::string_view learner);
std::string NoTrialsOf(std::string_view learner, std::string_view course);
std::string CourseOfReport(std::string_view course, std::string_view why);
std::string ReportOutcome(std::string_view learner, const Course& course, const ReportFacts& facts);
std::string NotThePedagogy();
std::string PartlySimulated(std::size_t trials);
std::string ReportIn();
std::string ReportTitle(std::string_view learner, const Course& course);

/// What is sure, what to practise, letters per second, size, confusions, days, help, conditions.
/// `most`: lines of confusions and days at most, the rest is counted.
std::vector<ReportSection> ReportSections(const Course& course, const ReportFacts& facts,
                                          std::size_t most);
/// Days as plots; one for each thing that was done on at least one day.
std::vector<ReportPlot> ReportPlots(const ReportFacts& facts);
/// The plot in a sentence: first, last, least, greatest.
std::string PlotWords(const ReportPlot& plot);
std::string MatrixHeading();
std::string MatrixWords(std::size_t answers);

namespace help {
inline constexpr const char* kReport =
    "says what a learner is sure of, what to practise, how quickly and at what size";
inline constexpr const char* kReportLearner = "the learner, as moontrace records list names them.";
inline constexpr const char* kReportCourse =
    "name of a course or path of its folder. Default the one last learnt.";
inline constexpr const char* kReportHtml = "write a page with headings and plots to this file.";
inline constexpr const char* kReportCsv = "write a table with a row for each trial to this file.";
}  // namespace help

}  // namespace say

}  // namespace moontrace
