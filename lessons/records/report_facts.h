#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/course/trial.h"
#include "lessons/progress/progress.h"

namespace moontrace {

/// What trials of one kind add up to. Means are over what was done: answers over answers.
struct TrialSums {
  std::size_t trials = 0;
  std::size_t answers = 0, right = 0;     ///< to "what is it?", of one item
  std::size_t letters = 0;                ///< of what was named right in a known time
  double latency = 0;                     ///< that this took [s]
  std::size_t traces = 0, good = 0;       ///< good by the course's rule
  double coverage = 0, error_widths = 0;  ///< sums over the traces
  std::size_t traced_letters = 0;
  double duration = 0;  ///< of the traces [s]

  double NamedRight() const;        ///< share; 0 without answers
  double MeanCoverage() const;      ///< 0-1
  double MeanErrorWidths() const;   ///< [groove widths]
  double LettersPerSecond() const;  ///< named right, at the learner's own pace
  double TracedPerSecond() const;
};

/// How a learner does with one item, by unguided and unscaled trials only.
struct ItemFact {
  std::string item;
  double size = 0;  ///< of sure items: smallest at which it was sure; else present size [m]
  bool mastered = false;
  std::size_t answers = 0, right = 0;  ///< of its last 10
  std::size_t traces = 0, good = 0;    ///< likewise
  std::string taken_for;               ///< most often; empty: nothing
  int taken = 0;                       ///< so many times
  double Weakness() const;             ///< 0-1, the greater the sooner to be practised
};

struct ConfusionFact {
  std::string shown, said;
  int times = 0;
};

/// A day on which something was done, where the user lives.
struct DayFact {
  std::string day;  ///< "2026-11-21"
  TrialSums alone;  ///< unguided and unscaled
  TrialSums guided;
  double smallest = 0;  ///< letters at which anything was named right, [m]; 0: none
};

/// All facts of a report, before words. Trials without an item (marks of steps and lessons) count
/// nowhere; scaled ones count in `scaled` only.
struct ReportFacts {
  std::vector<ItemFact> sure;      ///< at any size; small sizes first, then in the course's order
  std::vector<ItemFact> practise;  ///< with a fault, at most three, the weakest first
  std::size_t items = 0;           ///< that the course teaches
  std::size_t mastered = 0;        ///< of the signs that the course teaches
  double size_reached = 0;         ///< smallest at which anything is sure [m]; 0: none
  std::size_t lessons_done = 0;
  TrialSums alone, guided;
  std::size_t scaled = 0, simulated = 0;
  std::vector<ConfusionFact> confusions;  ///< most frequent first
  /// Shown -> answered -> times, right ones too; unguided, unscaled answers of one item.
  std::map<std::string, std::map<std::string, int>> matrix;
  std::vector<DayFact> days;  ///< in the order in which they first came
};

/// `trials`: of this course, in the order in which they were added.
ReportFacts FactsOf(const Course& course, const std::vector<Trial>& trials);

/// The day of a Unix time [s], where the user lives: "2026-11-21".
std::string DayOf(std::int64_t time);

}  // namespace moontrace
