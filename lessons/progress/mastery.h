#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/course/lesson_items.h"
#include "lessons/course/trial.h"
#include "lessons/progress/progress.h"

namespace moontrace {

/// Whether an item is sure, and at what size. Evidence of an item is of its present size alone:
/// the last `attempts` answers and, at the first size, the last `traces` traces, all unguided and
/// unscaled. A word that was named right is evidence of its letters.

/// Size at a place of the course's ladder [m]; the last for a place beyond it; 12 mm for a course
/// without sizes.
double SizeAt(const Course& course, std::size_t size_step);

/// Standard size: the ladder's last place.
std::size_t LastSize(const Course& course);

/// Whether two sizes are the same page's, [m]: to a thousandth.
bool SameSize(double a, double b);

/// Enough answers, and enough of them right.
bool NamedEnough(const MasteryRule& rule, const ItemProgress& item);
/// Enough traces, and their mean coverage and error within the rule.
bool TracedEnough(const MasteryRule& rule, const ItemProgress& item);

/// A trace's coverage and error within the rule. NaN is outside it.
bool GoodTrace(const MasteryRule& rule, const Trial& trial);

/// Sure at standard size.
bool Mastered(const Course& course, const ItemProgress& item);

/// Sure at the first size, now or once: so that the next item may enter.
bool PastFirstSize(const ItemProgress& item);

/// Sure at as many sizes as the step asks for, or at all that there are.
bool SureForStep(const Course& course, const Step& step, const ItemProgress& item);

/// Whether traces count for the item where it stands: it is practised by traces, and is at the
/// first size or never named.
bool TracesCount(const Practice& practice, const ItemProgress& item);

/// The taught letters and signs known of which an item's page is made where the learner is, each
/// once (Lesson::spellings). Where that is not known: the longest known item first that fits, so
/// that "the" in "then" is one. None for an item that is not made of others.
std::vector<std::string> PartsOf(const Course& course, const Progress& progress,
                                 std::string_view item);

/// Characters of a text, each once and by its name in the course, that belong to no sign that the
/// learner has met: "g, comma"; empty: none.
std::string UnmetSigns(const Course& course, const Progress& progress, std::string_view given);

/// Place of the ladder at which a new item begins: the first; for one that no lesson teaches (a
/// word), the largest size at which a letter of it is still worked on.
std::size_t FirstSizeOf(const Course& course, const Progress& progress, std::string_view item);

/// Size that a step asks for [m]: its own, otherwise the item's present one; of two the larger.
double AskedSize(const Course& course, const Progress& progress, const Step* step,
                 const ItemPair& items);

/// Takes in an unguided, unscaled trial at the item's present size that was good or not: the item
/// goes a size down once sure, a size up after too many failures in a row. At the largest size
/// it is introduced again then, with the help of the beginning.
void AddEvidence(const Course& course, const Practice& practice, const Trial& trial, bool good,
                 ItemProgress& item);

}  // namespace moontrace
