#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/course/guidance_mode.h"
#include "lessons/course/trial.h"
#include "lessons/progress/progress.h"

namespace moontrace {

/// What can happen to a lesson. Event carries the time: Unix time [s].
namespace lesson_event {
/// The learner sits down: a new session begins, where the last one ended.
struct Begin {};
/// A hand has followed what was shown (kTrace), or has been led along it (kDemonstrate).
struct Traced {
  Trial measured;  ///< its metrics; lesson, step, item, size, help are the machine's to fill in
};
/// The learner says what it is.
struct Answered {
  std::string text;
  double latency = 0;  ///< since the page could be felt [s]
  Trial measured;      ///< its metrics of the hand while it explored
};
/// A word of the learner, or of the tutor, who overrules anything.
enum class Word {
  kAgain,
  kNext,
  kBack,  ///< to the text before in this lesson
  kBigger,
  kSmaller,
  kMoreHelp,
  kLessHelp,
  kSlower,
  kFaster,
  kHint
};
struct Said {
  Word word = Word::kAgain;
  bool by_tutor = false;
};
/// The tutor sets what the rules would choose. What is set takes effect and stays; an Overrule with
/// nothing set returns all choices to the rules. `lesson`, `next_lesson`, `skip` and `practise` are
/// done at once.
struct Overrule {
  std::optional<double> size;  ///< [m]
  std::optional<int> help;     ///< 0-10
  std::optional<GuidanceMode> mode;
  std::optional<std::string> lesson;  ///< go there
  bool next_lesson = false, skip = false;
  std::optional<std::string> practise;  ///< a sign that is known, by its name: traced once more
};
/// A text of the learner's own is to be read now; what is asked comes again behind it.
struct OwnText {
  std::string text;
};
/// Time passes; sent at least once a minute.
struct Tick {};
}  // namespace lesson_event

struct Event {
  std::int64_t time = 0;  ///< Unix time [s]
  std::variant<lesson_event::Begin, lesson_event::Traced, lesson_event::Answered,
               lesson_event::Said, lesson_event::Overrule, lesson_event::OwnText,
               lesson_event::Tick>
      what;
};

/// What is to be done, in order. The machine only names sentences; sim/learn has their words.
namespace lesson_action {
enum class Sentence {
  kWelcome,      ///< text: course title
  kWelcomeBack,  ///< as kLesson, which does not follow
  kLesson,       ///< text: lesson's title; number, of; of 0: beside the course
  kCourseText,   ///< text: as it stands in the lesson's file
  kExploreIt,    ///< a page to be felt, until "next"
  kReadIt,       ///< a text to be read, until "next"; text: the text
  kNotLearnt,    ///< text: signs of it that the learner has not met, with commas
  kNewItem,      ///< text: item
  kOnWith,       ///< text: item; to who comes back, before what a step says of it
  kHint,         ///< text: memory aid
  kLedAlong,     ///< text: item; the hand is led along it now
  kAnother,      ///< what is asked now is not what was asked before; number: signs, 1 or 2
  kAskName,      ///< what is it?
  kAskPick,      ///< is it text or other?
  kAskSame,      ///< two side by side: same or different?
  kTraceIt,      ///< text: item; number: 1 where the tip cannot be lifted
  kProbe,        ///< this one without help
  kRight,        ///< text: item
  kWrong,        ///< text: item, other: answer
  kTold,         ///< to who does not know; text: item
  kNotAnAnswer,  ///< text: answer, that is no item the learner knows
  kTraceGood,    ///< text: item; value: coverage
  kTraceBad,     ///< text: item; value: coverage
  kSmallerNow,   ///< text: item; value: size [m]
  kLargerAgain,  ///< text: item; value: size [m]
  kSure,         ///< text: item
  kHelpNow,      ///< value: help
  kSpeedNow,     ///< value: speed factor
  kSizeNow,      ///< value: size [m]
  kModeNow,      ///< text: guidance mode
  kByRules,      ///< what was overruled is chosen by the rules again
  kSkipped,      ///< text: item; it is left and not sure
  kLessonLeft,   ///< text: title of a lesson that is not done
  kCannotLarger,
  kCannotSmaller,
  kNoMoreHelp,
  kNoLessHelp,
  kNoHelpHere,  ///< no push while something is to be recognised
  kTestBegins,  ///< number: items asked
  kTestResult,  ///< number right, of
  kTestAgain,   ///< too few were right: what was wrong is practised, then all asked again
  kReviewDue,   ///< number: items due
  kLessonDone,  ///< text: title
  kCourseDone,
  kCannotPractise,  ///< text: no sign that the learner knows; number: the lesson it comes in
  kOfferLesson,     ///< text: title of one beside the course; number
  kBreak,           ///< number: minutes worked
  kNoHint,          ///< number: 1 while it is asked
  kNotAsked,        ///< text: an answer where nothing was asked
  kNotNow,          ///< a trace where none was awaited
  kNoWayBack,       ///< something is asked: there is no page before
  kNoTextBefore,    ///< nothing to go back to in this lesson
  kNoSuchLesson,    ///< text: what was asked for
  kLastLesson,      ///< there is no next one
  kLargestSize,     ///< in place of kSizeNow; value: the largest there is [m]; number: asked [mm]
  kSmallestSize     ///< likewise the smallest
};
struct Say {
  Sentence sentence = Sentence::kWelcome;
  std::string text, other;
  double value = 0;
  int number = 0, of = 0;
};
/// Lets a page be felt; replaces the last one.
struct Show {
  std::string text;       ///< to be set; two items of kSame with a space between
  std::string script;     ///< as FindScript takes it
  double grade = 1;       ///< of the script
  double size = 0;        ///< [m]
  bool one_page = false;  ///< all of it on one page: lines closer, then letters smaller
  bool told = true;       ///< false: it is asked for, so it must not be said or shown
};
/// The push from now on. `demonstrate`: the hand is led along all strokes, then Traced comes.
struct Push {
  GuidanceMode mode = GuidanceMode::kOff;
  int help = 0;
  double speed = 1;  ///< factor on the gains' speed
  bool demonstrate = false;
};
/// A row for the records; progress has already taken it in.
struct Keep {
  Trial trial;
};
/// What the machine waits for now: a trace, an answer, or a word.
enum class Await { kTrace, kAnswer, kNext, kEnd };
}  // namespace lesson_action

using Action = std::variant<lesson_action::Say, lesson_action::Show, lesson_action::Push,
                            lesson_action::Keep, lesson_action::Await>;

/// Everything that a running lesson remembers; a value type. `progress` changes by kept trials
/// alone, so that it can be computed from the records; the rest lasts as long as the session.
struct LessonState {
  Progress progress;
  bool begun = false, ended = false;
  std::int64_t session_begin = 0, break_announced = 0;  ///< Unix time [s]
  std::uint64_t random = 1;                             ///< seed; each choice advances it
  bool announced = false;                               ///< the present step has been begun aloud
  bool back = false;                                    ///< has come back, and heard of no sign yet
  bool practising = false;                              ///< for a test that was not passed
  bool offered = false;  ///< a lesson beside the course, in this session
  bool another = false;  ///< the next question would sound like the last one asked once more
  std::string lesson_announced;      ///< id of the lesson whose title was said last
  std::vector<std::string> reviews;  ///< items due, still to be asked
  std::vector<std::string> queue;    ///< items to be asked again soon, after a failure
  std::vector<std::string> skipped;  ///< items of this step that were left by "next"
  /// New items that were left by "next" while they were shown: no trial, and in this session they
  /// count as introduced.
  std::vector<std::string> named;
  std::string item, mate;              ///< shown now; second of a pair
  std::string own_text;                ///< of the learner's own, read now; empty: none
  bool review = false;                 ///< it was due
  StepKind task = StepKind::kExplore;  ///< what is done with it now
  Question question = Question::kName;
  bool probe = false;  ///< unguided by plan, in a guided block
  double size = 0;     ///< of what is shown [m]
  GuidanceMode mode = GuidanceMode::kOff;
  int help = 0, most_help = 0;  ///< of the push now; the greatest since the page was shown
  double speed = 1;
  lesson_event::Overrule overrule;  ///< in force
  lesson_action::Await await = lesson_action::Await::kNext;
  /// Copied into every trial of this session; the caller of StartLesson sets them.
  bool scaled = false, simulated = false;
  /// The tip cannot be lifted off a paper that is felt; likewise set by the caller.
  bool held = false;
};

}  // namespace moontrace
