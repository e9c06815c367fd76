#include "lessons/progress/item_choice.h"

#include <algorithm>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/fsrs.h"
#include "lessons/progress/lesson_path.h"
#include "lessons/progress/mastery.h"

namespace moontrace {

namespace {

constexpr double kDay = 86400;  ///< [s]

bool Contains(const std::vector<std::string>& items, const std::string& item) {
  return std::find(items.begin(), items.end(), item) != items.end();
}

ItemProgress ProgressOf(const Progress& progress, const std::string& item) {
  const auto found = progress.items.find(item);
  return found != progress.items.end() ? found->second : ItemProgress{};
}

/// Items that can be asked along with the new ones: each is named somewhere in the course, and was
/// past the first size before.
std::vector<std::string> KnownItems(const Course& course, const Progress& progress,
                                    const std::vector<std::string>& without) {
  std::vector<std::string> known;
  for (const auto& [text, item] : progress.items) {
    if (item.introduced && PastFirstSize(item) && !Contains(without, text) &&
        HasItem(course, text) && PracticeOf(course, text).named) {
      known.push_back(text);
    }
  }
  return known;
}

/// Items of the step that are there to be asked, in its order.
std::vector<std::string> Entered(const Progress& progress, const std::vector<std::string>& open,
                                 bool have_known) {
  std::vector<std::string> entered;
  int fresh = 0;
  for (const std::string& text : open) {
    const bool enough = entered.size() >= 2 || (have_known && !entered.empty());
    if (fresh >= 2 || (fresh == 1 && enough)) break;
    entered.push_back(text);
    if (!PastFirstSize(ProgressOf(progress, text))) ++fresh;
  }
  return entered;
}

/// One of them by weight, `last` only where there is no other; they are not empty.
std::string Weighted(const Progress& progress, std::vector<std::string> items,
                     const std::string& last, std::uint64_t& random) {
  if (items.size() > 1) items.erase(std::remove(items.begin(), items.end(), last), items.end());
  double sum = 0;
  for (const std::string& text : items) sum += WeightOf(ProgressOf(progress, text));
  double at = NextShare(random) * sum;
  for (const std::string& text : items) {
    at -= WeightOf(ProgressOf(progress, text));
    if (at < 0) return text;
  }
  return items.back();
}

double ShareOfKnown(const MasteryRule& rule, const Progress& progress) {
  const double share = std::clamp(rule.known, 0.0, 1.0);
  if (progress.recent.empty()) return share;
  const auto right = std::count(progress.recent.begin(), progress.recent.end(), true);
  const bool hard =
      static_cast<double>(right) < rule.target * static_cast<double>(progress.recent.size());
  return hard ? std::min(1.0, 2 * share) : share;
}

bool IsNew(const ItemProgress& item, const ItemChooser& chooser, const std::string& text) {
  return !item.introduced && !Contains(chooser.named, text);
}

/// What is done with an item where names are asked; `by_ladder`: at its own size until it is sure.
StepKind TaskOf(const Course& course, const Progress& progress, const ItemChooser& chooser,
                bool by_ladder, const std::string& text) {
  const ItemProgress item = ProgressOf(progress, text);
  if (IsNew(item, chooser, text)) return StepKind::kDemonstrate;
  if (by_ladder && TracesCount(PracticeOf(course, text), item) &&
      !TracedEnough(course.mastery, item)) {
    return StepKind::kTrace;
  }
  return StepKind::kRecognise;
}

NextItem ChooseToRecognise(const Course& course, const Progress& progress, const Step& step,
                           const std::vector<std::string>& open, ItemChooser& chooser) {
  const bool practice = step.kind == StepKind::kTest;
  const bool by_ladder = practice || (!step.size && step.question == Question::kName);
  if (by_ladder && chooser.last_traced && Contains(open, chooser.last)) {
    const StepKind task = TaskOf(course, progress, chooser, by_ladder, chooser.last);
    if (task != StepKind::kRecognise) return {chooser.last, task};
  }
  std::vector<std::string> known;
  if (step.question == Question::kName) known = KnownItems(course, progress, open);
  known.erase(
      std::remove_if(known.begin(), known.end(),
                     [&](const std::string& text) { return Contains(chooser.skipped, text); }),
      known.end());
  const std::vector<std::string> there = by_ladder ? Entered(progress, open, !known.empty()) : open;
  if (!chooser.queue.empty() && chooser.queue.front() != chooser.last) {
    const std::string text = chooser.queue.front();
    chooser.queue.erase(chooser.queue.begin());
    if (Contains(there, text)) return {text, TaskOf(course, progress, chooser, by_ladder, text)};
    if (Contains(known, text)) return {text, StepKind::kRecognise};
  }
  const bool only_last = there.size() == 1 && there.front() == chooser.last;
  const double share = only_last ? 1 : ShareOfKnown(course.mastery, progress);
  if (!known.empty() && NextShare(chooser.random) < share) {
    return {Weighted(progress, known, chooser.last, chooser.random), StepKind::kRecognise};
  }
  const std::string text = Weighted(progress, there, chooser.last, chooser.random);
  return {text, TaskOf(course, progress, chooser, by_ladder, text)};
}

}  // namespace

std::uint64_t NextRandom(std::uint64_t& random) {
  random += 0x9E3779B97F4A7C15u;
  std::uint64_t z = random;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

double NextShare(std::uint64_t& random) {
  return static_cast<double>(NextRandom(random) >> 11) * 0x1p-53;
}

std::optional<NextItem> ChooseItem(const Course& course, const Progress& progress,
                                   ItemChooser& chooser) {
  const Step* step = StepAt(course, progress.lesson, progress.step);
  std::vector<std::string> open;
  const bool practice = !progress.practise.empty();
  for (std::string& text :
       practice ? std::vector<std::string>(progress.practise) : Unfinished(course, progress)) {
    if (!Contains(chooser.skipped, text)) open.push_back(std::move(text));
  }
  if (step == nullptr || open.empty()) return std::nullopt;
  if (practice) return ChooseToRecognise(course, progress, *step, open, chooser);
  switch (step->kind) {
    case StepKind::kTest:
      return NextItem{open[NextRandom(chooser.random) % open.size()], StepKind::kTest};
    case StepKind::kRecognise:
      return ChooseToRecognise(course, progress, *step, open, chooser);
    case StepKind::kTrace: {
      const bool fresh = IsNew(ProgressOf(progress, open.front()), chooser, open.front());
      return NextItem{open.front(), fresh ? StepKind::kDemonstrate : StepKind::kTrace};
    }
    case StepKind::kExplore:
    case StepKind::kDemonstrate:
    case StepKind::kRead:
      break;
  }
  return NextItem{open.front(), StepKind::kDemonstrate};
}

double WeightOf(const ItemProgress& item) {
  const auto right = std::count(item.named.begin(), item.named.end(), true);
  return 1 - static_cast<double>(right + 1) / static_cast<double>(item.named.size() + 2);
}

std::vector<std::string> DueItems(const Course& course, const Progress& progress,
                                  std::int64_t time) {
  struct Due {
    double recall = 0;
    std::string text;
  };
  const Step* step = StepAt(course, progress.lesson, progress.step);
  const bool test = step != nullptr && step->kind == StepKind::kTest;
  const std::vector<std::string> tested =
      test ? Unfinished(course, progress) : std::vector<std::string>{};
  std::vector<Due> due;
  for (const auto& [text, item] : progress.items) {
    if (item.stability <= 0 || item.due > time || !item.introduced) continue;
    if (!HasItem(course, text) || Contains(tested, text)) continue;
    const double days = (static_cast<double>(time) - static_cast<double>(item.reviewed)) / kDay;
    due.push_back(
        {Retrievability({item.stability, item.difficulty, item.short_steps}, days), text});
  }
  std::stable_sort(due.begin(), due.end(),
                   [](const Due& a, const Due& b) { return a.recall < b.recall; });
  const auto most = static_cast<std::size_t>(std::max(0, course.mastery.reviews));
  if (due.size() > most) due.resize(most);
  std::vector<std::string> items;
  items.reserve(due.size());
  for (Due& entry : due) items.push_back(std::move(entry.text));
  return items;
}

}  // namespace moontrace
