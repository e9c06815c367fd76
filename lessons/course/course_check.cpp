#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "lessons/course/course.h"
#include "lessons/course/lesson_check.h"
#include "lessons/course/lesson_order.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

constexpr std::size_t kMostCompared = 2000;

std::string Quoted(std::string_view text) { return fmt::format("'{}'", OneLine(text, 40)); }

std::string DidYouMean(std::string_view word, const std::vector<std::string>& known) {
  // Of very many names the nearest is not sought: it would take too long.
  const std::string nearest =
      known.size() <= kMostCompared ? NearestWord(word, known) : std::string();
  return nearest.empty() ? "leave it out" : fmt::format("did you mean {}?", Quoted(nearest));
}

/// A course none of whose sizes the device renders. Smaller sizes than it renders are no fault
/// where there is a larger one: lessons end at that (EndSizesAt).
void CheckSizes(const Course& course, double smallest, CourseFaults& faults) {
  if (std::isinf(smallest)) {
    faults.Add("sizes_mm[0]", "the device renders letters of no size; choose another device");
    return;
  }
  if (course.sizes.empty() || course.sizes.front() >= smallest) return;
  faults.Add("sizes_mm[0]",
             fmt::format("{:.3g} mm is below the {:.3g} mm that the device renders; make it larger",
                         kMillimetres * course.sizes.front(), kMillimetres * smallest));
}

/// A need that closes a circle: of which lesson, and which of its needs.
using Culprit = std::pair<std::size_t, std::size_t>;

/// Tells a circle once, by its need of a later lesson, which every circle has.
void TellCircle(const Course& course, std::vector<std::size_t> circle, std::set<Culprit>& told,
                CourseFaults& faults) {
  std::size_t at = 0;
  const auto next = [&circle](std::size_t i) { return circle[(i + 1) % circle.size()]; };
  while (next(at) < circle[at]) ++at;
  const Lesson& lesson = course.lessons[circle[at]];
  const std::string& later = course.lessons[next(at)].id;
  const auto need = std::find(lesson.needs.begin(), lesson.needs.end(), later);
  const auto number = static_cast<std::size_t>(need - lesson.needs.begin());
  if (!told.insert({circle[at], number}).second) return;
  std::rotate(circle.begin(), circle.begin() + static_cast<std::ptrdiff_t>(at), circle.end());
  std::string chain;
  for (const std::size_t one : circle) chain += OneLine(course.lessons[one].id, 40) + " needs ";
  faults.Add(lesson, fmt::format("needs[{}]", number),
             fmt::format("unreachable: needs go round in a circle: {}{}; take out {}, which does "
                         "not come before",
                         chain, OneLine(lesson.id, 40), Quoted(later)));
}

/// Why a lesson is never reached. `told`: circles that were.
void CheckNeeds(const Course& course, std::size_t index, const std::vector<std::string>& ids,
                std::set<Culprit>& told, CourseFaults& faults) {
  const Lesson& lesson = course.lessons[index];
  bool unknown = false;
  for (std::size_t i = 0; i < lesson.needs.size(); ++i) {
    const std::string& need = lesson.needs[i];
    if (std::find(ids.begin(), ids.end(), need) != ids.end()) continue;
    unknown = true;
    faults.Add(lesson, fmt::format("needs[{}]", i),
               fmt::format("unreachable: it needs {}, no lesson of the course; {}", Quoted(need),
                           DidYouMean(need, ids)));
  }
  if (unknown) return;
  const std::vector<std::size_t> circle = CircleOf(course, index);
  if (circle.empty()) {
    faults.Add(lesson, "needs", "unreachable: what it needs is unreachable itself; mend that");
    return;
  }
  TellCircle(course, circle, told, faults);
}

/// Names and mates are of items that the course has.
void CheckWords(const Course& course, const std::string& table,
                const std::map<std::string, std::string>& words, bool both, CourseFaults& faults) {
  std::set<std::string> known;
  for (const Lesson& lesson : course.lessons) {
    known.insert(lesson.items.begin(), lesson.items.end());
    for (const Step& step : lesson.steps) known.insert(step.items.begin(), step.items.end());
  }
  const std::vector<std::string> list(known.begin(), known.end());
  for (const auto& [item, word] : words) {
    const std::string key = fmt::format("{}.{}", table, item);
    for (const std::string& one :
         both ? std::vector<std::string>{item, word} : std::vector<std::string>{item}) {
      if (known.count(one) > 0) continue;
      faults.Add(key, fmt::format("{}: {} is no item of any lesson; {}", table, Quoted(one),
                                  DidYouMean(one, list)));
    }
    if (both && item == word) {
      faults.Add(key, fmt::format("{}: {} is its own mate; name another", table, Quoted(item)));
    }
  }
}

}  // namespace

std::vector<CourseFault> CheckReach(const Course& course) {
  CourseFaults faults(course);
  std::vector<std::string> ids;
  ids.reserve(course.lessons.size());
  for (const Lesson& lesson : course.lessons) ids.push_back(lesson.id);
  std::set<Culprit> told;
  for (const std::size_t index : OrderOf(course).unreachable) {
    CheckNeeds(course, index, ids, told, faults);
  }
  return faults.Take();
}

std::vector<CourseFault> CheckCourse(const Course& course, double smallest) {
  CourseFaults faults(course);
  CheckSizes(course, smallest, faults);
  CheckWords(course, "names", course.names, false, faults);
  CheckWords(course, "mates", course.mates, true, faults);
  std::vector<std::string> ids;
  for (const Lesson& lesson : course.lessons) {
    ids.push_back(lesson.id);
    if (lesson.steps.empty()) faults.Add(lesson, "", "the lesson has no steps; add [[steps]]");
  }
  const LessonOrder order = OrderOf(course);
  LessonCheck check(course, faults);
  for (const std::size_t index : order.walk) check.Check(course.lessons[index], true);
  std::set<Culprit> told;
  for (const std::size_t index : order.unreachable) {
    CheckNeeds(course, index, ids, told, faults);
    check.Check(course.lessons[index], false);
  }
  return faults.Take();
}

}  // namespace moontrace
