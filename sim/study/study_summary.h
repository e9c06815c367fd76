#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/study/study_row.h"

namespace moontrace {

/// One condition in one phase: of each learner the mean over its trials, over those the statistics.
struct StudyCell {
  std::string phase, condition;
  std::size_t learners = 0;
  double mean = 0;       ///< tracing error; of "size-threshold" the size [m]
  double deviation = 0;  ///< standard deviation between learners [m]; 0 of one learner
  /// Of the learners' differences to the same seeds of the reference, the first condition that was
  /// never guided: how much more error, and its 95 % interval [m]. No pairs: this is the reference.
  std::size_t pairs = 0;
  double more = 0, more_low = 0, more_high = 0;
  double low = 0, high = 0;  ///< 95 % confidence interval of the mean, Student's t [m]
};

struct StudyExclusion {
  std::string condition, phase, why;
  std::uint64_t seed = 0;
  std::size_t trial = 0;
};

struct StudySummary {
  std::vector<StudyCell> cells;  ///< phases in their order, conditions in theirs
  std::vector<StudyExclusion> exclusions;
  std::string reference;  ///< condition that the others are compared with; empty: all are guided
  std::size_t trials = 0, learners = 0;
};

StudySummary Summarise(const std::vector<StudyRow>& rows);

/// The value that |t| stays below with 95 % at so many degrees of freedom; infinite at 0.
double StudentT95(std::size_t freedom);

}  // namespace moontrace
