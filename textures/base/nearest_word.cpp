#include "textures/base/nearest_word.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "textures/base/text_file.h"

namespace moontrace {
namespace {

std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> above, row(b.size() + 1), next(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      next[j] = std::min({replaced, row[j] + 1, next[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) next[j] = std::min(next[j], above[j - 2] + 1);
    }
    above = row;
    std::swap(row, next);
  }
  return row.back();
}

// Longer words come from broken files, not from slips of the finger; this bounds the time.
constexpr std::size_t kLongestWord = 64;
constexpr std::size_t kBytesAnEdit = 3;

/// The first of those within `longest` bytes that take the fewest edits from a word in small
/// letters, empty if all take more than `most`.
std::string FewestEdits(std::string_view word, const std::vector<std::string>& candidates,
                        std::size_t longest, std::size_t most) {
  std::string nearest;
  std::size_t best = most + 1;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest) continue;
    const std::size_t distance = EditDistance(word, LowerCase(candidate));
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace

std::string NearestWord(std::string_view word, const std::vector<std::string>& candidates) {
  std::string nearest;
  if (word.empty() || word.size() > kLongestWord) return nearest;
  const std::string lower = LowerCase(word);
  for (const std::string& candidate : candidates) {
    if (LowerCase(candidate).compare(0, word.size(), lower) != 0) continue;
    if (nearest.empty() || candidate.size() < nearest.size()) nearest = candidate;
  }
  return nearest.empty() ? FewestEdits(lower, candidates, kLongestWord, word.size() / kBytesAnEdit)
                         : nearest;
}

std::string NearestName(std::string_view word, const std::vector<std::string>& names) {
  if (word.size() > kLongestWord) return {};
  return FewestEdits(LowerCase(word), names, std::string::npos, word.size() / kBytesAnEdit);
}

}  // namespace moontrace
