#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course.h"

namespace moontrace {

/// What a learner can say at any moment of a lesson.
enum class LearnWord : std::uint8_t {
  kStop,  ///< number 1 here as everywhere
  kNext,
  kWhere,
  kLetter,
  kSpell,
  kWord,
  kBigger,
  kSmaller,
  kMoreHelp,
  kLessHelp,
  kSlower,
  kFaster,
  kHint,
  kAgain,
  kGo,
  kPause,
  kDone,
  kQuit,
  kHelp,
  kSkip,
  kLessons,
  kHow,
  kBrief,   ///< outcomes only
  kFull,    ///< all again
  kMyText,  ///< asks for a text of one's own
};

/// The words by their numbers, from 1: stop, next, where, ...
const std::vector<std::string>& LearnWords();

/// What is asked just now, so that an answer can be told from a word.
enum class Asked : std::uint8_t {
  kNothing,
  kName,  ///< any sign or word is an answer
  kSame,  ///< "same" and "different" are
  kText   ///< a text of one's own, any line; an empty one: the last
};

/// What a typed line means.
struct LearnLine {
  enum class Kind : std::uint8_t {
    kWord,
    kAnswer,
    kLesson,    ///< "lesson 5"
    kPractise,  ///< "practise b"
    kMyText,    ///< "my text the cat sat", or what was typed where a text was asked for
    kNothing,   ///< an empty line
    kUnknown,   ///< no such word, and nothing was asked
    kAmbiguous  ///< the beginning of several words
  };
  Kind kind = Kind::kNothing;
  LearnWord word = LearnWord::kHelp;  ///< of kWord
  std::string answer;  ///< of kAnswer, in small letters; of kLesson and kPractise which one;
                       ///< of kMyText as it was typed
};

/// A word, an unambiguous beginning of one, its number, or "?"; capitals and blanks around do not
/// count, nor does a question mark behind a word. A line that begins with "/" is never an answer,
/// nor is "lesson", "practise" or "my text" with words behind it, where that is no item of the
/// course.
///
/// While something is asked, in this order: stop and quit are always words; the text or the name of
/// an item of the course is an answer; then whole words; single signs and digits are answers;
/// beginnings of words of two letters and more are words; anything else is an answer.
LearnLine ReadLearnLine(std::string_view line, Asked asked, const Course& course);

/// The words that begin with `line`: of the first nineteen if one does, so that what came later
/// takes nobody's short forms away.
std::vector<std::string> LearnWordsFrom(std::string_view line);

}  // namespace moontrace
