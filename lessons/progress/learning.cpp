#include "lessons/progress/learning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lessons/course/lesson_items.h"
#include "lessons/guide/fading.h"
#include "lessons/guide/guidance_table.h"
#include "lessons/progress/fsrs.h"
#include "lessons/progress/lesson_path.h"
#include "lessons/progress/mastery.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr double kDay = 86400;         ///< [s]
constexpr std::size_t kRecent = 20;    ///< answers that show how hard it is just now
constexpr double kLargestError = 1e3;  ///< for fading, of NaN and infinity [groove widths]

void AddLast(std::vector<bool>& values, bool value, std::size_t most) {
  values.push_back(value);
  if (values.size() > most) values.erase(values.begin());
}

/// The rule that the course names; the gate where it cannot be had: progress never fails.
FadeRule RuleOf(const FadeSettings& settings) {
  try {
    return FadeRuleNamed(settings);
  } catch (const std::exception&) {
    return {};
  }
}

/// A trial as evidence: what it shows counts only if the hand was alone.
struct Evidence {
  bool fair = false;  ///< unguided and unscaled
  bool good = false;
  bool traced = false, named = false;
};

Evidence EvidenceOf(const Course& course, const Trial& trial, bool pair) {
  Evidence evidence;
  evidence.fair = !trial.guided() && !trial.scaled;
  evidence.traced = trial.kind == StepKind::kTrace;
  evidence.named = !pair && (trial.kind == StepKind::kRecognise || trial.kind == StepKind::kTest);
  evidence.good = evidence.traced ? GoodTrace(course.mastery, trial) : trial.right;
  return evidence;
}

Rating RatingOf(const MasteryRule& rule, const Trial& trial, double days, bool first) {
  if (!trial.right) return Rating::kAgain;
  if (!(trial.latency <= rule.slow)) return Rating::kHard;
  // Easy again and again within one day would put off the next review by years.
  return trial.latency < rule.quick && (first || days >= 1) ? Rating::kEasy : Rating::kGood;
}

/// The answer as a review of the item (FSRS-6).
void Schedule(const MasteryRule& rule, const Trial& trial, ItemProgress& item) {
  const bool first = item.stability <= 0;
  const double days =
      std::max(0.0, (static_cast<double>(trial.time) - static_cast<double>(item.reviewed)) / kDay);
  const Memory memory = Review({item.stability, item.difficulty, item.short_steps},
                               RatingOf(rule, trial, days, first), days);
  item.stability = memory.stability;
  item.difficulty = memory.difficulty;
  item.short_steps = memory.steps;
  item.reviewed = trial.time;
  const double due = static_cast<double>(trial.time) + kDay * NextInterval(memory);
  constexpr double kLatest = 9e18;  // below the greatest 64-bit number
  item.due = static_cast<std::int64_t>(std::clamp(due, -kLatest, kLatest));
}

/// How much help comes next: after every trace, guided or not.
void NextHelp(const Course& course, const Trial& trial, bool good, ItemProgress& item) {
  const double error = std::isfinite(trial.error_widths)
                           ? std::clamp(trial.error_widths, 0.0, kLargestError)
                           : kLargestError;
  const FadeState next =
      FadeHelp(RuleOf(course.fade), FadeState{item.help, item.good_run}, error, good);
  item.help = next.help;
  item.good_run = next.good_run;
  item.guided_run = trial.guided() ? item.guided_run + 1 : 0;
}

/// What the present step has seen of an item, if it is one of the step's.
void AddToStep(const Course& course, const Step& step, const Trial& trial, const Evidence& evidence,
               const std::string& text, double asked_size, Progress& progress) {
  StepItem& here = progress.here[text];
  ++here.trials;
  const bool fair = evidence.fair && trial.size <= asked_size * 1.001;
  const bool as_asked =
      trial.kind == step.kind && evidence.named == (step.question == Question::kName);
  if (!evidence.traced && !as_asked) return;
  if (step.kind == StepKind::kTest) {
    AddLast(here.named, fair && evidence.good, 1);
  } else if (fair && evidence.traced) {
    AddLast(here.traced, evidence.good,
            static_cast<std::size_t>(std::max(1, course.mastery.traces)));
  } else if (fair) {
    const MasteryRule& rule = course.mastery;
    AddLast(here.named, evidence.good,
            static_cast<std::size_t>(std::max({1, rule.attempts, rule.words})));
  }
}

/// Which of the trial's items the step counts it for; empty: none of them is the step's.
std::string CountedFor(const Course& course, const Progress& progress, const ItemPair& pair) {
  const auto lesson = LessonIndex(course, progress.lesson);
  const Step* step = StepAt(course, progress.lesson, progress.step);
  if (!lesson || step == nullptr) return {};
  const std::vector<std::string> items = ItemsOf(course.lessons[*lesson], *step);
  for (const std::string& text : {pair.first, pair.second}) {
    if (std::find(items.begin(), items.end(), text) != items.end()) return text;
  }
  return {};
}

void CountConfusion(const Course& course, const Trial& trial, const ItemPair& pair,
                    Progress& progress) {
  if (trial.right || trial.answer.empty()) return;
  // Two different ones held to be the same: one was taken for the other.
  const std::string& said =
      !pair.second.empty() && !HasItem(course, trial.answer) ? pair.second : trial.answer;
  if (said != pair.first && HasItem(course, said)) ++progress.confusions[pair.first][said];
}

ItemProgress& Known(const Course& course, const std::string& text, Progress& progress) {
  const auto found = progress.items.find(text);
  if (found != progress.items.end()) return found->second;
  ItemProgress fresh;
  fresh.size_step = FirstSizeOf(course, progress, text);
  fresh.help = std::clamp(course.fade.start, 0, 10);
  return progress.items[text] = fresh;
}

/// Counts the trial for an item that is worked on at that size.
void AddEvidenceAt(const Course& course, const Trial& trial, const Evidence& evidence,
                   const std::string& text, ItemProgress& item) {
  const Practice practice = PracticeOf(course, text);
  if (evidence.traced && !TracesCount(practice, item)) return;
  if (!SameSize(trial.size, SizeAt(course, item.size_step))) return;
  AddEvidence(course, practice, trial, evidence.good, item);
}

/// What the trial shows of its item, and of the letters of a word.
void LearnItem(const Course& course, const Trial& trial, Progress& progress) {
  const ItemPair pair = PairOf(trial.item);
  if (!HasItem(course, pair.first)) return;
  const bool two = !pair.second.empty();
  const Evidence evidence = EvidenceOf(course, trial, two);
  ItemProgress& item = Known(course, pair.first, progress);
  ++item.trials;
  if (const Step* step = StepAt(course, progress.lesson, progress.step)) {
    const std::string text = CountedFor(course, progress, pair);
    const double asked = AskedSize(course, progress, step, pair);
    if (!text.empty()) AddToStep(course, *step, trial, evidence, text, asked, progress);
  }
  if (trial.kind == StepKind::kDemonstrate || evidence.traced) item.introduced = true;
  if (evidence.traced) NextHelp(course, trial, evidence.good, item);
  if (!evidence.traced && trial.kind != StepKind::kDemonstrate) {
    CountConfusion(course, trial, pair, progress);
  }
  if (!evidence.fair || (!evidence.traced && !evidence.named)) return;
  if (evidence.named) {
    Schedule(course.mastery, trial, item);
    AddLast(progress.recent, evidence.good, kRecent);
  }
  AddEvidenceAt(course, trial, evidence, pair.first, item);
  if (!evidence.named || !evidence.good || IsTaught(course, pair.first)) return;
  for (const std::string& part : PartsOf(course, progress, pair.first)) {
    ItemProgress& letter = progress.items[part];
    if (letter.introduced && IsTaught(course, part)) {
      AddEvidenceAt(course, trial, evidence, part, letter);
    }
  }
}

}  // namespace

Progress Learn(const Course& course, Progress progress, const Trial& trial) {
  progress.last = std::max(progress.last, trial.time);
  if (StepAt(course, trial.lesson, trial.step) != nullptr) {
    const bool elsewhere = progress.lesson != trial.lesson || progress.step != trial.step;
    const bool arrival = trial.item.empty() && !trial.right;
    if (elsewhere || arrival) MoveTo(progress, trial.lesson, trial.step);
    if (arrival) progress.left_open = false;
    if (trial.item.empty() && trial.right) {
      EndStep(course, progress);
      return progress;
    }
  }
  if (trial.item.empty()) return progress;
  ++progress.trials_in_step;
  const auto known = progress.items.find(trial.item);
  const std::size_t before = known != progress.items.end() ? known->second.size_step : 0;
  LearnItem(course, trial, progress);
  const auto practised = std::find(progress.practise.begin(), progress.practise.end(), trial.item);
  if (practised == progress.practise.end()) return progress;
  const ItemProgress& now = progress.items[trial.item];
  if (now.sure || now.size_step > before) progress.practise.erase(practised);
  return progress;
}

Progress LearnAll(const Course& course, const std::vector<Trial>& trials) {
  Progress progress;
  for (const Trial& trial : trials) progress = Learn(course, std::move(progress), trial);
  return progress;
}

}  // namespace moontrace
