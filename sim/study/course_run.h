#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/course/trial.h"
#include "lessons/progress/lesson_machine.h"
#include "lessons/progress/progress.h"
#include "sim/study/learner_model.h"

namespace moontrace {

/// A simulated learner goes through a course by itself, as a person would: it is shown pages, hears
/// what the lesson says, traces, explores and answers. Each trial runs in the real scene. It gets
/// the lesson machine's actions only, never its state.
struct CourseRunSetup {
  const Course* course = nullptr;  ///< must outlive the run
  LearnerModel learner;
  std::uint64_t seed = 1;
  int days = 0;                    ///< sessions, one a day; 0: until the course is done
  std::int64_t begin = 946684800;  ///< Unix time [s]: 1 January 2000, so that runs are alike
  std::vector<Trial> history;      ///< trials that came before, of the records
  std::size_t step_limit = 2000;   ///< trials in one step after which it is stuck
  std::function<void(const Trial&)> keep;  ///< called with each trial for the records; may be empty
  /// Called with each sentence of the lesson, and the day, from 1; may be empty.
  std::function<void(const lesson_action::Say&, int day)> news;
  std::function<void()> check;  ///< called between trials; may throw to stop
};

struct CourseRunResult {
  bool done = false;       ///< the whole course
  bool stuck = false;      ///< a step would not end
  int days = 0;            ///< that were needed
  std::size_t trials = 0;  ///< kept
  double seconds = 0;      ///< simulated hand's work [s]
  Progress progress;
  std::string item;  ///< worked on last
};

CourseRunResult RunCourse(const CourseRunSetup& setup);

}  // namespace moontrace
