#pragma once

#include <vector>

#include "lessons/course/course.h"
#include "lessons/course/trial.h"
#include "lessons/progress/progress.h"

namespace moontrace {

/// Progress after one more trial: a pure function, and the only one that changes progress, so that
/// the same trials always give the same progress, bit by bit.
///
/// How a learner goes through a course, so that a person can finish it:
///
/// - An item is sure at a size by `traces` traces and `attempts` answers, unguided and unscaled, of
///   just that size (mastery.h). Only what the course practises with it is asked: shapes that are
///   followed but never named need no names, words that are read need no traces. Then it goes one
///   size down and is asked anew; after `failures` bad ones in a row it goes one size up. Answers
///   to kPick and kSame can be guessed half the time: they end their step and count confusions, but
///   are no evidence.
/// - A step kTrace asks for the traces at the present size only, so that a new letter is soon asked
///   for; a step kRecognise brings all its items down to standard size, tracing each anew at a new
///   size (lesson_path.h). A perfect learner needs `traces` x `probe_every` traces at the first
///   size, then per item (traces + attempts) trials a size: with five sizes about 40 trials a
///   letter, some ten minutes.
/// - A word begins at the size of its weakest letter: at standard size when all are mastered.
/// - A trial without an item is a mark: the step has ended (right), or was come to (not right).
///
/// A guided or scaled trial only decides where the learner is and how much help comes next
/// (fading.h); one of an item missing from the course, only where. Numbers that are not finite
/// count as bad. Each answer to kName rates the item for FSRS: wrong Again, slower than `slow`
/// Hard, faster than `quick` Easy (once a day), otherwise Good.
Progress Learn(const Course& course, Progress progress, const Trial& trial);

/// Progress after all trials of a learner, in order of time.
Progress LearnAll(const Course& course, const std::vector<Trial>& trials);

}  // namespace moontrace
