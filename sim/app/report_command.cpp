#include "sim/app/commands.h"

#include <fmt/core.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "lessons/course/lesson_items.h"
#include "lessons/course/spelling.h"
#include "lessons/records/learner_names.h"
#include "lessons/records/records.h"
#include "lessons/records/report_facts.h"
#include "lessons/records/trial_fields.h"
#include "sim/html_report/records_messages.h"
#include "sim/html_report/report_messages.h"
#include "sim/html_report/report_page.h"
#include "sim/learn/learn_memory.h"
#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_stage.h"
#include "sim/setup/help.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/metrics_json.h"
#include "textures/base/error.h"
#include "textures/base/output_file.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostSaid = 7;  // days in words; a page has them all

/// The smallest letter on the newest of these devices that is felt [m]; 0: nothing is known.
double SmallestOn(const std::vector<std::string>& devices) {
  for (auto device = devices.rbegin(); device != devices.rend(); ++device) {
    if (const double smallest = SmallestByProfile(*device); smallest > 0) return smallest;
  }
  return 0;
}

/// The course asked for, otherwise that of the newest trial; as its learner has it, with the own
/// name among its words.
Course CourseOf(const ReportOptions& options, const LearnerEntry& learner, const Records& records) {
  const std::string name =
      options.course.empty() ? records.LastCourse(learner.pseudonym) : options.course;
  if (name.empty()) throw InputError(say::NoTrialsYet(learner.pseudonym));
  try {
    Course course = LoadCourse(name);
    AddOwnName(course, learner.pseudonym);
    return course;
  } catch (const InputError& error) {
    if (!options.course.empty()) throw;
    throw InputError(say::CourseOfReport(name, error.what()));
  }
}

Json AnswersJson(const AnswerSums& sums) {
  return {{"answers", sums.answers}, {"right", sums.right}};
}

Json SumsJson(const TrialSums& sums) {
  return {{"trials", sums.trials},
          {"answers", sums.answers()},
          {"named_right", sums.right()},
          {"signs", AnswersJson(sums.signs)},
          {"words", AnswersJson(sums.words)},
          {"which_of_two", AnswersJson(sums.picked)},
          {"same_or_different", AnswersJson(sums.compared)},
          {"letters_per_second", sums.LettersPerSecond()},
          {"traces", sums.traces},
          {"good_traces", sums.good},
          {"mean_coverage", sums.MeanCoverage()},
          {"mean_error_widths", sums.MeanErrorWidths()}};
}

Json ItemJson(const ItemFact& fact) {
  return {{"item", fact.item},
          {"size_mm", fact.size > 0 ? Json(1e3 * fact.size) : Json()},
          {"present_size_mm", 1e3 * fact.present},
          {"taught", fact.taught},
          {"mastered", fact.mastered},
          {"last_time_unix_s", fact.last},
          {"last_answers", fact.answers},
          {"last_right", fact.right},
          {"last_traces", fact.traces},
          {"last_good", fact.good},
          {"taken_for", fact.taken_for},
          {"taken_for_times", fact.taken}};
}

Json DaysJson(std::string_view name, const std::vector<DayFact>& days) {
  Json list = Json::array();
  for (const DayFact& day : days) {
    list.push_back(
        {{name, day.day},
         {"unguided", SumsJson(day.alone)},
         {"guided", SumsJson(day.guided)},
         {"smallest_named_right_mm", day.smallest > 0 ? Json(1e3 * day.smallest) : Json()}});
  }
  return list;
}

Json FactsJson(const LearnerEntry& learner, const Course& course, const ReportFacts& facts) {
  Json json{{"learner", learner.pseudonym},
            {"simulated", learner.simulated || facts.simulated > 0},
            {"course", course.id},
            {"lesson", facts.lesson},
            {"step", facts.step},
            {"items", facts.items},
            {"mastered", facts.mastered},
            {"lessons", LessonsInOrder(course)},
            {"lessons_done", facts.lessons_done},
            {"size_reached_mm", facts.size_reached > 0 ? Json(1e3 * facts.size_reached) : Json()},
            {"unguided", SumsJson(facts.alone)},
            {"guided", SumsJson(facts.guided)},
            {"scaled_trials", facts.scaled}};
  json["met"] = Json::array();
  for (const ItemFact& fact : facts.met) json["met"].push_back(ItemJson(fact));
  json["unmet"] = facts.unmet;
  json["practise"] = Json::array();
  for (const ItemFact& fact : facts.practise) json["practise"].push_back(ItemJson(fact));
  json["confusions"] = Json::array();
  for (const ConfusionFact& fact : facts.confusions) {
    json["confusions"].push_back({{"shown", fact.shown},
                                  {"said", fact.said},
                                  {"times", fact.times},
                                  {"times_reversed", fact.back},
                                  {"alike", NameOf(fact.likeness)}});
  }
  json["weeks"] = DaysJson("week", facts.weeks);
  json["days"] = DaysJson("day", facts.days);
  return json;
}

/// What stands above everything else.
std::vector<std::string> Head(const LearnerEntry& learner, const Course& course,
                              const ReportFacts& facts, const std::vector<std::string>& devices) {
  std::vector<std::string> lines = say::ReportSentences(learner.pseudonym, course, facts);
  if (!devices.empty()) lines.push_back(say::WorkedWith(devices));
  if (learner.simulated) {
    lines.push_back(say::NotThePedagogy());
  } else if (facts.simulated > 0) {
    lines.push_back(say::PartlySimulated(facts.simulated));
  }
  return lines;
}

/// Who was named, otherwise the only person in the records. Throws UsageError.
LearnerEntry LearnerOf(const ReportOptions& options, const Records& records) {
  const std::string& named = options.learner.empty() ? options.learner_too : options.learner;
  if (!named.empty()) return KnownLearner(records, named);
  const std::vector<std::string> people = PeopleAmong(records.Learners());
  if (people.size() != 1) throw UsageError(say::NoReportLearner());
  return KnownLearner(records, people.front());
}

}  // namespace

void AddOptions(CLI::App& app, ReportOptions& options) {
  namespace help = say::help;
  AddPath(app, "NAME", "NAME", options.learner, help::kReportLearner);
  AddPath(app, "--learner", "NAME", options.learner_too, help::kReportLearnerToo);
  AddPath(app, "--course", "NAME", options.course, help::kReportCourse);
  AddPath(app, "--html", "FILE", options.html, help::kReportHtml);
  AddPath(app, "--csv", "FILE", options.csv, help::kReportCsv);
  AddPath(app, "--records", "FILE", options.records, help::kRecords);
  AddOptions(app, options.output);
}

int Run(const ReportOptions& options, Console& console) {
  const bool named = !options.learner.empty(), too = !options.learner_too.empty();
  if (named && too) throw UsageError(say::TwoReportLearners());
  const std::string path = RecordsPathOf(options.records);
  const bool none = !named && !too && !std::filesystem::exists(path);
  if (none) throw UsageError(say::NoReportLearner());
  if (!options.html.empty() && !options.csv.empty()) throw UsageError(say::TwoReportFiles());
  const Records records = Records::OpenToRead(path);
  const LearnerEntry learner = LearnerOf(options, records);
  Course course = CourseOf(options, learner, records);
  const std::vector<Trial> trials = records.Trials(learner.pseudonym, course.id);
  if (trials.empty()) throw InputError(say::NoTrialsOf(learner.pseudonym, course.id));
  const std::vector<std::string> devices = DevicesOf(records.Events(learner.pseudonym));
  EndSizesAt(course, SmallestOn(devices));
  const ReportFacts facts = FactsOf(course, trials);
  const std::vector<std::string> head = Head(learner, course, facts, devices);
  const std::string file = options.html.empty() ? options.csv : options.html;
  if (!options.csv.empty()) {
    WriteWhole(options.csv, TrialsToCsv(learner.pseudonym, course.id, trials));
  } else if (!options.html.empty()) {
    WriteWhole(options.html, ReportPage({say::ReportTitle(learner.pseudonym, course), head},
                                        say::ReportSections(course, facts, trials.size())));
  }
  if (options.output.json) {
    Json json = FactsJson(learner, course, facts);
    json["devices"] = devices;
    if (!file.empty()) json["file"] = file;
    console.Json(Dump(json));
    return exit_code::kGood;
  }
  for (const std::string& line : head) console.Result(line);
  if (!file.empty()) {
    console.Result(say::ReportIn());
    console.Path(file);
    return exit_code::kGood;
  }
  for (const ReportSection& section : say::ReportSections(course, facts, kMostSaid)) {
    for (const std::string& line : section.lines)
      console.Result(section.plot ? fmt::format("{}: {}", section.heading, line) : line);
    for (const std::string& line : section.row_lines) console.Result(line);
  }
  return exit_code::kGood;
}

}  // namespace moontrace
