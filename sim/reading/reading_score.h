#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace moontrace {

/// What stands on a page or was read, one thing after the other: a sign by its number, or one of
/// these.
inline constexpr int kSpaceMark = -1;
inline constexpr int kLineEndMark = -2;
inline constexpr int kUnknownMark = -3;

/// How a reading compares with what stood there, by a cheapest row of edits (Levenshtein 1966, all
/// costs 1; of equally cheap rows one that keeps most).
struct ReadingScore {
  std::size_t right = 0;   ///< read as they stood, spaces and line ends included
  std::size_t wrong = 0;   ///< read as something else
  std::size_t missed = 0;  ///< stood there and were not read
  std::size_t extra = 0;   ///< were read and did not stand there
  std::size_t signs = 0;   ///< that stood there, without spaces and line ends
  std::size_t signs_right = 0;
  /// What stood there and what was read instead, how often.
  std::map<std::pair<int, int>, std::size_t> confusions;
  ReadingScore& operator+=(const ReadingScore& other);
};

/// Time and memory grow with the product of the lengths.
ReadingScore Compare(const std::vector<int>& truth, const std::vector<int>& read);

}  // namespace moontrace
