#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lessons/course.h"
#include "lessons/guidance_mode.h"
#include "lessons/progress.h"
#include "lessons/trial.h"

namespace moontrace {

/// What happens to a lesson. All carry when: Unix time [s] in Event.
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
};
/// A word of the learner, or of the tutor, who overrules anything.
enum class Word { kAgain, kNext, kBigger, kSmaller, kMoreHelp, kLessHelp, kSlower, kFaster, kHint };
struct Said {
  Word word = Word::kAgain;
  bool by_tutor = false;
};
/// The tutor sets what the rules would choose; unset: by the rules again.
struct Overrule {
  std::optional<double> size;  ///< [m]
  std::optional<int> help;     ///< 0-10
  std::optional<GuidanceMode> mode;
  std::optional<std::string> lesson;  ///< go there
  bool next_lesson = false, skip = false;
};
/// Time passes; sent at least once a minute.
struct Tick {};
}  // namespace lesson_event

struct Event {
  std::int64_t time = 0;  ///< Unix time [s]
  std::variant<lesson_event::Begin, lesson_event::Traced, lesson_event::Answered,
               lesson_event::Said, lesson_event::Overrule, lesson_event::Tick>
      what;
};

/// What is to be done, in order. Sentences are the text face's: the machine only says which.
namespace lesson_action {
enum class Sentence {
  kWelcome,      ///< text: course title
  kWelcomeBack,  ///< text: lesson's title
  kLesson,       ///< text: lesson's title; number, of
  kCourseText,   ///< text: as it stands in the lesson's file
  kNewItem,      ///< text: item
  kHint,         ///< text: memory aid
  kAskName,      ///< what is it?
  kAskPick,      ///< text: item, other: mate
  kAskSame,
  kTraceIt,      ///< text: item
  kProbe,        ///< this one without help
  kRight,        ///< text: item
  kWrong,        ///< text: item, other: answer
  kNotAnAnswer,  ///< text: answer, that is no item the learner knows
  kTraceGood,    ///< text: item; value: coverage
  kTraceBad,     ///< text: item; value: coverage
  kSmallerNow,   ///< text: item; value: size [m]
  kLargerAgain,  ///< text: item; value: size [m]
  kSure,         ///< text: item
  kHelpNow,      ///< value: help
  kSpeedNow,     ///< value: speed factor
  kSizeNow,      ///< value: size [m]
  kCannotLarger,
  kCannotSmaller,
  kNoMoreHelp,
  kNoLessHelp,
  kTestBegins,
  kTestResult,  ///< number right, of
  kReviewDue,   ///< number: items due
  kLessonDone,  ///< text: title
  kCourseDone,
  kBreak,  ///< number: minutes worked
  kNoHint
};
struct Say {
  Sentence sentence = Sentence::kWelcome;
  std::string text, other;
  double value = 0;
  int number = 0, of = 0;
};
/// Lets a page be felt; replaces the last one.
struct Show {
  std::string text;    ///< to be set; two items of kSame with a space between
  std::string script;  ///< as FindScript takes it
  double size = 0;     ///< [m]
  bool told = true;    ///< false: what it is must not be said or shown
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

/// Everything that a lesson in progress remembers; a value.
struct LessonState {
  Progress progress;
  bool begun = false, ended = false;
  std::int64_t session_begin = 0, session_trials = 0, break_told = 0;  ///< Unix time [s]
  std::uint64_t random = 1;        ///< seed; each choice advances it
  std::vector<std::string> queue;  ///< items still to come at this step
  std::string item, mate;          ///< shown now; second of a pair
  int at_item = 0;                 ///< trials of this item at this step
  int guided_run = 0;              ///< guided trials since the last probe
  bool probe = false;
  int test_right = 0, test_asked = 0;
  double speed = 1;
  lesson_event::Overrule overrule;  ///< in force
  lesson_action::Await await = lesson_action::Await::kNext;
  /// Go into every trial of this session as they are; who starts it sets them after StartLesson.
  bool scaled = false, simulated = false;
};

struct LessonTurn {
  LessonState state;
  std::vector<Action> actions;
};

/// The state in which a learner with this progress sits down.
LessonState StartLesson(const Course& course, Progress progress, std::uint64_t seed);

/// The lesson machine: pure. Never throws on any event in any state: what does not fit is answered
/// by a sentence.
LessonTurn Advance(const Course& course, LessonState state, const Event& event);

}  // namespace moontrace
