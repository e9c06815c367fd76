#include "sim/learn/learn_simulated.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <optional>
#include <set>

#include "lessons/course/lesson_items.h"
#include "lessons/records/records.h"
#include "sim/learn/learn_messages.h"
#include "sim/study/course_run.h"

namespace moontrace {

namespace {

using lesson_action::Sentence;

struct Kept {
  std::optional<Records> records;
  std::string name;
  std::vector<Trial> history;
};

Kept OpenRecords(const LearnSimulatedOptions& options, const Course& course) {
  Kept kept;
  kept.name = options.learner.empty() ? "simulated" : options.learner;
  if (options.records.empty()) return kept;
  kept.records = Records::Open(options.records);
  const std::optional<LearnerEntry> known = kept.records->Find(kept.name);
  if (known && !known->simulated) throw UsageError(say::NotSimulated(kept.name));
  if (!known) {
    LearnerEntry entry;
    entry.pseudonym = kept.name;
    entry.since = std::time(nullptr);
    entry.simulated = true;
    kept.records->AddLearner(entry);
  }
  kept.history = kept.records->Trials(kept.name, course.id);
  return kept;
}

std::string TitleOf(const Course& course, const std::string& id) {
  for (const Lesson& lesson : course.lessons) {
    if (lesson.id == id) return lesson.title;
  }
  return id;
}

void SaySum(const CourseRunResult& result, const Course& course, Console& console) {
  std::size_t mastered = 0, items = 0;
  for (const auto& [text, item] : result.progress.items) {
    if (!IsTaught(course, text)) continue;
    ++items;
    if (item.mastered) ++mastered;
  }
  console.Result(say::SimulatedMastered(mastered, items, course.sizes.back()));
  console.Remark(say::SimulatedProves());
}

}  // namespace

int LearnSimulated(const LearnSimulatedOptions& options, const Course& course, Console& console) {
  Kept kept = OpenRecords(options, course);
  CourseRunSetup setup;
  setup.course = &course;
  setup.learner = options.model.empty() ? ShippedLearner() : LoadLearner(options.model);
  setup.seed = options.seed;
  setup.days = options.days;
  setup.history = kept.history;
  setup.check = [&console] { console.CheckStop(); };
  std::size_t trials = kept.history.size();
  std::set<double, std::greater<>> sizes;
  setup.keep = [&](const Trial& trial) {
    ++trials;
    if (kept.records) kept.records->Add(kept.name, course.id, trial);
    if (!trial.item.empty() && trial.right && !trial.guided()) sizes.insert(trial.size);
  };
  setup.news = [&](const lesson_action::Say& news, int day) {
    if (news.sentence != Sentence::kLessonDone) return;
    console.Happening(say::SimulatedLesson(news.text, day, trials));
    if (!sizes.empty()) console.Happening(say::SimulatedSizes({sizes.begin(), sizes.end()}));
    sizes.clear();
  };
  if (kept.history.empty()) {
    console.Remark(say::SimulatedBegins(course.title, LessonsInOrder(course)));
    if (!kept.records) console.Remark(say::SimulatedKeepsNothing());
  } else {
    console.Remark(say::SimulatedGoesOn(kept.name, kept.history.size()));
  }
  const CourseRunResult result = RunCourse(setup);
  const std::string lesson = TitleOf(course, result.progress.lesson);
  if (result.stuck) {
    SaySum(result, course, console);
    throw WorkFailed(say::SimulatedStuck(lesson, result.item));
  }
  if (result.done) {
    console.Result(say::SimulatedDone(result.days, trials, result.seconds / 3600));
  } else {
    console.Result(say::SimulatedEnded(result.days, lesson));
  }
  SaySum(result, course, console);
  return exit_code::kGood;
}

}  // namespace moontrace
