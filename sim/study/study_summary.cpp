#include "sim/study/study_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace moontrace {
namespace {

struct Sum {
  double sum = 0;
  std::size_t count = 0;
};

std::size_t PlaceOf(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

StudyCell CellOf(const std::map<std::uint64_t, Sum>& learners) {
  StudyCell cell;
  cell.learners = learners.size();
  const auto n = static_cast<double>(cell.learners);
  for (const auto& learner : learners) {
    cell.mean += learner.second.sum / static_cast<double>(learner.second.count) / n;
  }
  double squares = 0;
  for (const auto& learner : learners) {
    const double off = learner.second.sum / static_cast<double>(learner.second.count) - cell.mean;
    squares += off * off;
  }
  if (cell.learners > 1) cell.deviation = std::sqrt(squares / (n - 1));
  const double half =
      cell.learners > 1 ? StudentT95(cell.learners - 1) * cell.deviation / std::sqrt(n) : 0;
  cell.low = cell.mean - half;
  cell.high = cell.mean + half;
  return cell;
}

double MeanOf(const Sum& sum) { return sum.sum / static_cast<double>(sum.count); }

/// The same persons under both conditions: their differences have no share of what sets one person
/// apart from another.
void Compare(StudyCell& cell, const std::map<std::uint64_t, Sum>& learners,
             const std::map<std::uint64_t, Sum>& reference) {
  std::map<std::uint64_t, Sum> differences;
  for (const auto& learner : learners) {
    const auto other = reference.find(learner.first);
    if (other == reference.end()) continue;
    differences[learner.first] = {MeanOf(learner.second) - MeanOf(other->second), 1};
  }
  if (differences.empty()) return;
  const StudyCell difference = CellOf(differences);
  cell.pairs = difference.learners;
  cell.more = difference.mean;
  cell.more_low = difference.low;
  cell.more_high = difference.high;
}

}  // namespace

double StudentT95(std::size_t freedom) {
  // The first ones from the usual table, then the expansion in 1/n (Abramowitz and Stegun 26.7.5),
  // good to 0.001 there.
  constexpr std::array<double, 10> kTable = {12.706, 4.303, 3.182, 2.776, 2.571,
                                             2.447,  2.365, 2.306, 2.262, 2.228};
  if (freedom == 0) return HUGE_VAL;
  if (freedom <= kTable.size()) return kTable[freedom - 1];
  const double z = 1.959964, n = static_cast<double>(freedom);
  const double z3 = z * z * z, z5 = z3 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n);
}

StudySummary Summarise(const std::vector<StudyRow>& rows) {
  StudySummary summary;
  std::vector<std::string> phases, conditions;
  std::map<std::pair<std::size_t, std::size_t>, std::map<std::uint64_t, Sum>> cells;
  std::set<std::pair<std::string, std::uint64_t>> learners;
  std::set<std::string> guided;
  for (const StudyRow& row : rows) {
    ++summary.trials;
    learners.insert({row.condition, row.seed});
    if (row.given.mode != GuidanceMode::kOff) guided.insert(row.condition);
    const std::size_t phase = PlaceOf(phases, row.given.phase);
    const std::size_t condition = PlaceOf(conditions, row.condition);
    if (!row.excluded.empty()) {
      summary.exclusions.push_back(
          {row.condition, row.given.phase, row.excluded, row.seed, row.trial});
      continue;
    }
    Sum& sum = cells[{phase, condition}][row.seed];
    sum.sum += row.given.phase == "size-threshold" ? row.given.size : row.mean_error;
    ++sum.count;
  }
  summary.learners = learners.size();
  std::size_t reference = 0;
  while (reference < conditions.size() && guided.count(conditions[reference]) > 0) ++reference;
  if (reference < conditions.size()) summary.reference = conditions[reference];
  for (const auto& cell : cells) {
    StudyCell made = CellOf(cell.second);
    made.phase = phases[cell.first.first];
    made.condition = conditions[cell.first.second];
    const auto other = cells.find({cell.first.first, reference});
    if (cell.first.second != reference && other != cells.end()) {
      Compare(made, cell.second, other->second);
    }
    summary.cells.push_back(made);
  }
  return summary;
}

}  // namespace moontrace
