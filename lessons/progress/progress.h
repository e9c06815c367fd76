#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace moontrace {

/// What is known of a learner and one item. Evidence is of unguided trials only; guided ones
/// decide how much help comes next.
struct ItemProgress {
  std::size_t size_step = 0;      ///< index into Course::sizes at which it is worked on
  std::vector<bool> named;        ///< last answers at this size, newest at the end
  std::vector<double> coverages;  ///< last traces at this size
  std::vector<double> errors;     ///< the same [groove widths]
  int failures = 0;               ///< in a row
  int trials = 0;                 ///< of all kinds and sizes
  double help = 0;                ///< of the next guided trial, 0-10
  int good_run = 0;               ///< good traces in a row, of fading (fading.h)
  int guided_run = 0;             ///< guided traces since the last unguided one
  bool introduced = false;        ///< shown by its name, and led along or traced
  bool sure = false;              ///< at its present size
  bool mastered = false;          ///< sure at standard size once
  /// FSRS-6 memory (fsrs.h); stability 0: never reviewed.
  double stability = 0, difficulty = 0;
  int short_steps = 0;                 ///< reviews to come within the session (Memory::steps)
  std::int64_t reviewed = 0, due = 0;  ///< Unix time [s]

  bool operator==(const ItemProgress&) const = default;
};

/// What an item has shown since the step began: by this a step ends that asks for a size of its
/// own, for pairs, or for each item once (kTest).
struct StepItem {
  int trials = 0;            ///< of all kinds
  std::vector<bool> named;   ///< last unguided answers, newest at the end
  std::vector<bool> traced;  ///< last unguided traces: good?

  bool operator==(const StepItem&) const = default;
};

/// What is known of a learner in one course: computed from the trials of the records (learning.h).
struct Progress {
  std::map<std::string, ItemProgress> items;
  std::map<std::string, std::map<std::string, int>> confusions;  ///< shown -> said -> times
  std::vector<std::string> done;  ///< lessons, in the order they were done
  std::string lesson;             ///< where the learner is; empty: not begun
  std::size_t step = 0;
  std::size_t trials_in_step = 0;
  std::map<std::string, StepItem> here;  ///< item -> what it has shown at this step
  /// Of a test that was not passed: what was named wrong, and is not sure again yet.
  std::vector<std::string> practise;
  bool left_open = false;    ///< a step of this lesson was left before its items were finished
  std::vector<bool> recent;  ///< last 20 unguided namings of all items, newest at the end
  std::int64_t last = 0;     ///< newest trial, Unix time [s]

  bool operator==(const Progress&) const = default;
};

}  // namespace moontrace
