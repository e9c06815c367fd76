#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/course/course.h"
#include "textures/fonts/script.h"

namespace moontrace {

/// Collects what is wrong with a course, each fault at a key of one of its files.
class CourseFaults {
 public:
  explicit CourseFaults(const Course& course) : course_(course) {}
  /// At a key of the course's file or of a lesson's; at the file as a whole where the key is not in
  /// it.
  void Add(const std::string& key, std::string what);
  void Add(const Lesson& lesson, const std::string& key, std::string what);
  std::vector<CourseFault> Take() { return std::move(faults_); }

 private:
  const Course& course_;
  std::vector<CourseFault> faults_;
};

/// Looks at the items and texts of lessons, in the order in which a learner comes to them: each has
/// a form in its script and is taught by then. Pages of another script than the course's are for
/// skills before letters: what stands there need not be taught.
class LessonCheck {
 public:
  LessonCheck(const Course& course, CourseFaults& faults);

  /// Checks the next lesson. In one that is never `reached` nothing has to be taught before.
  void Check(const Lesson& lesson, bool reached);

 private:
  const Script* ScriptOf(const Lesson& lesson);
  bool KnowsGrade(const Lesson& lesson, const Script& script);
  void NoteTeachers(const Lesson& lesson);
  void CheckTwice(const Lesson& lesson);
  void CheckShown(const Lesson& lesson);
  void CheckText(const Lesson& lesson, const Script& script, const std::string& key,
                 std::string_view text, bool must_be_taught);
  /// `script`: null where the mates need not be taught.
  void CheckPick(const Lesson& lesson, const Step& step, std::size_t index, const Script* script);

  const Course& course_;
  CourseFaults& faults_;
  std::map<std::string, std::optional<Script>> scripts_;
  std::set<std::string> broken_grades_;           ///< ids of lessons, reported once
  std::map<std::string, std::string> teachers_;   ///< sign -> lesson that teaches it
  std::map<std::string, std::string> taught_in_;  ///< item, in small letters -> lesson
  std::set<std::string> taught_;                  ///< signs, so far
};

}  // namespace moontrace
