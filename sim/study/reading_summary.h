#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/study/study_row.h"

namespace moontrace {

/// A value with its 95 percent interval.
struct Estimate {
  double value = 0, low = 0, high = 0;
};

/// One combination of a reading study, over all of its pages.
struct ReadingStudyCell {
  std::string condition;
  ReadingCell cell;
  std::size_t pages = 0, signs = 0;
  std::size_t wrong = 0, missed = 0, extra = 0;  ///< spaces and line ends included
  std::size_t unended = 0;                       ///< pages that the reader came to no end with
  std::size_t through = 0;                       ///< how often the paper gave way under the tip
  /// Signs right of those that stood there. Errors stand together on a page, so the interval is
  /// found by drawing pages anew (percentile bootstrap, 2000 times, Efron 1979); it is no
  /// narrower on either side than Wilson's (1927) for as many independent signs, since pages that
  /// are all alike tell no spread.
  Estimate right;
  Estimate seconds;  ///< per sign, everything counted [s]
};

struct ReadingSummary {
  std::vector<ReadingStudyCell> cells;  ///< in the order of their rows
  /// Of the cell with the highest lower end of `right`, of equals the quickest; none without cells,
  /// or where they are not to be compared.
  std::optional<std::size_t> best;
};

/// Of rows with pages. The same for the same rows, whatever their order within a cell.
ReadingSummary SummariseReading(const std::vector<StudyRow>& rows);

}  // namespace moontrace
