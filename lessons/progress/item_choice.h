#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/progress/progress.h"

namespace moontrace {

/// Next number of a seeded sequence (SplitMix64); advances `random`.
std::uint64_t NextRandom(std::uint64_t& random);
/// The same, in [0, 1).
double NextShare(std::uint64_t& random);

/// What comes next at a step.
struct NextItem {
  std::string item;
  StepKind task = StepKind::kTrace;  ///< kDemonstrate, kTrace, kRecognise or kTest
};

/// What the choice remembers.
struct ItemChooser {
  std::uint64_t random = 1;
  std::vector<std::string> queue;    ///< to be asked again soon, after a failure
  std::vector<std::string> skipped;  ///< left at this step
  std::vector<std::string> named;    ///< shown by name in this session: as if introduced
  std::string last;                  ///< item of the last trial; empty: none
  bool last_traced = false;
};

/// The item that comes next at the present step, and what is done with it; none: the step has
/// ended.
///
/// - demonstrate, trace: in order, each until it is finished; an item that is new is demonstrated
///   first.
/// - test: at random, each once; practice before it comes again is as recognise.
/// - recognise: an item enters when those before it are past the first size; two at least are there
///   to be distinguished, so that a name needs feeling. Of those that are there, weak
///   ones come more often (in proportion to the share of wrong answers they may expect), none twice
///   in a row if another can come. What went wrong comes back after one other. A share `known` of
///   the questions asks what is known already, here or from earlier lessons; twice that while fewer
///   than the rule's `target` are right. At the first size an item is traced before it is named.
std::optional<NextItem> ChooseItem(const Course& course, const Progress& progress,
                                   ItemChooser& chooser);

/// How often an item comes, as a weight: the share of wrong answers to expect after its last ones
/// (Laplace's rule), 0-1.
double WeightOf(const ItemProgress& item);

/// Items whose review is due, those that are most likely forgotten first, at most the rule's
/// `reviews`. What a test at the present step asks is left out.
std::vector<std::string> DueItems(const Course& course, const Progress& progress,
                                  std::int64_t time);

}  // namespace moontrace
