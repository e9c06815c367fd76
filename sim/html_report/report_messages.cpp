#include "sim/html_report/report_messages.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

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

using Row = std::vector<std::string>;

constexpr std::size_t kConfusions = 5;   ///< that matter; a page has all behind them
constexpr std::size_t kDaysPlotted = 2;  ///< weeks whose days are plotted singly

ReportSection Headed(std::string heading) {
  ReportSection section;
  section.heading = std::move(heading);
  return section;
}

std::string TimesOf(int count) { return Times(static_cast<std::size_t>(count)); }

/// "lesson 16, Numbers".
std::string LessonOf(const Course& course, std::size_t index) {
  return fmt::format("lesson {}, {}", index + 1, OneLine(course.lessons[index].title));
}

std::string SignsSure(const Course& course, const ReportFacts& facts) {
  return fmt::format("{} of {} sure at {}, the smallest size", facts.mastered,
                     Counted(facts.items, "sign", "signs"), Mm(SizeAt(course, LastSize(course))));
}

std::string Where(std::string_view learner, const Course& course, const ReportFacts& facts) {
  const std::string name = OneLine(learner);
  const std::size_t lessons = LessonsInOrder(course);
  if (facts.course_done) {
    return fmt::format("{} has done all {} of {}: {}.", name, Counted(lessons, "lesson", "lessons"),
                       OneLine(course.title), SignsSure(course, facts));
  }
  const auto lesson = LessonIndex(course, facts.lesson);
  const std::string at = lesson ? fmt::format("is at {}, step {} of {}", LessonOf(course, *lesson),
                                              facts.step + 1, course.lessons[*lesson].steps.size())
                                : std::string("is at a lesson that the course no longer has");
  return fmt::format("{} {}: {} of {} done, {}.", name, at, facts.lessons_done,
                     Counted(lessons, "lesson", "lessons"), SignsSure(course, facts));
}

/// "named right 6 of the last 10, traced well 1 of the last 2".
std::string Weak(const ItemFact& fact) {
  std::vector<std::string> parts;
  if (fact.answers > fact.right) {
    parts.push_back(fmt::format("named right {} of the last {}", fact.right, fact.answers));
  }
  if (fact.traces > fact.good && fact.size <= 0) {
    parts.push_back(fmt::format("traced well {} of the last {}", fact.good, fact.traces));
  }
  return Joined(parts, ", ");
}

std::string Next(const Course& course, const ReportFacts& facts) {
  const auto lesson = LessonIndex(course, facts.lesson);
  std::string next = facts.course_done || !lesson
                         ? std::string("Next: read, with my text, and what comes up for review")
                         : "Next: go on with " + LessonOf(course, *lesson);
  std::vector<std::string> names;
  for (const ItemFact& fact : facts.practise) names.push_back(Name(course, fact.item));
  if (!names.empty()) next += fmt::format(", and practise {}", Joined(names, " and "));
  return next + ".";
}

std::string Taken(const Course& course, const ConfusionFact& fact) {
  const std::string shown = Name(course, fact.shown), said = Name(course, fact.said);
  std::string words = fmt::format("{} taken for {}, {}", shown, said, TimesOf(fact.times));
  if (fact.back > 0) words += fmt::format(", {} for {}, {}", said, shown, TimesOf(fact.back));
  return words;
}

/// "mirrored"; of two that are alike in no such way nothing.
std::string Alike(const ConfusionFact& fact) {
  return fact.likeness == Likeness::kOther ? "" : fmt::format(" ({})", NameOf(fact.likeness));
}

std::string Hard(const Course& course, const ReportFacts& facts) {
  std::vector<std::string> parts;
  if (!facts.practise.empty()) {
    const ItemFact& weakest = facts.practise.front();
    parts.push_back(Name(course, weakest.item) + ", " + Weak(weakest));
  }
  if (!facts.confusions.empty() && facts.confusions.front().all() > 1) {
    const ConfusionFact& first = facts.confusions.front();
    parts.push_back(Taken(course, first) + Alike(first));
  }
  if (parts.empty()) return "Hard: nothing stands out.";
  return fmt::format("Hard: {}.", Joined(parts, "; "));
}

std::string Right(const ItemFact& fact) {
  if (fact.answers == 0) return "not named by itself yet";
  return fmt::format("{} of the last {} right", fact.right, fact.answers);
}

std::string Sure(const ItemFact& fact) {
  if (fact.size <= 0) return "not yet sure";
  return "sure at " + Mm(fact.size);
}

ReportSection Signs(const Course& course, const ReportFacts& facts) {
  ReportSection section = Headed("Signs");
  section.table = {"Every sign that was met, in the order of the course",
                   {"Sign", "Size reached", "Now at", "How sure", "Last seen"},
                   {}};
  for (const ItemFact& fact : facts.met) {
    if (!fact.taught) continue;
    const std::string name = Name(course, fact.item), day = DayOf(fact.last);
    const bool smaller = fact.size <= 0 || !SameSize(fact.size, fact.present);
    section.row_lines.push_back(fmt::format("{}: {}{}, {}, last seen {}.", name, Sure(fact),
                                            smaller ? ", now at " + Mm(fact.present) : "",
                                            Right(fact), day));
    section.table.rows.push_back(
        {name, fact.size > 0 ? Mm(fact.size) : "none yet", Mm(fact.present), Right(fact), day});
  }
  std::vector<std::string> names;
  for (const std::string& sign : facts.unmet) names.push_back(Name(course, sign));
  if (!names.empty()) {
    section.lines.push_back(fmt::format("Still to come: {}.", Joined(names, " and ")));
  }
  if (section.row_lines.empty()) section.table.columns.clear();
  return section;
}

ReportSection Practise(const Course& course, const ReportFacts& facts) {
  ReportSection section = Headed("What to practise");
  for (const ItemFact& fact : facts.practise) {
    std::string line = fmt::format("Practise {}: {}", Name(course, fact.item), Weak(fact));
    if (fact.taken > 0) {
      line += fmt::format(", taken for {}, {}", Name(course, fact.taken_for), TimesOf(fact.taken));
    }
    section.lines.push_back(line + fmt::format("; now at {}.", Mm(fact.present)));
  }
  if (facts.practise.empty()) {
    section.lines.emplace_back("Practise: nothing more than the rest.");
  }
  return section;
}

std::string Answered(std::string_view what, const AnswerSums& sums, std::string_view more) {
  return fmt::format("{}: {} of {} right, {}{}.", what, sums.right, sums.answers,
                     Percent(sums.Share()), more);
}

/// Each kind of question by itself: what can be guessed says less.
ReportSection Answers(const ReportFacts& facts) {
  ReportSection section = Headed("Answers without help");
  const TrialSums& alone = facts.alone;
  const auto add = [&section](std::string_view what, const AnswerSums& sums,
                              std::string_view more) {
    if (sums.answers > 0) section.lines.push_back(Answered(what, sums, more));
  };
  add("Signs named", alone.signs, "");
  add("Words read", alone.words, "");
  add("Which of two", alone.picked, "; half can be guessed");
  add("Same or different", alone.compared, "; half can be guessed");
  if (section.lines.empty()) section.lines.emplace_back("Answers: none without help so far.");
  return section;
}

std::string Family(Likeness likeness) {
  if (likeness == Likeness::kOther) return "Confused";
  std::string name(NameOf(likeness));
  name.front() = static_cast<char>(name.front() - 'a' + 'A');
  return name;
}

ReportSection Confusions(const Course& course, const ReportFacts& facts) {
  ReportSection section = Headed("What is confused with what");
  const std::size_t count = std::min(kConfusions, facts.confusions.size());
  std::vector<ConfusionFact> first(facts.confusions.begin(),
                                   facts.confusions.begin() + static_cast<std::ptrdiff_t>(count));
  std::stable_sort(first.begin(), first.end(), [](const ConfusionFact& a, const ConfusionFact& b) {
    return a.likeness < b.likeness;
  });
  for (const ConfusionFact& fact : first) {
    section.lines.push_back(fmt::format("{}: {}.", Family(fact.likeness), Taken(course, fact)));
  }
  if (facts.confusions.size() > count) {
    const ConfusionFact& next = facts.confusions[count];
    section.lines.push_back(
        fmt::format("{} more, each {}.", Counted(facts.confusions.size() - count, "pair", "pairs"),
                    next.all() == 1 ? "once" : "at most " + TimesOf(next.all())));
  }
  if (count == 0) section.lines.emplace_back("Confused: nothing so far.");
  return section;
}

ReportSection Matrix(const Course& course, const ReportFacts& facts) {
  ReportSection section = Headed("All answers to single signs");
  section.behind = true;
  std::set<std::string> said;
  std::size_t answers = 0;
  for (const auto& row : facts.matrix) {
    for (const auto& cell : row.second) {
      said.insert(cell.first);
      answers += static_cast<std::size_t>(cell.second);
    }
  }
  if (answers == 0) return section;
  section.table.caption = fmt::format(
      "{} given without help to \"what is it?\": a row for each sign that was shown, with what it "
      "was taken for and how often.",
      Counted(answers, "answer", "answers"));
  section.table.columns = {"Shown"};
  for (const std::string& answer : said) section.table.columns.push_back(Name(course, answer));
  for (const auto& row : facts.matrix) {
    Row cells{Name(course, row.first)};
    for (const std::string& answer : said) {
      const auto cell = row.second.find(answer);
      cells.push_back(std::to_string(cell == row.second.end() ? 0 : cell->second));
    }
    section.table.rows.push_back(std::move(cells));
  }
  return section;
}

ReportSection SpeedAndSize(const Course& course, const ReportFacts& facts) {
  ReportSection section = Headed("Speed and size");
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
  const std::string smallest = Mm(SizeAt(course, LastSize(course)));
  section.lines.push_back(
      facts.size_reached > 0
          ? fmt::format("Smallest size at which a sign is sure: {}; the course ends at {}.",
                        Mm(facts.size_reached), smallest)
          : fmt::format("Smallest size at which a sign is sure: none yet; the course begins at {}.",
                        Mm(SizeAt(course, 0))));
  return section;
}

/// ", signs 92 percent right, 93 percent covered", what there was of it.
std::string Done(const TrialSums& sums) {
  std::string words;
  const auto add = [&words](std::string_view what, const AnswerSums& answers) {
    if (answers.answers > 0) words += fmt::format(", {} {} right", what, Percent(answers.Share()));
  };
  add("signs", sums.signs);
  add("words", sums.words);
  add("which of two", sums.picked);
  add("same or different", sums.compared);
  if (sums.traces > 0) words += fmt::format(", {} covered", Percent(sums.MeanCoverage()));
  return words;
}

std::string DayLine(std::string_view before, const DayFact& fact) {
  std::string line = fmt::format("{}{}: {} without help{}", before, fact.day,
                                 Counted(fact.alone.trials, "trial", "trials"), Done(fact.alone));
  if (fact.alone.letters > 0) {
    line += fmt::format(", {} letters per second", Short(fact.alone.LettersPerSecond(), 2));
  }
  if (fact.smallest > 0) line += ", smallest " + Mm(fact.smallest);
  if (fact.guided.trials > 0) line += fmt::format("; {} with help", fact.guided.trials);
  return line + ".";
}

Row DayRow(const DayFact& fact) {
  const auto share = [](const AnswerSums& sums) {
    return sums.answers > 0 ? Short(100 * sums.Share(), 0) : std::string("none");
  };
  const TrialSums& alone = fact.alone;
  return {fact.day,
          std::to_string(alone.trials),
          std::to_string(fact.guided.trials),
          share(alone.signs),
          share(alone.words),
          share(alone.picked),
          share(alone.compared),
          alone.letters > 0 ? Short(alone.LettersPerSecond(), 2) : "none",
          fact.smallest > 0 ? Mm(fact.smallest) : "none"};
}

ReportTable DaysTable(std::string_view first, const std::vector<DayFact>& days) {
  ReportTable table;
  table.caption = "Trials, and of the answers without help how many percent were right";
  table.columns = {std::string(first), "Without help",      "With help",        "Signs",   "Words",
                   "Which of two",     "Same or different", "Letters a second", "Smallest"};
  for (const DayFact& day : days) table.rows.push_back(DayRow(day));
  return table;
}

ReportSection Weeks(const ReportFacts& facts) {
  ReportSection section = Headed("Progress over weeks");
  for (const DayFact& week : facts.weeks) section.row_lines.push_back(DayLine("Week of ", week));
  section.table = DaysTable("Week of", facts.weeks);
  return section;
}

ReportSection Days(const ReportFacts& facts, std::size_t most) {
  ReportSection section = Headed("Progress over days");
  const std::size_t left_out = facts.days.size() - std::min(most, facts.days.size());
  if (left_out > 0) {
    section.row_lines.push_back(
        fmt::format("{} before these, see --html.", Counted(left_out, "day", "days")));
  }
  for (std::size_t i = left_out; i < facts.days.size(); ++i) {
    section.row_lines.push_back(DayLine("", facts.days[i]));
  }
  section.table = DaysTable("Day", facts.days);
  return section;
}

ReportSection Help(const ReportFacts& facts) {
  ReportSection section = Headed("Without and with help");
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
  ReportSection section = Headed("Conditions");
  section.lines = {
      fmt::format("Conditions: {}, {} to {}, {} on {}.", OneLine(course.title),
                  Mm(SizeAt(course, 0)), Mm(SizeAt(course, LastSize(course))),
                  Counted(facts.alone.trials + facts.guided.trials, "trial", "trials"),
                  Counted(facts.days.size(), "day", "days")),
      fmt::format(
          "Sure means, without help and at true size: {} of the last {} named right; at the "
          "largest size also traces {} covered, with a mean error of at most {} groove "
          "widths.",
          Percent(rule.recognised), rule.attempts, Percent(rule.coverage),
          Short(rule.error_widths, 2))};
  return section;
}

}  // namespace

std::string NoReportLearner() {
  return "report lacks a learner: write moontrace report NAME; \"moontrace records list\" names "
         "them";
}

std::string TwoReportLearners() {
  return "two learners: write report NAME, or report --learner NAME";
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

std::vector<std::string> ReportSentences(std::string_view learner, const Course& course,
                                         const ReportFacts& facts) {
  return {Where(learner, course, facts), Next(course, facts), Hard(course, facts)};
}

std::string NotThePedagogy() {
  return "A simulated learner: this shows that the program works, not how people learn.";
}

std::string WorkedWith(const std::vector<std::string>& devices) {
  std::string line = fmt::format("Device: {}", OneLine(devices.back(), 40));
  for (std::size_t i = devices.size() - 1; i > 0; --i) {
    line += fmt::format("{} {}", i == devices.size() - 1 ? "; before that" : ",",
                        OneLine(devices[i - 1], 40));
  }
  return line + ".";
}

std::string PartlySimulated(std::size_t trials) {
  return fmt::format(
      "Simulated: {} of these trials; they show that the program works, not how people learn.",
      trials);
}

std::string ReportIn() { return "Report in:"; }

std::string ReportTitle(std::string_view learner, const Course& course) {
  return fmt::format("{}, {}", OneLine(learner), OneLine(course.title));
}

std::vector<ReportSection> ReportSections(const Course& course, const ReportFacts& facts,
                                          std::size_t most) {
  std::vector<ReportSection> sections{Signs(course, facts), Practise(course, facts)};
  for (const ReportPlot& plot : ReportPlots(facts)) {
    sections.push_back(Headed(plot.title));
    sections.back().lines = {PlotWords(plot)};
    sections.back().plot = plot;
  }
  sections.insert(sections.end(), {Answers(facts), Confusions(course, facts), Matrix(course, facts),
                                   SpeedAndSize(course, facts), Weeks(facts), Days(facts, most),
                                   Help(facts), Conditions(course, facts)});
  return sections;
}

std::vector<ReportPlot> ReportPlots(const ReportFacts& facts) {
  const bool singly = facts.weeks.size() <= kDaysPlotted;
  const std::string by = singly ? ", by day" : ", by week";
  ReportPlot signs{"Signs named right without help" + by, "percent", {}, {}, 100};
  ReportPlot words{"Words read right without help" + by, "percent", {}, {}, 100};
  ReportPlot speed{"Letters named right in a second, without help" + by, "letters", {}, {}, 0};
  ReportPlot size{"Smallest letters named right without help" + by, "mm", {}, {}, 0};
  const auto add = [](ReportPlot& plot, const DayFact& day, bool is, double value) {
    if (!is) return;
    plot.labels.push_back(day.day);
    plot.values.push_back(value);
  };
  for (const DayFact& day : singly ? facts.days : facts.weeks) {
    add(signs, day, day.alone.signs.answers > 0, 100 * day.alone.signs.Share());
    add(words, day, day.alone.words.answers > 0, 100 * day.alone.words.Share());
    add(speed, day, day.alone.letters > 0, day.alone.LettersPerSecond());
    add(size, day, day.smallest > 0, kMillimetres * day.smallest);
  }
  std::vector<ReportPlot> plots;
  for (ReportPlot* plot : {&signs, &words, &speed, &size}) {
    if (!plot->values.empty()) plots.push_back(std::move(*plot));
  }
  return plots;
}

std::string PlotWords(const ReportPlot& plot) {
  const auto value = [&plot](double number) {
    if (plot.unit == "percent") return Percent(number / 100);  // rounds as in the lines beside it
    return fmt::format("{} {}", Short(number, 2), plot.unit);
  };
  if (plot.values.size() == 1) {
    return fmt::format("{}: {}.", plot.labels.front(), value(plot.values.front()));
  }
  const auto ends = std::minmax_element(plot.values.begin(), plot.values.end());
  if (value(*ends.first) == value(*ends.second)) {
    return fmt::format("{} from {} to {}.", value(*ends.first), plot.labels.front(),
                       plot.labels.back());
  }
  return fmt::format("From {} on {} to {} on {}; least {}, greatest {}.",
                     value(plot.values.front()), plot.labels.front(), value(plot.values.back()),
                     plot.labels.back(), value(*ends.first), value(*ends.second));
}

}  // namespace moontrace::say
