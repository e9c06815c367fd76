#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/course/likeness.h"
#include "lessons/course/trial.h"
#include "lessons/progress/progress.h"

namespace moontrace {

/// What was answered, and how much of it right.
struct AnswerSums {
  std::size_t answers = 0, right = 0;
  double Share() const;  ///< right ones; 0 without answers
};

/// What trials of one kind add up to. Means are over what was done: answers over answers.
struct TrialSums {
  std::size_t trials = 0;
  AnswerSums signs, words;      ///< to "what is it?": of a sign that is taught, of anything else
  AnswerSums picked, compared;  ///< "which of two?", "same or different?": half can be guessed
  std::size_t letters = 0;      ///< of what was named right in a known time
  double latency = 0;           ///< that this took [s]
  std::size_t traces = 0, good = 0;       ///< good by the course's rule
  double coverage = 0, error_widths = 0;  ///< sums over the traces
  std::size_t traced_letters = 0;
  double duration = 0;  ///< of the traces [s]

  std::size_t answers() const { return signs.answers + words.answers; }  ///< to "what is it?"
  std::size_t right() const { return signs.right + words.right; }
  double MeanCoverage() const;      ///< 0-1
  double MeanErrorWidths() const;   ///< [groove widths]
  double LettersPerSecond() const;  ///< named right, at the learner's own pace
  double TracedPerSecond() const;
};

/// How a learner does with one item, by unguided and unscaled trials only.
struct ItemFact {
  std::string item;
  double size = 0;        ///< smallest at which it is sure [m]; 0: at none yet
  double present = 0;     ///< at which it is worked on [m]
  bool taught = false;    ///< a sign of a lesson, not a word made of such
  bool mastered = false;  ///< sure at the smallest size once
  std::int64_t last = 0;  ///< when it was last asked, traced or led along, Unix time [s]
  std::size_t answers = 0, right = 0;  ///< of its last 10
  std::size_t traces = 0, good = 0;    ///< likewise
  std::string taken_for;               ///< most often; empty: nothing
  int taken = 0;                       ///< so many times
  double Weakness() const;  ///< share that will go wrong, 0-1: the greater the sooner practised
};

/// Two items of which one was taken for the other: named, or picked.
struct ConfusionFact {
  std::string shown, said;  ///< the more frequent way round
  int times = 0, back = 0;  ///< shown taken for said; said taken for shown
  Likeness likeness = Likeness::kOther;
  std::int64_t last = 0;  ///< Unix time [s]
  int all() const { return times + back; }
};

/// A day, or a week by its Monday, on which something was done, where the user lives.
struct DayFact {
  std::string day;  ///< "2026-11-21"
  TrialSums alone;  ///< unguided and unscaled
  TrialSums guided;
  double smallest = 0;  ///< letters at which anything was named right, [m]; 0: none
};

/// All facts of a report, before words. Trials without an item (marks of steps and lessons) count
/// nowhere; scaled ones count in `scaled` only.
struct ReportFacts {
  std::string lesson;    ///< where the learner is, its id; empty: not begun
  std::size_t step = 0;  ///< of that lesson, from 0
  bool course_done = false;
  /// Met so far: signs and words that were asked, traced or led along, in the course's order.
  std::vector<ItemFact> met;
  std::vector<std::string> unmet;  ///< signs of the course that are still to come, in its order
  std::vector<ItemFact> practise;  ///< below the rule's target, at most three, the weakest first
  /// Signs that the course teaches, without the lessons beside it, and how many of just these are
  /// mastered, so that never more are than there are.
  std::size_t items = 0, mastered = 0;
  double size_reached = 0;  ///< smallest at which anything is sure [m]; 0: none
  std::size_t lessons_done = 0;
  TrialSums alone, guided;
  std::size_t scaled = 0, simulated = 0;
  /// Pairs of signs that were confused more than once first, then by how often.
  std::vector<ConfusionFact> confusions;
  /// Shown -> answered -> times, right ones too: signs that were named without help.
  std::map<std::string, std::map<std::string, int>> matrix;
  std::vector<DayFact> days, weeks;  ///< in the order in which they first came
};

/// `trials`: of this course, in the order in which they were added. The course holds what its
/// learner was asked: with the learner's own name among its words (AddOwnName).
ReportFacts FactsOf(const Course& course, const std::vector<Trial>& trials);

/// The day of a Unix time [s], where the user lives: "2026-11-21".
std::string DayOf(std::int64_t time);
/// The Monday of its week.
std::string WeekOf(std::int64_t time);

}  // namespace moontrace
