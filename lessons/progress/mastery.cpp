#include "lessons/progress/mastery.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>

#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr double kNoSizes = 0.012;  ///< of a course that names none [m]

std::size_t AtLeastOne(int count) { return static_cast<std::size_t>(std::max(1, count)); }

template <typename T>
void AddLast(std::vector<T>& values, T value, std::size_t most) {
  values.push_back(value);
  if (values.size() > most) values.erase(values.begin(), values.end() - static_cast<long>(most));
}

double Mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

void Forget(ItemProgress& item) {
  item.named.clear();
  item.coverages.clear();
  item.errors.clear();
  item.failures = 0;
  item.sure = false;
}

void StepBack(const Course& course, ItemProgress& item) {
  if (item.size_step == 0) {
    item.introduced = false;
    item.help = std::max(item.help, static_cast<double>(std::clamp(course.fade.start, 0, 10)));
    item.good_run = 0;
  } else {
    --item.size_step;
  }
  Forget(item);
}

/// The longest known item, not the text itself, with which the text goes on at `at`; empty: none.
std::string PartAt(const Progress& progress, const std::string& text, std::size_t at) {
  std::string part;
  for (const auto& [item, known] : progress.items) {
    const bool fits = item.size() > part.size() && item.size() < text.size() &&
                      text.compare(at, item.size(), item) == 0;
    if (fits) part = item;
  }
  return part;
}

/// How the page of an item is written: by the present lesson if its step asks for the item, else by
/// its home; null: not known.
const std::vector<std::string>* SpellingOf(const Course& course, const Progress& progress,
                                           const std::string& item) {
  const auto here = LessonIndex(course, progress.lesson);
  const Step* step = StepAt(course, progress.lesson, progress.step);
  const Lesson* lesson = HomeOf(course, item);
  if (here && step != nullptr) {
    const std::vector<std::string> asked = ItemsOf(course.lessons[*here], *step);
    const bool asks = std::find(asked.begin(), asked.end(), item) != asked.end();
    if (asks) lesson = &course.lessons[*here];
  }
  if (lesson == nullptr) return nullptr;
  const auto found = lesson->spellings.find(item);
  return found != lesson->spellings.end() ? &found->second : nullptr;
}

}  // namespace

double SizeAt(const Course& course, std::size_t size_step) {
  if (course.sizes.empty()) return kNoSizes;
  return course.sizes[std::min(size_step, course.sizes.size() - 1)];
}

std::size_t LastSize(const Course& course) {
  return course.sizes.empty() ? 0 : course.sizes.size() - 1;
}

bool SameSize(double a, double b) { return std::abs(a - b) <= 1e-3 * std::max(a, b); }

bool NamedEnough(const MasteryRule& rule, const ItemProgress& item) {
  const auto right = std::count(item.named.begin(), item.named.end(), true);
  return item.named.size() >= AtLeastOne(rule.attempts) &&
         static_cast<double>(right) >= rule.recognised * static_cast<double>(item.named.size());
}

bool TracedEnough(const MasteryRule& rule, const ItemProgress& item) {
  return item.coverages.size() >= AtLeastOne(rule.traces) &&
         Mean(item.coverages) >= rule.coverage && Mean(item.errors) <= rule.error_widths;
}

bool GoodTrace(const MasteryRule& rule, const Trial& trial) {
  return trial.coverage >= rule.coverage && trial.error_widths >= 0 &&
         trial.error_widths <= rule.error_widths;
}

bool Mastered(const Course& course, const ItemProgress& item) {
  return item.sure && item.size_step >= LastSize(course);
}

bool PastFirstSize(const ItemProgress& item) { return item.sure || item.size_step > 0; }

bool SureForStep(const Course& course, const Step& step, const ItemProgress& item) {
  const int sizes = step.sure_sizes.value_or(course.mastery.sure_sizes);
  return item.size_step >= AtLeastOne(sizes) || Mastered(course, item);
}

bool TracesCount(const Practice& practice, const ItemProgress& item) {
  return practice.traced && (item.size_step == 0 || !practice.named);
}

std::vector<std::string> PartsOf(const Course& course, const Progress& progress,
                                 std::string_view item) {
  if (const auto* spelling = SpellingOf(course, progress, std::string(item))) {
    std::vector<std::string> known;
    std::copy_if(spelling->begin(), spelling->end(), std::back_inserter(known),
                 [&](const std::string& part) { return progress.items.count(part) > 0; });
    return known;
  }
  std::string text(item);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < text.size();) {
    const std::string part = PartAt(progress, text, at);
    at += std::max<std::size_t>(1, part.size());
    const bool is_new = std::find(parts.begin(), parts.end(), part) == parts.end();
    if (!part.empty() && is_new) parts.push_back(part);
  }
  return parts;
}

std::string UnmetSigns(const Course& course, const Progress& progress, std::string_view given) {
  const std::string text = LowerCase(given);
  std::string list;
  std::set<std::string> listed = {" ", "\t", "\n", "\r"};
  for (std::size_t at = 0; at < text.size();) {
    std::size_t met = 0;
    for (const auto& [item, known] : progress.items) {
      const bool fits = known.introduced && text.compare(at, item.size(), item) == 0;
      if (fits) met = std::max(met, item.size());
    }
    std::size_t end = at + std::max<std::size_t>(1, met);
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) ++end;
    const std::string sign = text.substr(at, end - at);
    if (met == 0 && listed.insert(sign).second) {
      list += (list.empty() ? "" : ", ") + std::string(NameOf(course, sign));
    }
    at = end;
  }
  return list;
}

std::size_t FirstSizeOf(const Course& course, const Progress& progress, std::string_view item) {
  if (IsTaught(course, item)) return 0;
  const std::vector<std::string> parts = PartsOf(course, progress, item);
  std::size_t step = parts.empty() ? 0 : LastSize(course);
  for (const std::string& part : parts) step = std::min(step, progress.items.at(part).size_step);
  return step;
}

double AskedSize(const Course& course, const Progress& progress, const Step* step,
                 const ItemPair& items) {
  if (step != nullptr && step->size) return *step->size;
  double size = 0;
  for (const std::string& text : {items.first, items.second}) {
    if (text.empty()) continue;
    const auto found = progress.items.find(text);
    const std::size_t place = found != progress.items.end() ? found->second.size_step
                                                            : FirstSizeOf(course, progress, text);
    size = std::max(size, SizeAt(course, place));
  }
  return size > 0 ? size : SizeAt(course, 0);
}

void AddEvidence(const Course& course, const Practice& practice, const Trial& trial, bool good,
                 ItemProgress& item) {
  const MasteryRule& rule = course.mastery;
  if (trial.kind == StepKind::kTrace) {
    const bool known = std::isfinite(trial.error_widths) && trial.error_widths >= 0;
    AddLast(item.coverages,
            std::isfinite(trial.coverage) ? std::clamp(trial.coverage, 0.0, 1.0) : 0,
            AtLeastOne(rule.traces));
    AddLast(item.errors, known ? std::min(trial.error_widths, 1e6) : 1e6, AtLeastOne(rule.traces));
  } else {
    AddLast(item.named, good, AtLeastOne(rule.attempts));
  }
  item.failures = good ? 0 : item.failures + 1;
  if (item.failures >= std::max(1, rule.failures)) {
    StepBack(course, item);
    return;
  }
  item.sure = (!practice.named || NamedEnough(rule, item)) &&
              (!TracesCount(practice, item) || TracedEnough(rule, item));
  if (!item.sure) return;
  if (item.size_step >= LastSize(course)) {
    item.mastered = true;
    return;
  }
  ++item.size_step;
  Forget(item);
}

}  // namespace moontrace
