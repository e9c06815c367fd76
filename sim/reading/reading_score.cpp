#include "sim/reading/reading_score.h"

#include <algorithm>
#include <cstdint>

namespace moontrace {

ReadingScore& ReadingScore::operator+=(const ReadingScore& other) {
  right += other.right;
  wrong += other.wrong;
  missed += other.missed;
  extra += other.extra;
  signs += other.signs;
  signs_right += other.signs_right;
  for (const auto& [pair, count] : other.confusions) confusions[pair] += count;
  return *this;
}

ReadingScore Compare(const std::vector<int>& truth, const std::vector<int>& read) {
  const std::size_t n = truth.size(), m = read.size();
  std::vector<std::uint32_t> cost((n + 1) * (m + 1));
  const auto at = [&cost, m](std::size_t i, std::size_t j) -> std::uint32_t& {
    return cost[i * (m + 1) + j];
  };
  for (std::size_t i = 0; i <= n; ++i) at(i, 0) = static_cast<std::uint32_t>(i);
  for (std::size_t j = 0; j <= m; ++j) at(0, j) = static_cast<std::uint32_t>(j);
  for (std::size_t i = 1; i <= n; ++i) {
    for (std::size_t j = 1; j <= m; ++j) {
      const std::uint32_t changed = at(i - 1, j - 1) + (truth[i - 1] == read[j - 1] ? 0 : 1);
      at(i, j) = std::min({changed, at(i - 1, j) + 1, at(i, j - 1) + 1});
    }
  }
  ReadingScore score;
  for (const int mark : truth) score.signs += mark >= 0 ? 1 : 0;
  std::size_t i = n, j = m;
  while (i > 0 || j > 0) {
    const bool both = i > 0 && j > 0;
    if (both && truth[i - 1] == read[j - 1] && at(i, j) == at(i - 1, j - 1)) {
      ++score.right;
      if (truth[i - 1] >= 0) ++score.signs_right;
      --i, --j;
    } else if (both && at(i, j) == at(i - 1, j - 1) + 1) {
      ++score.wrong;
      ++score.confusions[{truth[i - 1], read[j - 1]}];
      --i, --j;
    } else if (i > 0 && at(i, j) == at(i - 1, j) + 1) {
      ++score.missed;
      --i;
    } else {
      ++score.extra;
      --j;
    }
  }
  return score;
}

}  // namespace moontrace
