#include "sim/study/reading_summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "textures/base/random.h"

namespace moontrace {
namespace {

constexpr std::size_t kDraws = 2000;

/// Its value over all pages, and the interval from ratios of sums over pages drawn anew.
template <typename Over, typename Under>
Estimate Ratio(const std::vector<PageReading>& pages, Over over, Under under) {
  const auto ratio = [](double a, double b) { return b > 0 ? a / b : 0; };
  Random random(pages.size());
  std::vector<double> drawn;
  drawn.reserve(kDraws);
  for (std::size_t i = 0; i <= kDraws; ++i) {
    double a = 0, b = 0;
    for (std::size_t j = 0; j < pages.size(); ++j) {
      const auto any =
          static_cast<std::size_t>(random.Uniform() * static_cast<double>(pages.size()));
      const PageReading& page = pages[i == 0 ? j : any];
      a += over(page);
      b += under(page);
    }
    drawn.push_back(ratio(a, b));
  }
  Estimate estimate{drawn.front(), 0, 0};
  std::sort(drawn.begin() + 1, drawn.end());
  estimate.low = drawn[1 + kDraws / 40];
  estimate.high = drawn[kDraws - kDraws / 40];
  return estimate;
}

/// Wilson's interval of a share of `n`, 95 percent.
Estimate Wilson(double share, double n) {
  constexpr double kZ = 1.959964;
  if (!(n > 0)) return {share, 0, 1};
  const double z = kZ * kZ / n;
  const double half = std::sqrt(z * (share * (1 - share) + z / 4));
  return {share, (share + z / 2 - half) / (1 + z), std::min(1.0, (share + z / 2 + half) / (1 + z))};
}

ReadingStudyCell CellOf(const std::vector<const StudyRow*>& rows) {
  ReadingStudyCell cell;
  cell.condition = rows.front()->condition;
  cell.cell = rows.front()->page->cell;
  std::vector<PageReading> pages;
  for (const StudyRow* row : rows) {
    const PageReading& page = row->page->read;
    pages.push_back(page);
    cell.signs += page.signs;
    cell.wrong += page.wrong;
    cell.missed += page.missed;
    cell.extra += page.extra;
    cell.through += page.through;
    cell.unended += page.ended ? 0 : 1;
  }
  cell.pages = pages.size();
  const auto signs = [](const PageReading& page) { return static_cast<double>(page.signs); };
  cell.right = Ratio(
      pages, [](const PageReading& page) { return static_cast<double>(page.signs_right); }, signs);
  // Where all pages are alike, drawing them anew tells no spread.
  const Estimate least = Wilson(cell.right.value, static_cast<double>(cell.signs));
  cell.right.low = std::min(cell.right.low, least.low);
  cell.right.high = std::max(cell.right.high, least.high);
  cell.seconds = Ratio(
      pages, [](const PageReading& page) { return page.duration; }, signs);
  return cell;
}

}  // namespace

ReadingSummary SummariseReading(const std::vector<StudyRow>& rows) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<const StudyRow*>> by_condition;
  for (const StudyRow& row : rows) {
    if (!row.page) continue;
    std::vector<const StudyRow*>& cell = by_condition[row.condition];
    if (cell.empty()) order.push_back(row.condition);
    cell.push_back(&row);
  }
  ReadingSummary summary;
  for (const std::string& condition : order) {
    std::vector<const StudyRow*>& cell = by_condition[condition];
    std::sort(cell.begin(), cell.end(),
              [](const StudyRow* a, const StudyRow* b) { return a->seed < b->seed; });
    summary.cells.push_back(CellOf(cell));
  }
  for (std::size_t i = 0; i < summary.cells.size(); ++i) {
    const ReadingStudyCell& cell = summary.cells[i];
    const ReadingStudyCell& best = summary.cells[summary.best.value_or(i)];
    const bool surer = cell.right.low > best.right.low;
    const bool quicker =
        cell.right.low == best.right.low && cell.seconds.value < best.seconds.value;
    if (!summary.best || surer || quicker) summary.best = i;
  }
  return summary;
}

}  // namespace moontrace
