#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lessons/course.h"
#include "lessons/trial.h"

namespace moontrace {

/// What is known of a learner and one item, told from unguided trials only.
struct ItemProgress {
  std::size_t size_step = 0;      ///< index into Course::sizes at which it is worked on
  std::vector<bool> named;        ///< last answers at this size, newest at the end
  std::vector<double> coverages;  ///< last traces at this size
  std::vector<double> errors;     ///< the same [groove widths]
  int failures = 0;               ///< in a row
  int trials = 0;                 ///< of all kinds and sizes
  double help = 0;                ///< of the next guided trial, 0-10
  bool introduced = false;
  bool sure = false;      ///< at its present size
  bool mastered = false;  ///< sure at standard size once
  /// FSRS-6 memory (fsrs.h); stability 0: never reviewed.
  double stability = 0, difficulty = 0;
  int review_steps = 0;                ///< Memory::steps: reviews of minutes before days count
  std::int64_t reviewed = 0, due = 0;  ///< Unix time [s]
};

/// What is known of a learner in one course: told from the rows of the records, one by one.
struct Progress {
  std::map<std::string, ItemProgress> items;
  std::map<std::string, std::map<std::string, int>> confusions;  ///< shown -> said -> times
  std::vector<std::string> done;  ///< lessons, in the order they were done
  std::string lesson;             ///< where the learner is; empty: not begun
  std::size_t step = 0;
  std::size_t trials_in_step = 0;
  std::int64_t last = 0;  ///< newest trial, Unix time [s]
};

/// Progress after one more trial; pure. Trials that are guided, scaled or of another course's items
/// teach nothing but where the learner is.
Progress Learn(const Course& course, Progress progress, const Trial& trial);

}  // namespace moontrace
