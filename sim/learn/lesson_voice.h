#pragma once

#include <set>
#include <string>

#include "lessons/course/course.h"
#include "lessons/progress/lesson_machine.h"

namespace moontrace {

/// What a lesson says in the course of one session: how a question is answered and how a trace ends
/// is said the first time, and whenever somebody asks again.
class LessonVoice {
 public:
  /// In words; empty: nothing is said. `brief`: outcomes only are wanted; `in_full`: somebody asked
  /// for all of it.
  std::string Words(const Course& course, const lesson_action::Say& sentence, bool brief,
                    bool in_full);

 private:
  std::set<lesson_action::Sentence> said_;
};

}  // namespace moontrace
