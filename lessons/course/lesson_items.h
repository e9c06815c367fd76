#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course.h"

namespace moontrace {

/// What a course does with its items: look-ups that progress and the lesson machine share.

/// How many lessons are not beside the course.
std::size_t LessonsInOrder(const Course& course);

/// Place of the lesson with this id in the course; none: no such lesson.
std::optional<std::size_t> LessonIndex(const Course& course, std::string_view id);

/// The same by what people call it: its number as it is heard, from 1 ("5"), its id ("04-itlo"), or
/// the only one whose id begins so ("04") or ends so behind its number ("itlo"); none: no such
/// lesson, or several.
std::optional<std::size_t> LessonNamed(const Course& course, std::string_view given);

/// The step at a place; null where the course has none there.
const Step* StepAt(const Course& course, std::string_view lesson, std::size_t step);

/// Items of a step: its own, or the lesson's new ones; none of kExplore and kRead. Empty texts
/// and repetitions are left out.
std::vector<std::string> ItemsOf(const Lesson& lesson, const Step& step);

/// Whether an item of the step has to be mastered before the step has been finished.
bool IsDrill(StepKind kind);

/// Whether the course teaches the item or asks for it at any step.
bool HasItem(const Course& course, std::string_view item);

/// Whether a lesson has the item as new: a letter or sign; else it is a word, a number, a pair of
/// signs, made of taught ones.
bool IsTaught(const Course& course, std::string_view item);

/// Every item that the course teaches or asks for.
std::set<std::string> AllItems(const Course& course);

/// What has to be shown of an item before it is sure: what the course practises with it, at any
/// step without a size of its own, otherwise at any step.
struct Practice {
  bool traced = false;  ///< at a step kTrace
  bool named = false;   ///< at a step kRecognise or kTest that asks kName
};
Practice PracticeOf(const Course& course, std::string_view item);

/// The lesson that teaches the item, otherwise the first that asks for it; null: none.
const Lesson* HomeOf(const Course& course, std::string_view item);

/// Its memory aid: of this lesson (null: none), otherwise of any; empty: there is none.
std::string HintOf(const Course& course, const Lesson* lesson, std::string_view item);

/// Takes sizes below `smallest` [m] away, the largest stays in any case; steps of a smaller size
/// come at the smallest that is left. True: something changed.
bool EndSizesAt(Course& course, double smallest);

/// `a` and `b` of "a\nb"; of "a": a and nothing.
struct ItemPair {
  std::string first, second;
};
ItemPair PairOf(std::string_view item);

}  // namespace moontrace
