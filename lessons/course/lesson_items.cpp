#include "lessons/course/lesson_items.h"

#include <algorithm>
#include <charconv>

namespace moontrace {

namespace {

bool Contains(const std::vector<std::string>& items, std::string_view item) {
  return std::find(items.begin(), items.end(), item) != items.end();
}

bool HasItems(StepKind kind) { return kind != StepKind::kExplore && kind != StepKind::kRead; }

bool Asks(const Lesson& lesson, const Step& step, std::string_view item) {
  return HasItems(step.kind) && Contains(step.items.empty() ? lesson.items : step.items, item);
}

}  // namespace

std::size_t LessonsInOrder(const Course& course) {
  return static_cast<std::size_t>(
      std::count_if(course.lessons.begin(), course.lessons.end(),
                    [](const Lesson& lesson) { return !lesson.optional; }));
}

std::optional<std::size_t> LessonIndex(const Course& course, std::string_view id) {
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    if (course.lessons[i].id == id) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> LessonNamed(const Course& course, std::string_view given) {
  std::size_t number = 0;
  const char* const last = given.data() + given.size();
  const auto [end, error] = std::from_chars(given.data(), last, number);
  // a number that is written "04" is an id's
  if (error == std::errc() && end == last && given.front() != '0') {
    if (number > course.lessons.size()) return std::nullopt;
    return number - 1;
  }
  if (const auto index = LessonIndex(course, given); index || given.empty()) return index;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    const std::string_view id = course.lessons[i].id;
    const std::size_t dash = id.find('-');
    const bool ends = dash != std::string_view::npos && id.substr(dash + 1) == given;
    if (!ends && id.substr(0, given.size()) != given) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

const Step* StepAt(const Course& course, std::string_view lesson, std::size_t step) {
  const auto index = LessonIndex(course, lesson);
  if (!index || step >= course.lessons[*index].steps.size()) return nullptr;
  return &course.lessons[*index].steps[step];
}

std::vector<std::string> ItemsOf(const Lesson& lesson, const Step& step) {
  std::vector<std::string> items;
  if (!HasItems(step.kind)) return items;
  for (const std::string& item : step.items.empty() ? lesson.items : step.items) {
    if (!item.empty() && !Contains(items, item)) items.push_back(item);
  }
  return items;
}

bool IsDrill(StepKind kind) { return kind == StepKind::kTrace || kind == StepKind::kRecognise; }

bool HasItem(const Course& course, std::string_view item) {
  return HomeOf(course, item) != nullptr;
}

bool IsTaught(const Course& course, std::string_view item) {
  return std::any_of(course.lessons.begin(), course.lessons.end(),
                     [item](const Lesson& lesson) { return Contains(lesson.items, item); });
}

std::set<std::string> AllItems(const Course& course) {
  std::set<std::string> items;
  for (const Lesson& lesson : course.lessons) {
    items.insert(lesson.items.begin(), lesson.items.end());
    for (const Step& step : lesson.steps) {
      if (HasItems(step.kind)) items.insert(step.items.begin(), step.items.end());
    }
  }
  items.erase("");
  return items;
}

Practice PracticeOf(const Course& course, std::string_view item) {
  Practice at_ladder, anywhere;
  for (const Lesson& lesson : course.lessons) {
    for (const Step& step : lesson.steps) {
      if (!Asks(lesson, step, item)) continue;
      const bool traced = step.kind == StepKind::kTrace;
      const bool named = (step.kind == StepKind::kRecognise || step.kind == StepKind::kTest) &&
                         step.question == Question::kName;
      for (Practice* practice : {&at_ladder, &anywhere}) {
        if (practice == &at_ladder && (step.size || step.kind == StepKind::kTest)) continue;
        practice->traced = practice->traced || traced;
        practice->named = practice->named || named;
      }
    }
  }
  return at_ladder.traced || at_ladder.named ? at_ladder : anywhere;
}

const Lesson* HomeOf(const Course& course, std::string_view item) {
  if (item.empty()) return nullptr;
  for (const Lesson& lesson : course.lessons) {
    if (Contains(lesson.items, item)) return &lesson;
  }
  for (const Lesson& lesson : course.lessons) {
    for (const Step& step : lesson.steps) {
      if (Asks(lesson, step, item)) return &lesson;
    }
  }
  return nullptr;
}

std::string HintOf(const Course& course, const Lesson* lesson, std::string_view item) {
  const std::string key(item);
  if (lesson != nullptr && lesson->hints.count(key) > 0) return lesson->hints.at(key);
  for (const Lesson& other : course.lessons) {
    const auto hint = other.hints.find(key);
    if (hint != other.hints.end()) return hint->second;
  }
  return {};
}

bool EndSizesAt(Course& course, double smallest) {
  const double least = smallest * 0.999;  // the same size, but for rounding
  bool changed = false;
  while (course.sizes.size() > 1 && course.sizes.back() < least) {
    course.sizes.pop_back();
    changed = true;
  }
  const double end = course.sizes.empty() ? smallest : course.sizes.back();
  for (Lesson& lesson : course.lessons) {
    for (Step& step : lesson.steps) {
      if (!step.size || *step.size >= least) continue;
      changed = changed || end > *step.size;
      step.size = std::max(end, *step.size);
    }
  }
  return changed;
}

ItemPair PairOf(std::string_view item) {
  const auto feed = item.find('\n');
  if (feed == std::string_view::npos) return {std::string(item), {}};
  return {std::string(item.substr(0, feed)), std::string(item.substr(feed + 1))};
}

}  // namespace moontrace
