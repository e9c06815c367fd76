#include "lessons/progress/lesson_path.h"

#include <algorithm>

#include "lessons/course/lesson_items.h"
#include "lessons/progress/mastery.h"

namespace moontrace {

namespace {

bool IsDone(const Progress& progress, std::string_view lesson) {
  return std::find(progress.done.begin(), progress.done.end(), lesson) != progress.done.end();
}

/// Done, without steps, or beside the course: then there is nothing to do.
bool NeedsNothing(const Progress& progress, const Lesson& lesson) {
  return lesson.steps.empty() || lesson.optional || IsDone(progress, lesson.id);
}

bool NeedsDone(const Course& course, const Progress& progress, const Lesson& lesson) {
  return std::all_of(lesson.needs.begin(), lesson.needs.end(), [&](const std::string& need) {
    const auto index = LessonIndex(course, need);
    return !index || NeedsNothing(progress, course.lessons[*index]);
  });
}

/// Whether `count` results have been given and the share of right ones is reached.
bool EnoughRight(const std::vector<bool>& shown, int count, double share) {
  const auto right = std::count(shown.begin(), shown.end(), true);
  return shown.size() >= static_cast<std::size_t>(std::max(1, count)) &&
         static_cast<double>(right) >= share * static_cast<double>(shown.size());
}

bool TraceFinished(const Course& course, const Step& step, std::string_view text,
                   const StepItem& here, const ItemProgress& item) {
  const MasteryRule& rule = course.mastery;
  if (step.size) return EnoughRight(here.traced, rule.traces, 1);
  if (!PracticeOf(course, text).named) return Mastered(course, item);
  return item.size_step > 0 || TracedEnough(rule, item);
}

bool RecogniseFinished(const Course& course, const Step& step, std::string_view text,
                       const StepItem& here, const ItemProgress& item) {
  const MasteryRule& rule = course.mastery;
  if (step.question == Question::kName && !IsTaught(course, text)) {
    const auto count = static_cast<std::size_t>(std::max(1, rule.words));
    return here.named.size() >= count &&
           std::all_of(here.named.end() - static_cast<std::ptrdiff_t>(count), here.named.end(),
                       [](bool right) { return right; });
  }
  if (step.size || step.question != Question::kName) {
    return EnoughRight(here.named, rule.attempts, rule.recognised);
  }
  return SureForStep(course, step, item);
}

/// Prepares the test once more, after practice of what was named wrong.
void RepeatTest(const Step& step, Progress& progress) {
  progress.practise.clear();
  for (const auto& [text, item] : progress.here) {
    const bool wrong = !item.named.empty() && !item.named.front();
    if (wrong && step.question == Question::kName) progress.practise.push_back(text);
  }
  progress.here.clear();
  progress.trials_in_step = 0;
}

/// Goes on after the last step of a lesson.
void EndLesson(const Course& course, const Lesson& lesson, Progress& progress) {
  if (!progress.left_open && !IsDone(progress, lesson.id)) progress.done.push_back(lesson.id);
  const auto next = LessonAfter(course, progress, lesson.id);
  if (next) {
    MoveTo(progress, course.lessons[*next].id, 0);
  } else {
    MoveTo(progress, lesson.id, lesson.steps.size());
  }
  progress.left_open = false;
}

}  // namespace

bool ItemFinished(const Course& course, const Progress& progress, const Step& step,
                  std::string_view text) {
  const auto here = progress.here.find(std::string(text));
  if (here == progress.here.end() || here->second.trials == 0) return false;
  const auto found = progress.items.find(std::string(text));
  const ItemProgress item = found != progress.items.end() ? found->second : ItemProgress{};
  switch (step.kind) {
    case StepKind::kTrace:
      return TraceFinished(course, step, text, here->second, item);
    case StepKind::kRecognise:
      return RecogniseFinished(course, step, text, here->second, item);
    case StepKind::kTest:
      return !here->second.named.empty();
    case StepKind::kExplore:
    case StepKind::kDemonstrate:
    case StepKind::kRead:
      break;
  }
  return true;
}

std::vector<std::string> Unfinished(const Course& course, const Progress& progress) {
  std::vector<std::string> items;
  const auto lesson = LessonIndex(course, progress.lesson);
  const Step* step = StepAt(course, progress.lesson, progress.step);
  if (!lesson || step == nullptr) return items;
  for (std::string& item : ItemsOf(course.lessons[*lesson], *step)) {
    if (!ItemFinished(course, progress, *step, item)) items.push_back(std::move(item));
  }
  return items;
}

TestScore ScoreOf(const Progress& progress) {
  TestScore score;
  for (const auto& [text, item] : progress.here) {
    if (item.named.empty()) continue;
    ++score.asked;
    score.right += item.named.front() ? 1 : 0;
  }
  return score;
}

bool TestPassed(const Course& course, const Progress& progress) {
  const TestScore score = ScoreOf(progress);
  return Unfinished(course, progress).empty() &&
         score.right >= course.mastery.recognised * score.asked;
}

bool CourseDone(const Course& course, const Progress& progress) {
  return std::all_of(course.lessons.begin(), course.lessons.end(),
                     [&](const Lesson& lesson) { return NeedsNothing(progress, lesson); });
}

std::optional<std::size_t> LessonAfter(const Course& course, const Progress& progress,
                                       std::string_view lesson) {
  const auto here = LessonIndex(course, lesson);
  const std::size_t after = here ? *here + 1 : 0, count = course.lessons.size();
  for (const auto& [from, to] : {std::pair(after, count), std::pair(std::size_t{0}, count)}) {
    std::optional<std::size_t> open;
    for (std::size_t i = from; i < to; ++i) {
      if (NeedsNothing(progress, course.lessons[i])) continue;
      if (NeedsDone(course, progress, course.lessons[i])) return i;
      if (!open) open = i;
    }
    if (open) return open;
  }
  return std::nullopt;
}

std::optional<std::size_t> NextInOrder(const Course& course, const Progress& progress) {
  const auto here = LessonIndex(course, progress.lesson);
  if (here && course.lessons[*here].optional) return LessonAfter(course, progress, progress.lesson);
  for (std::size_t i = here ? *here + 1 : 0; i < course.lessons.size(); ++i) {
    if (!course.lessons[i].optional) return i;
  }
  return std::nullopt;
}

void MoveTo(Progress& progress, std::string_view lesson, std::size_t step) {
  if (progress.lesson != lesson) progress.left_open = false;
  progress.lesson = lesson;
  progress.step = step;
  progress.trials_in_step = 0;
  progress.here.clear();
  progress.practise.clear();
}

void EndStep(const Course& course, Progress& progress) {
  const auto index = LessonIndex(course, progress.lesson);
  const Step* step = StepAt(course, progress.lesson, progress.step);
  if (!index || step == nullptr) return;
  const Lesson& lesson = course.lessons[*index];
  const bool all = Unfinished(course, progress).empty();
  const bool failed = step->kind == StepKind::kTest && !TestPassed(course, progress);
  if (failed && all) return RepeatTest(*step, progress);
  if (failed || (IsDrill(step->kind) && !all)) progress.left_open = true;
  if (progress.step + 1 < lesson.steps.size()) {
    MoveTo(progress, lesson.id, progress.step + 1);
  } else {
    EndLesson(course, lesson, progress);
  }
}

}  // namespace moontrace
