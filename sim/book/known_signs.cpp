#include "sim/book/known_signs.h"

#include <set>

#include "lessons/course/course.h"
#include "lessons/course/lesson_items.h"
#include "lessons/course/taught_signs.h"
#include "lessons/progress/learning.h"
#include "lessons/records/learner_names.h"
#include "lessons/records/records.h"
#include "sim/book/book_messages.h"
#include "sim/console/console.h"
#include "textures/base/error.h"
#include "textures/fonts/script_library.h"

namespace moontrace {
namespace {

/// As it stands in the records; empty: nobody is meant.
std::string LearnerMeant(const Records& records, const std::string& given) {
  const std::vector<LearnerEntry> known = records.Learners();
  if (!given.empty()) return KeptName(given, known);
  const std::vector<std::string> people = PeopleAmong(known);
  return people.size() == 1 ? people.front() : std::string();
}

}  // namespace

std::string KnownSigns(const std::string& records, const std::string& learner) {
  const Records file = Records::OpenToRead(records);
  const std::string name = LearnerMeant(file, learner);
  if (name.empty()) throw UsageError(say::KnowsNothing(""));
  const Course course = LoadCourse("learn-moon");
  const Script script = FindScript(course.script);
  const Progress progress = LearnAll(course, file.Trials(name, course.id));
  std::set<std::string> signs;
  for (const auto& [item, known] : progress.items) {
    if (!known.introduced || !IsTaught(course, item)) continue;
    for (const std::string& sign : SignsOf(item, script, course.grade, nullptr).signs) {
      signs.insert(sign);
    }
  }
  if (signs.empty()) throw InputError(say::KnowsNothing(name));
  std::string only;
  for (const std::string& sign : signs) only += "+" + sign;
  return only;
}

}  // namespace moontrace
