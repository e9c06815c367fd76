#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/course/course.h"
#include "sim/session/place_walk.h"

namespace moontrace {

/// What a learner can say at any moment of a lesson.
enum class LearnWord : std::uint8_t {
  kStop,
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
  kBack,
};

/// The words in the order of LearnWord, which is that of their numbers (sim/console/vocabulary.h):
/// stop, next, where, ... Without those of a kind of their own: lesson, practise, PlaceWords.
const std::vector<std::string>& LearnWords();

/// What is asked just now, so that an answer can be told from a word.
enum class Asked : std::uint8_t {
  kNothing,
  kName,    ///< any sign or word is an answer, but numbers are those of words
  kNumber,  ///< likewise, and numbers are answers
  kSame,    ///< "same" and "different" are
  kText     ///< a text of one's own, any line; an empty one: the last
};

/// What a typed line means.
struct LearnLine {
  enum class Kind : std::uint8_t {
    kWord,
    kAnswer,
    kLesson,    ///< "lesson 5"; without the number: "lesson"
    kPractise,  ///< "practise b", "practise"
    kPlace,     ///< one of PlaceWords: "find moon", "next line"
    kMyText,    ///< "my text the cat sat", or what was typed where a text was asked for
    kNothing,   ///< an empty line
    kRefused    ///< no such word, and nothing was asked, or the beginning of several
  };
  Kind kind = Kind::kNothing;
  LearnWord word = LearnWord::kHelp;  ///< of kWord
  /// Of kAnswer, in small letters; of kLesson and kPractise which one; of kMyText as it was typed;
  /// of "help" the word that is asked about, or "all"; of kRefused one line: what is wrong, and the
  /// cure.
  std::string answer;
  PlaceCommand place = {};  ///< of kPlace
  std::string meant = {};   ///< of kRefused: SaidLine::meant
};

/// A word as ReadLine has it (sim/console/vocabulary.h); a question mark behind it does not count.
/// A line that begins with "/" is never an answer, nor is "lesson", "practise", "my text" or "help"
/// with what they want behind them, where that is no item of the course.
///
/// While something is asked, in this order: stop and quit are always words; the text or the name of
/// an item of the course is an answer; then whole words; single signs are answers, numbers where
/// they are asked for; beginnings of words of two letters and more are words; anything else is an
/// answer. While nothing is asked, what is no word is an answer too if it names an item, or says
/// that one does not know.
LearnLine ReadLearnLine(std::string_view line, Asked asked, const Course& course);

}  // namespace moontrace
