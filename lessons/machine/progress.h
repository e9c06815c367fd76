#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/course/trial.h"

namespace moontrace {

/// What is known of a learner and one item. Evidence is of unguided trials only; guided ones tell
/// how much help comes next.
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
  int review_steps = 0;                ///< Memory::steps: reviews of minutes before days count
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

/// What is known of a learner in one course: told from the rows of the records, one by one.
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

/// Progress after one more trial; pure, and the only way in which progress changes: told again from
/// the records it is what it was, bit by bit.
///
/// How a course is gone through, so that a person can finish it:
///
/// - An item is sure at a size by `traces` traces and `attempts` answers, unguided and unscaled, of
///   just that size (mastery.h). Only what the course practises with it is asked: shapes that are
///   followed but never named need no names, words that are read need no traces. Then it goes one
///   size down and is asked anew; after `failures` bad ones in a row it goes one size up. Answers
///   to kPick and kSame can be guessed half the time: they end their step and count confusions, but
///   are no evidence.
/// - A step kTrace asks for the traces at the present size only, so that a new letter is soon asked
///   for; a step kRecognise brings all its items down to standard size, tracing each anew at a new
///   size (lesson_way.h). A perfect learner needs `traces` x `probe_every` traces at the first
///   size, then per item (traces + attempts) trials a size: with five sizes about 40 trials a
///   letter, some ten minutes.
/// - A word begins at the size of its weakest letter: at standard size when all are mastered.
/// - A trial without an item is a mark: the step has ended (right), or was come to (not right).
///
/// Trials that are guided or scaled teach nothing but where the learner is and how much help comes
/// next (fading.h); those of items that the course has not, nothing but where. Numbers that are not
/// finite count as bad. Each answer to kName rates the item for FSRS: wrong Again, slower than
/// `slow` Hard, faster than `quick` Easy (once a day), else Good.
Progress Learn(const Course& course, Progress progress, const Trial& trial);

/// The whole of a learner's records.
Progress LearnAll(const Course& course, const std::vector<Trial>& trials);

}  // namespace moontrace
