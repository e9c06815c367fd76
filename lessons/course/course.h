#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// What a person does at a step of a lesson.
enum class StepKind {
  kExplore,      ///< feel the page freely; ends by "next"
  kDemonstrate,  ///< the hand is led along each item, or the path described where nothing can push
  kTrace,        ///< follow each item's strokes; scored
  kRecognise,    ///< feel an item that is not named, and name it
  kRead,         ///< read a text aloud or silently; ends by "next"
  kTest          ///< as kRecognise, unguided, and results come only at the end
};

/// "explore", "demonstrate", "trace", "recognise", "read", "test".
std::string_view NameOf(StepKind kind);
std::optional<StepKind> StepKindOf(std::string_view name);

/// What is asked at kRecognise and kTest.
enum class Question {
  kName,  ///< what is it?
  kPick,  ///< which of two: an item and its mate, "is it b or j?"
  kSame   ///< two items side by side: same or different?
};

/// "name", "pick", "same".
std::string_view NameOf(Question question);
std::optional<Question> QuestionOf(std::string_view name);

/// Line and column of a value in a file, from 1; 0 where it does not stand in the file.
struct SourcePlace {
  std::size_t line = 0, column = 0;
};

/// Places of a file's values by key: "new", "new[0]", "steps[2].text", "steps[2].items[1]".
using SourcePlaces = std::map<std::string, SourcePlace>;

/// An item is a piece of text that is shown and asked by itself: "b", "the", "7", ",", "cat". Its
/// text is its name in all data.
struct Step {
  StepKind kind = StepKind::kExplore;
  Question question = Question::kName;
  std::string say;                 ///< said when it begins; may be empty
  std::string say_held;            ///< in its place where the tip cannot be lifted; empty: `say`
  std::vector<std::string> items;  ///< not for kExplore, kRead; empty: the lesson's new ones
  std::string text;                ///< for kExplore and kRead: the text on the page
  /// Size of this step's letters [m]; none: the learner's present size, by mastery.
  std::optional<double> size;
  /// At how many sizes its items are sure before it ends, where it has no size; none: the rule's.
  std::optional<int> sure_sizes;
  bool own_name = false;  ///< of kRecognise by name: the learner's name is one of the items
  bool one_page = false;  ///< of kExplore and kRead with a size: the text has no second page
  std::size_t line = 0, column = 0;  ///< in the lesson's file, from 1
};

struct Lesson {
  std::string id;                  ///< the file's stem: "04-jnz"
  std::string title;               ///< "J, N and Z"
  std::string file;                ///< path, for messages
  std::string script;              ///< of its pages, as FindScript takes it; default the course's
  double grade = 1;                ///< of the script on its pages; default the course's
  std::vector<std::string> items;  ///< taught here, in order of introduction ("new" in the file)
  std::vector<std::string> needs;  ///< ids of lessons that must be done before
  std::map<std::string, std::string> hints;  ///< item -> memory aid, said when it is introduced
  /// Item that no lesson teaches -> the taught ones with whose signs its page is written, each
  /// once; none where that is not known (spelling.h).
  std::map<std::string, std::vector<std::string>> spellings;
  bool optional = false;  ///< beside the course: gone to when asked for, offered to who fails
  std::vector<Step> steps;
  SourcePlaces places;
};

/// When an item is sure at a size, counted over its last unguided trials at that size; and which
/// items come next. Traces count at the first size only, unless an item is never named.
struct MasteryRule {
  int attempts = 5;         ///< namings needed as evidence
  int traces = 2;           ///< traces needed as evidence, the last of them
  double recognised = 0.8;  ///< share named right, at least
  int sure_sizes = 2;       ///< a step ends when its items are sure at so many sizes
  int words = 2;            ///< right answers in a row that a step wants of what no lesson teaches
  double coverage = 0.9;    ///< of traced strokes, at least
  double error_widths = 0.5;  ///< mean tracing error, at most [groove widths]
  int failures = 3;           ///< wrong or badly traced in a row: back to the next larger size
  double target = 0.85;       ///< share right that the choice of items aims at
  double known =
      0.25;          ///< share of questions that ask what is sure already; twice that below target
  int reviews = 20;  ///< due items reviewed at a session's start, at most
  double quick = 5;  ///< a faster answer rates Easy in the review schedule [s]
  double slow = 30;  ///< a slower answer rates Hard [s]
};

/// How help fades, see fading.h. `rule`: "manual", "linear", "gate", "as-needed".
struct FadeSettings {
  std::string rule = "gate";
  int start = 6;        ///< help at a new item, 0-10
  int probe_every = 4;  ///< one unguided trial in so many
};

/// A course: its lessons in order and what they have in common. Read from one TOML file and one
/// file per lesson.
struct Course {
  std::string id, title, file, language, script;
  double grade = 1;           ///< of the script on its pages
  std::vector<double> sizes;  ///< of letters, descending [m]; the last is standard size
  MasteryRule mastery;
  FadeSettings fade;
  double break_after = 25 * 60;              ///< a break is proposed [s]
  std::map<std::string, std::string> names;  ///< item -> its spoken name: "," -> "comma"
  std::map<std::string, std::string> mates;  ///< item -> the one it is most easily confused with
  std::vector<Lesson> lessons;
  SourcePlaces places;
};

/// Loads `course.toml` (or the folder it is in) and its lessons. Throws InputError:
/// file:line:column, cause, nearest valid key. A name without a slash is looked up in the shipped
/// `lessons/courses`.
Course LoadCourse(const std::string& name_or_path);

/// One thing that is wrong with a course that can be read.
struct CourseFault {
  std::string file;
  std::size_t line = 0, column = 0;  ///< from 1; 0: of the whole file
  std::string what;                  ///< one sentence: cause and cure
};

/// "file:line:column: what", as far as the place is known.
std::string LineOf(const CourseFault& fault);

/// Items or letters used before they are taught, lessons that cannot be reached, needs in a cycle,
/// items taught twice or without a form in the script, no size of at least `smallest` [m] that a
/// device renders. Empty: sound.
std::vector<CourseFault> CheckCourse(const Course& course, double smallest);

/// Of these faults only the lessons that cannot be reached, each with the reason; empty if all can.
std::vector<CourseFault> CheckReach(const Course& course);

/// The name of an item: the course's name for it, otherwise its text.
std::string_view NameOf(const Course& course, std::string_view item);

}  // namespace moontrace
