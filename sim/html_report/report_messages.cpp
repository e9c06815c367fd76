#include "sim/html_report/report_messages.h"

#include <fmt/core.h>

#include <algorithm>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/mastery.h"
#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

std::string Mm(double size) { return Short(kMillimetres * size, 2) + " mm"; }

std::string Name(const Course& course, std::string_view item) {
  const ItemPair pair = PairOf(item);
  const std::string first = OneLine(NameOf(course, pair.first));
  return pair.second.empty()
             ? first
             : fmt::format("{} beside {}", first, OneLine(NameOf(course, pair.second)));
}

ReportSection Sure(const Course& course, const ReportFacts& facts) {
  ReportSection section{"What is sure", {}};
  for (std::size_t i = 0; i < facts.sure.size();) {
    const double size = facts.sure[i].size;
    std::string names;
    for (; i < facts.sure.size() && SameSize(facts.sure[i].size, size); ++i) {
      names += (names.empty() ? "" : ", ") + Name(course, facts.sure[i].item);
    }
    const bool standard = SameSize(size, SizeAt(course, LastSize(course)));
    section.lines.push_back(
        fmt::format("Sure at {}{}: {}.", Mm(size), standard ? ", standard size" : "", names));
  }
  if (facts.sure.empty()) section.lines.emplace_back("Sure: nothing yet.");
  return section;
}

std::string PractiseLine(const Course& course, const ItemFact& fact) {
  std::string line = fmt::format("Practise {}: ", Name(course, fact.item));
  std::string separator;
  if (fact.answers > fact.right) {
    line += fmt::format("named right {} of the last {}", fact.right, fact.answers);
    separator = ", ";
  }
  if (fact.traces > fact.good) {
    line += fmt::format("{}traced well {} of the last {}", separator, fact.good, fact.traces);
    separator = ", ";
  }
  if (fact.taken > 0) {
    line += fmt::format("{}taken for {} {}", separator, Name(course, fact.taken_for),
                        Times(static_cast<std::size_t>(fact.taken)));
  }
  return line + fmt::format("; now at {}.", Mm(fact.size));
}

ReportSection Practise(const Course& course, const ReportFacts& facts) {
  ReportSection section{"What to practise", {}};
  for (const ItemFact& fact : facts.practise) {
    section.lines.push_back(PractiseLine(course, fact));
  }
  if (facts.practise.empty()) {
    section.lines.emplace_back("Practise: nothing more than the rest.");
  }
  return section;
}

ReportSection Speed(const ReportFacts& facts) {
  ReportSection section{"Letters per second", {}};
  const TrialSums& alone = facts.alone;
  section.lines.push_back(alone.letters == 0
                              ? "Letters per second: none were named right so far."
                              : fmt::format("Letters per second: {}, named right without help.",
                                            Short(alone.LettersPerSecond(), 2)));
  if (alone.traces > 0) {
    section.lines.push_back(fmt::format(
        "Traced without help: {} letters per second, {} covered, mean error {} groove widths.",
        Short(alone.TracedPerSecond(), 2), Percent(alone.MeanCoverage()),
        Short(alone.MeanErrorWidths(), 2)));
  }
  return section;
}

ReportSection Size(const Course& course, const ReportFacts& facts) {
  const double standard = SizeAt(course, LastSize(course));
  if (facts.size_reached <= 0) {
    return {
        "Size reached",
        {fmt::format("Size reached: none yet; the course begins at {}.", Mm(SizeAt(course, 0)))}};
  }
  const bool there = SameSize(facts.size_reached, standard);
  return {"Size reached",
          {fmt::format("Size reached: {}{}.", Mm(facts.size_reached),
                       there ? ", standard size" : "; standard size is " + Mm(standard))}};
}

ReportSection Confusions(const Course& course, const ReportFacts& facts, std::size_t most) {
  ReportSection section{"What is confused with what", {}};
  for (const ConfusionFact& fact : facts.confusions) {
    if (section.lines.size() == most) {
      section.lines.push_back(
          fmt::format("Confused: {} more, see --html or --csv.",
                      Counted(facts.confusions.size() - most, "pair", "pairs")));
      break;
    }
    section.lines.push_back(fmt::format("Confused: {} taken for {} {}.", Name(course, fact.shown),
                                        Name(course, fact.said),
                                        Times(static_cast<std::size_t>(fact.times))));
  }
  if (facts.confusions.empty()) section.lines.emplace_back("Confused: nothing so far.");
  return section;
}

/// "85 percent named right, 93 percent covered", what there was of it.
std::string Done(const TrialSums& sums) {
  std::string words;
  if (sums.answers > 0) words += fmt::format(", {} named right", Percent(sums.NamedRight()));
  if (sums.traces > 0) words += fmt::format(", {} covered", Percent(sums.MeanCoverage()));
  return words;
}

std::string DayLine(const DayFact& fact) {
  std::string line = fmt::format("{}: {} without help{}", fact.day,
                                 Counted(fact.alone.trials, "trial", "trials"), Done(fact.alone));
  if (fact.alone.letters > 0) {
    line += fmt::format(", {} letters per second", Short(fact.alone.LettersPerSecond(), 2));
  }
  if (fact.smallest > 0) line += ", smallest " + Mm(fact.smallest);
  if (fact.guided.trials > 0) line += fmt::format("; {} with help", fact.guided.trials);
  return line + ".";
}

ReportSection Days(const ReportFacts& facts, std::size_t most) {
  ReportSection section{"Progress over days", {}};
  const std::size_t left_out = facts.days.size() - std::min(most, facts.days.size());
  if (left_out > 0) {
    section.lines.push_back(
        fmt::format("{} before these, see --html.", Counted(left_out, "day", "days")));
  }
  for (std::size_t i = left_out; i < facts.days.size(); ++i) {
    section.lines.push_back(DayLine(facts.days[i]));
  }
  return section;
}

ReportSection Help(const ReportFacts& facts) {
  ReportSection section{"Without and with help", {}};
  section.lines.push_back(fmt::format(
      "Without help: {}{}.", Counted(facts.alone.trials, "trial", "trials"), Done(facts.alone)));
  section.lines.push_back(fmt::format("With help: {}{}; none of them counts above.",
                                      Counted(facts.guided.trials, "trial", "trials"),
                                      Done(facts.guided)));
  if (facts.scaled > 0) {
    section.lines.push_back(fmt::format("Not felt at true size: {}; none of them counts.",
                                        Counted(facts.scaled, "trial", "trials")));
  }
  return section;
}

ReportSection Conditions(const Course& course, const ReportFacts& facts) {
  const MasteryRule& rule = course.mastery;
  return {
      "Conditions",
      {fmt::format("Conditions: {}, {} to {}, {} on {}.", OneLine(course.title),
                   Mm(SizeAt(course, 0)), Mm(SizeAt(course, LastSize(course))),
                   Counted(facts.alone.trials + facts.guided.trials, "trial", "trials"),
                   Counted(facts.days.size(), "day", "days")),
       fmt::format("Sure means, without help and at true size: {} of the last {} named right; at "
                   "the largest size also traces {} covered, with a mean error of at most {} "
                   "groove widths.",
                   Percent(rule.recognised), rule.attempts, Percent(rule.coverage),
                   Short(rule.error_widths, 2))}};
}

}  // namespace

std::string NoReportLearner() {
  return "report lacks a learner: write report NAME; \"moontrace records list\" names them";
}

std::string TwoReportFiles() { return "--html and --csv are two reports: ask for one at a time"; }

std::string NoTrialsYet(std::string_view learner) {
  return fmt::format("{} has no trials yet: learn first", OneLine(learner));
}

std::string NoTrialsOf(std::string_view learner, std::string_view course) {
  return fmt::format("{} has no trials of {}: leave --course out, or name another",
                     OneLine(learner), OneLine(course));
}

std::string CourseOfReport(std::string_view course, std::string_view why) {
  return fmt::format("the course {} is needed for a report: name its folder by --course; {}",
                     OneLine(course), OneLine(why, 200));
}

std::string ReportOutcome(std::string_view learner, const Course& course,
                          const ReportFacts& facts) {
  return fmt::format("{}: {} of {} mastered, {} of {} done, {}.", OneLine(learner), facts.mastered,
                     Counted(facts.items, "sign", "signs"), facts.lessons_done,
                     Counted(LessonsInOrder(course), "lesson", "lessons"), OneLine(course.title));
}

std::string NotThePedagogy() {
  return "A simulated learner: this proves the software, not the pedagogy.";
}

std::string PartlySimulated(std::size_t trials) {
  return fmt::format("Simulated: {} of these trials; they prove the software, not the pedagogy.",
                     trials);
}

std::string ReportIn() { return "Report in:"; }

std::string ReportTitle(std::string_view learner, const Course& course) {
  return fmt::format("{}, {}", OneLine(learner), OneLine(course.title));
}

std::vector<ReportSection> ReportSections(const Course& course, const ReportFacts& facts,
                                          std::size_t most) {
  return {Sure(course, facts), Practise(course, facts),         Speed(facts),
          Size(course, facts), Confusions(course, facts, most), Days(facts, most),
          Help(facts),         Conditions(course, facts)};
}

std::vector<ReportPlot> ReportPlots(const ReportFacts& facts) {
  ReportPlot named{"Named right without help, by day", "percent", {}, {}, 100};
  ReportPlot covered{"Covered by traces without help, by day", "percent", {}, {}, 100};
  ReportPlot speed{
      "Letters per second, named right without help, by day", "letters per second", {}, {}, 0};
  ReportPlot size{"Smallest letters named right without help, by day", "mm", {}, {}, 0};
  const auto add = [](ReportPlot& plot, const DayFact& day, bool is, double value) {
    if (!is) return;
    plot.labels.push_back(day.day);
    plot.values.push_back(value);
  };
  for (const DayFact& day : facts.days) {
    add(named, day, day.alone.answers > 0, 100 * day.alone.NamedRight());
    add(covered, day, day.alone.traces > 0, 100 * day.alone.MeanCoverage());
    add(speed, day, day.alone.letters > 0, day.alone.LettersPerSecond());
    add(size, day, day.smallest > 0, kMillimetres * day.smallest);
  }
  std::vector<ReportPlot> plots;
  for (ReportPlot* plot : {&named, &covered, &speed, &size}) {
    if (!plot->values.empty()) plots.push_back(std::move(*plot));
  }
  return plots;
}

std::string PlotWords(const ReportPlot& plot) {
  const auto value = [&plot](double number) {
    return fmt::format("{} {}", Short(number, 2), plot.unit);
  };
  if (plot.values.size() == 1) {
    return fmt::format("One day, {}: {}.", plot.labels.front(), value(plot.values.front()));
  }
  const auto ends = std::minmax_element(plot.values.begin(), plot.values.end());
  return fmt::format("From {} on {} to {} on {}; least {}, greatest {}, over {} days.",
                     value(plot.values.front()), plot.labels.front(), value(plot.values.back()),
                     plot.labels.back(), value(*ends.first), value(*ends.second),
                     plot.values.size());
}

std::string MatrixHeading() { return "All answers"; }

std::string MatrixWords(std::size_t answers) {
  return fmt::format(
      "{} given without help to \"what is it?\": a row for each sign that was "
      "shown, with what it was taken for and how often.",
      Counted(answers, "answer", "answers"));
}

}  // namespace moontrace::say
