#include "lessons/records/report_facts.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <tuple>
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

bool IsAnswer(const Trial& trial) {
  return trial.kind == StepKind::kRecognise || trial.kind == StepKind::kTest;
}

bool IsNaming(const Trial& trial) { return IsAnswer(trial) && PairOf(trial.item).second.empty(); }

/// Of an answer: where it is counted.
AnswerSums& SumsOf(const Course& course, const Trial& trial, TrialSums& sums) {
  if (IsNaming(trial)) return IsTaught(course, trial.item) ? sums.signs : sums.words;
  const Step* step = StepAt(course, trial.lesson, trial.step);
  const bool picks = step != nullptr && step->question != Question::kName
                         ? step->question == Question::kPick
                         : HasItem(course, trial.answer);  // the lesson was changed since
  return picks ? sums.picked : sums.compared;
}

void Count(const Course& course, const Trial& trial, TrialSums& sums) {
  ++sums.trials;
  if (IsAnswer(trial)) {
    AnswerSums& answers = SumsOf(course, trial, sums);
    ++answers.answers;
    if (!trial.right) return;
    ++answers.right;
    if (trial.latency <= 0 || !IsNaming(trial)) return;
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

/// The item's last trials, from the newest back.
void CountLast(const Course& course, const std::vector<Trial>& trials, ItemFact& fact) {
  for (auto trial = trials.rbegin(); trial != trials.rend(); ++trial) {
    const ItemPair pair = PairOf(trial->item);
    if (pair.first != fact.item && pair.second != fact.item) continue;
    if (fact.last == 0) fact.last = trial->time;
    if (!pair.second.empty() || trial->guided() || trial->scaled) continue;
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

void AddOnce(std::vector<std::string>& list, const std::string& item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

/// Signs of the course, each once, without those of the lessons beside it.
std::vector<std::string> SignsInOrder(const Course& course) {
  std::vector<std::string> signs;
  for (const Lesson& lesson : course.lessons) {
    for (const std::string& item : lesson.items) {
      if (!lesson.optional) AddOnce(signs, item);
    }
  }
  return signs;
}

/// Items that were met, in the order in which the course teaches them, then the rest.
std::vector<std::string> InOrder(const Course& course, const Progress& progress) {
  std::vector<std::string> order;
  for (const Lesson& lesson : course.lessons) {
    for (const std::string& item : lesson.items) {
      if (progress.items.count(item) > 0) AddOnce(order, item);
    }
  }
  for (const auto& item : progress.items) AddOnce(order, item.first);
  return order;
}

ItemFact FactOf(const Course& course, const std::vector<Trial>& trials, const Progress& progress,
                const std::string& item) {
  const ItemProgress& known = progress.items.at(item);
  ItemFact fact;
  fact.item = item;
  fact.taught = IsTaught(course, item);
  fact.mastered = known.mastered;
  fact.present = SizeAt(course, known.size_step);
  if (known.sure) {
    fact.size = fact.present;
  } else if (known.size_step > 0 && fact.taught) {
    fact.size = SizeAt(course, known.size_step - 1);  // the size above this one is behind it
  }
  CountLast(course, trials, fact);
  MostTakenFor(progress, fact);
  return fact;
}

/// Traces are asked for at the largest size only: of a sign that is sure there they are the past.
bool NeedsPractice(const MasteryRule& rule, const ItemFact& fact) {
  const double named = Ratio(static_cast<double>(fact.right), static_cast<double>(fact.answers));
  const bool weak = fact.answers > 0 && named < rule.target;
  return weak || (fact.size <= 0 && fact.good < fact.traces);
}

void AddItems(const Course& course, const std::vector<Trial>& trials, const Progress& progress,
              ReportFacts& facts) {
  for (const std::string& item : InOrder(course, progress)) {
    facts.met.push_back(FactOf(course, trials, progress, item));
    const ItemFact& fact = facts.met.back();
    if (NeedsPractice(course.mastery, fact)) facts.practise.push_back(fact);
    if (fact.size <= 0) continue;
    const bool smaller = facts.size_reached <= 0 || fact.size < facts.size_reached;
    if (smaller) facts.size_reached = fact.size;
  }
  std::stable_sort(
      facts.practise.begin(), facts.practise.end(),
      [](const ItemFact& a, const ItemFact& b) { return a.Weakness() > b.Weakness(); });
  if (facts.practise.size() > kToPractise) facts.practise.resize(kToPractise);
  for (const std::string& sign : SignsInOrder(course)) {
    ++facts.items;
    const auto met = progress.items.find(sign);
    if (met == progress.items.end()) {
      facts.unmet.push_back(sign);
    } else if (met->second.mastered) {
      ++facts.mastered;
    }
  }
}

/// What was said for what, of an unguided answer; nothing: right, or no item.
std::string TakenFor(const Course& course, const Trial& trial) {
  if (trial.right || trial.answer.empty() || trial.guided()) return {};
  const ItemPair pair = PairOf(trial.item);
  if (!HasItem(course, pair.first)) return {};
  if (HasItem(course, trial.answer)) return trial.answer == pair.first ? "" : trial.answer;
  return pair.second;  // two different ones held to be the same
}

void AddConfusions(const Course& course, const std::vector<Trial>& trials, ReportFacts& facts) {
  std::map<ItemPair, ConfusionFact, bool (*)(const ItemPair&, const ItemPair&)> found(
      [](const ItemPair& a, const ItemPair& b) {
        return std::tie(a.first, a.second) < std::tie(b.first, b.second);
      });
  for (const Trial& trial : trials) {
    const std::string said = IsAnswer(trial) && !trial.scaled ? TakenFor(course, trial) : "";
    const std::string shown = PairOf(trial.item).first;
    if (said.empty() || said == shown) continue;
    const ItemPair key{std::min(shown, said), std::max(shown, said)};
    ConfusionFact& fact = found[key];
    ++(shown == key.first ? fact.times : fact.back);
    fact.last = std::max(fact.last, trial.time);
  }
  const ItemLikeness likeness(course);
  for (auto& [pair, fact] : found) {
    const bool turn = fact.back > fact.times;
    fact.shown = turn ? pair.second : pair.first;
    fact.said = turn ? pair.first : pair.second;
    if (turn) std::swap(fact.times, fact.back);
    fact.likeness = likeness.Of(fact.shown, fact.said);
    facts.confusions.push_back(fact);
  }
  // two signs more than once before words, which come by their signs
  const auto weight = [&course](const ConfusionFact& fact) {
    const bool signs = IsTaught(course, fact.shown) && IsTaught(course, fact.said);
    return std::make_tuple(signs && fact.all() > 1, fact.all(), signs, fact.last);
  };
  std::stable_sort(
      facts.confusions.begin(), facts.confusions.end(),
      [&](const ConfusionFact& a, const ConfusionFact& b) { return weight(a) > weight(b); });
}

/// A day may come again behind a later one, where the clock was set back.
DayFact& DayIn(std::vector<DayFact>& days, const std::string& day) {
  const auto same = [&day](const DayFact& fact) { return fact.day == day; };
  const auto found = std::find_if(days.rbegin(), days.rend(), same);
  if (found != days.rend()) return *found;
  days.emplace_back();
  days.back().day = day;
  return days.back();
}

void AddTo(const Course& course, const Trial& trial, DayFact& day) {
  Count(course, trial, trial.guided() ? day.guided : day.alone);
  if (trial.guided() || !IsNaming(trial) || !trial.right) return;
  if (day.smallest == 0 || trial.size < day.smallest) day.smallest = trial.size;
}

void AddTrial(const Course& course, const Trial& trial, ReportFacts& facts) {
  if (trial.simulated) ++facts.simulated;
  if (trial.scaled) {
    ++facts.scaled;
    return;
  }
  Count(course, trial, trial.guided() ? facts.guided : facts.alone);
  AddTo(course, trial, DayIn(facts.days, DayOf(trial.time)));
  AddTo(course, trial, DayIn(facts.weeks, WeekOf(trial.time)));
  const bool sign = IsNaming(trial) && IsTaught(course, trial.item);
  if (sign && !trial.guided() && !trial.answer.empty()) ++facts.matrix[trial.item][trial.answer];
}

/// "2026-11-21", of a day so many days after that of `time`.
std::string Date(std::int64_t time, const std::function<int(const std::tm&)>& days_after) {
  const std::time_t seconds = time;
  std::tm parts{};
  if (localtime_r(&seconds, &parts) == nullptr) return "an unknown day";
  const int after = days_after(parts);
  if (after != 0) {
    parts.tm_mday += after;
    parts.tm_hour = 12;  // no change of the clock makes noon another day
    parts.tm_isdst = -1;
    std::mktime(&parts);
  }
  return fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

}  // namespace

double AnswerSums::Share() const {
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
  const double traced = traces > 0 && size <= 0 ? share(good, traces) : 0;
  return std::max(named, traced);
}

ReportFacts FactsOf(const Course& course, const std::vector<Trial>& trials) {
  ReportFacts facts;
  for (const Trial& trial : trials) {
    if (!trial.item.empty()) AddTrial(course, trial, facts);
  }
  const Progress progress = LearnAll(course, trials);
  facts.lesson = progress.lesson;
  facts.step = progress.step;
  facts.lessons_done = static_cast<std::size_t>(
      std::count_if(progress.done.begin(), progress.done.end(), [&course](const std::string& id) {
        const auto index = LessonIndex(course, id);
        return index && !course.lessons[*index].optional;
      }));
  facts.course_done = facts.lessons_done >= LessonsInOrder(course);
  AddItems(course, trials, progress, facts);
  AddConfusions(course, trials, facts);
  return facts;
}

std::string DayOf(std::int64_t time) {
  return Date(time, [](const std::tm&) { return 0; });
}

std::string WeekOf(std::int64_t time) {
  return Date(time, [](const std::tm& day) { return -((day.tm_wday + 6) % 7); });
}

}  // namespace moontrace
