#include "lessons/records/report_facts.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <utility>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/learning.h"
#include "lessons/progress/mastery.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr std::size_t kLast = 10;  ///< last trials that show how well an item is known now
constexpr std::size_t kToPractise = 3;

double Ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

std::size_t Letters(std::string_view item) {
  return CountCharacters(item) -
         static_cast<std::size_t>(std::count(item.begin(), item.end(), ' '));
}

bool IsNaming(const Trial& trial) {
  return (trial.kind == StepKind::kRecognise || trial.kind == StepKind::kTest) &&
         PairOf(trial.item).second.empty();
}

void Count(const Course& course, const Trial& trial, TrialSums& sums) {
  ++sums.trials;
  if (IsNaming(trial)) {
    ++sums.answers;
    if (!trial.right) return;
    ++sums.right;
    if (trial.latency <= 0) return;
    sums.letters += Letters(trial.item);
    sums.latency += trial.latency;
  } else if (trial.kind == StepKind::kTrace) {
    ++sums.traces;
    if (GoodTrace(course.mastery, trial)) ++sums.good;
    sums.coverage += trial.coverage;
    sums.error_widths += trial.error_widths;
    if (trial.duration <= 0) return;
    sums.traced_letters += Letters(trial.item);
    sums.duration += trial.duration;
  }
}

/// The item's last unguided trials, from the newest back.
void CountLast(const Course& course, const std::vector<Trial>& trials, ItemFact& fact) {
  for (auto trial = trials.rbegin(); trial != trials.rend(); ++trial) {
    if (trial->item != fact.item || trial->guided() || trial->scaled) continue;
    if (IsNaming(*trial) && fact.answers < kLast) {
      ++fact.answers;
      if (trial->right) ++fact.right;
    } else if (trial->kind == StepKind::kTrace && fact.traces < kLast) {
      ++fact.traces;
      if (GoodTrace(course.mastery, *trial)) ++fact.good;
    }
  }
}

void MostTakenFor(const Progress& progress, ItemFact& fact) {
  const auto found = progress.confusions.find(fact.item);
  if (found == progress.confusions.end()) return;
  for (const auto& said : found->second) {
    if (said.second <= fact.taken) continue;
    fact.taken_for = said.first;
    fact.taken = said.second;
  }
}

/// Items in the order in which the course teaches them, then the rest.
std::vector<std::string> InOrder(const Course& course, const Progress& progress) {
  std::vector<std::string> order;
  const auto add = [&](const std::string& item) {
    if (progress.items.count(item) == 0) return;
    if (std::find(order.begin(), order.end(), item) == order.end()) order.push_back(item);
  };
  for (const Lesson& lesson : course.lessons) {
    for (const std::string& item : lesson.items) add(item);
  }
  for (const auto& item : progress.items) add(item.first);
  return order;
}

void AddItems(const Course& course, const std::vector<Trial>& trials, const Progress& progress,
              ReportFacts& facts) {
  for (const std::string& item : InOrder(course, progress)) {
    const ItemProgress& known = progress.items.at(item);
    ItemFact fact;
    fact.item = item;
    fact.mastered = known.mastered;
    CountLast(course, trials, fact);
    MostTakenFor(progress, fact);
    if (known.mastered && IsTaught(course, item)) ++facts.mastered;
    const bool below = known.size_step > 0 && !known.sure;  // the size above this one is behind it
    fact.size = SizeAt(course, known.size_step);
    if (fact.Weakness() > 0) facts.practise.push_back(fact);
    if (!known.sure && !below) continue;
    fact.size = SizeAt(course, below ? known.size_step - 1 : known.size_step);
    facts.sure.push_back(fact);
  }
  std::stable_sort(facts.sure.begin(), facts.sure.end(),
                   [](const ItemFact& a, const ItemFact& b) { return a.size < b.size; });
  if (!facts.sure.empty()) facts.size_reached = facts.sure.front().size;
  std::stable_sort(
      facts.practise.begin(), facts.practise.end(),
      [](const ItemFact& a, const ItemFact& b) { return a.Weakness() > b.Weakness(); });
  if (facts.practise.size() > kToPractise) facts.practise.resize(kToPractise);
}

void AddConfusions(const Progress& progress, ReportFacts& facts) {
  for (const auto& shown : progress.confusions) {
    for (const auto& said : shown.second) {
      facts.confusions.push_back({shown.first, said.first, said.second});
    }
  }
  std::stable_sort(
      facts.confusions.begin(), facts.confusions.end(),
      [](const ConfusionFact& a, const ConfusionFact& b) { return a.times > b.times; });
}

/// A day may come again behind a later one, where the clock was set back.
DayFact& Today(const std::string& day, ReportFacts& facts) {
  const auto same = [&day](const DayFact& fact) { return fact.day == day; };
  const auto found = std::find_if(facts.days.rbegin(), facts.days.rend(), same);
  if (found != facts.days.rend()) return *found;
  facts.days.emplace_back();
  facts.days.back().day = day;
  return facts.days.back();
}

void AddTrial(const Course& course, const Trial& trial, ReportFacts& facts) {
  if (trial.simulated) ++facts.simulated;
  if (trial.scaled) {
    ++facts.scaled;
    return;
  }
  DayFact& today = Today(DayOf(trial.time), facts);
  Count(course, trial, trial.guided() ? facts.guided : facts.alone);
  Count(course, trial, trial.guided() ? today.guided : today.alone);
  if (trial.guided() || !IsNaming(trial)) return;
  if (!trial.answer.empty()) ++facts.matrix[trial.item][trial.answer];
  if (trial.right && (today.smallest == 0 || trial.size < today.smallest)) {
    today.smallest = trial.size;
  }
}

}  // namespace

double TrialSums::NamedRight() const {
  return Ratio(static_cast<double>(right), static_cast<double>(answers));
}
double TrialSums::MeanCoverage() const { return Ratio(coverage, static_cast<double>(traces)); }
double TrialSums::MeanErrorWidths() const {
  return Ratio(error_widths, static_cast<double>(traces));
}
double TrialSums::LettersPerSecond() const { return Ratio(static_cast<double>(letters), latency); }
double TrialSums::TracedPerSecond() const {
  return Ratio(static_cast<double>(traced_letters), duration);
}

double ItemFact::Weakness() const {
  // One right and one wrong are added to each, so that few trials say little (Laplace).
  const auto share = [](std::size_t good_ones, std::size_t all) {
    return static_cast<double>(all - good_ones + 1) / static_cast<double>(all + 2);
  };
  const double named = answers > 0 ? share(right, answers) : 0;
  const double traced = traces > 0 ? share(good, traces) : 0;
  const bool faultless = right == answers && good == traces;
  return faultless ? 0 : std::max(named, traced);
}

ReportFacts FactsOf(const Course& course, const std::vector<Trial>& trials) {
  ReportFacts facts;
  for (const Lesson& lesson : course.lessons) facts.items += lesson.items.size();
  for (const Trial& trial : trials) {
    if (!trial.item.empty()) AddTrial(course, trial, facts);
  }
  const Progress progress = LearnAll(course, trials);
  facts.lessons_done = static_cast<std::size_t>(
      std::count_if(progress.done.begin(), progress.done.end(), [&course](const std::string& id) {
        const auto index = LessonIndex(course, id);
        return index && !course.lessons[*index].optional;
      }));
  AddItems(course, trials, progress, facts);
  AddConfusions(progress, facts);
  return facts;
}

std::string DayOf(std::int64_t time) {
  const std::time_t seconds = time;
  std::tm parts{};
  if (localtime_r(&seconds, &parts) == nullptr) return "an unknown day";
  return fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

}  // namespace moontrace
