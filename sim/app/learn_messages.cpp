#include "sim/app/learn_messages.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/app/words.h"
#include "textures/text_file.h"

namespace moontrace::say {

namespace {

std::string Millimetres(double size) { return Short(kMillimetres * size, 1) + " mm"; }

std::string Whole(double value) { return Short(std::round(value), 0); }

std::string HelpSentence(double help) {
  if (help <= 0) return "No help now: nothing pushes.";
  return fmt::format("Help {} of 10 now.", Whole(help));
}

}  // namespace

std::string Called(const Course& course, std::string_view item) {
  const auto feed = item.find('\n');
  if (feed == std::string_view::npos) return OneLine(NameOf(course, item));
  return fmt::format("{} and {}", OneLine(NameOf(course, item.substr(0, feed))),
                     OneLine(NameOf(course, item.substr(feed + 1))));
}

std::string LessonSentence(const Course& course, const lesson_action::Say& sentence) {
  using lesson_action::Sentence;
  const std::string text = Called(course, sentence.text), other = Called(course, sentence.other);
  switch (sentence.sentence) {
    case Sentence::kWelcome:
      return fmt::format("Welcome to {}.", OneLine(sentence.text));
    case Sentence::kWelcomeBack:
      return fmt::format("Welcome back, to: {}.", OneLine(sentence.text));
    case Sentence::kLesson:
      return fmt::format("Lesson {} of {}: {}.", sentence.number, sentence.of,
                         OneLine(sentence.text));
    case Sentence::kCourseText:
      return sentence.text;  // its lines are told one by one
    case Sentence::kNewItem:
      return fmt::format("New: {}.", text);
    case Sentence::kHint:
      return fmt::format("Hint: {}", OneLine(sentence.text, 500));
    case Sentence::kAskName:
      return "What is it? Type its name and Enter.";
    case Sentence::kAskPick:
      return fmt::format("Is it {} or {}?", text, other);
    case Sentence::kAskSame:
      return "Two signs: same or different?";
    case Sentence::kTraceIt:
      return fmt::format("Trace {}; lift when done.", text);
    case Sentence::kProbe:
      return "This one without help.";
    case Sentence::kRight:
      return fmt::format("Right: {}.", text);
    case Sentence::kWrong:
      return fmt::format("Wrong: it is {}, you said {}.", text, other);
    case Sentence::kNotAnAnswer:
      return fmt::format("No sign learned so far: {}. Still asked.", text);
    case Sentence::kTraceGood:
      return fmt::format("Good: {}, {} covered.", text, Percent(sentence.value));
    case Sentence::kTraceBad:
      return fmt::format("Not yet: {}, {} covered.", text, Percent(sentence.value));
    case Sentence::kSmallerNow:
      return fmt::format("Smaller now: {}, {}.", text, Millimetres(sentence.value));
    case Sentence::kLargerAgain:
      return fmt::format("Larger again: {}, {}.", text, Millimetres(sentence.value));
    case Sentence::kSure:
      return fmt::format("Sure: {}.", text);
    case Sentence::kHelpNow:
      return HelpSentence(sentence.value);
    case Sentence::kSpeedNow:
      return fmt::format("Speed {} times the usual now.", Short(sentence.value, 2));
    case Sentence::kSizeNow:
      return fmt::format("Letters of {} now.", Millimetres(sentence.value));
    case Sentence::kCannotLarger:
      return "No larger: these are the largest.";
    case Sentence::kCannotSmaller:
      return "No smaller: these are the smallest.";
    case Sentence::kNoMoreHelp:
      return "No more help: it is at its most.";
    case Sentence::kNoLessHelp:
      return "No less help: there is none now.";
    case Sentence::kTestBegins:
      return "A test: no help, results at the end.";
    case Sentence::kTestResult:
      return fmt::format("Test done: {} of {} right.", sentence.number, sentence.of);
    case Sentence::kReviewDue:
      return fmt::format("To review: {}.",
                         Counted(static_cast<std::size_t>(sentence.number), "sign", "signs"));
    case Sentence::kLessonDone:
      return fmt::format("Lesson done: {}.", OneLine(sentence.text));
    case Sentence::kCourseDone:
      return "Course done: every lesson is behind you.";
    case Sentence::kBreak:
      return fmt::format("Time for a break: {} worked. Quit keeps all; or go on.",
                         Counted(static_cast<std::size_t>(sentence.number), "minute", "minutes"));
    case Sentence::kNoHint:
      return "No hint for this one.";
    case Sentence::kExploreIt:
      return "Feel the page; say next to go on.";
    case Sentence::kReadIt:
      return "Read the page; say next to go on.";
    case Sentence::kLedAlong:
      return fmt::format("Let your hand be led: {}.", text);
    case Sentence::kModeNow:
      return fmt::format("Push now: {}.", OneLine(sentence.text));
    case Sentence::kByRules:
      return "By the rules again: size, help and push.";
    case Sentence::kSkipped:
      return text.empty() ? "Skipped, not sure yet."
                          : fmt::format("Skipped, not sure yet: {}.", text);
    case Sentence::kNoHelpHere:
      return "No push while it is to be recognised.";
    case Sentence::kTestAgain:
      return "Not passed: practice, then once more.";
    case Sentence::kNotAsked:
      return fmt::format("Nothing is asked now: {}.", OneLine(sentence.text, 16));
    case Sentence::kNotNow:
      return "No trace is awaited now.";
    case Sentence::kNoSuchLesson:
      return fmt::format("No such lesson: {}.", OneLine(sentence.text, 20));
  }
  return {};
}

std::string DemonstrationSentence(const Course& course, const lesson_action::Say& sentence) {
  using lesson_action::Sentence;
  switch (sentence.sentence) {
    case Sentence::kLedAlong:
    case Sentence::kTraceIt:
      return fmt::format("The program's hand traces {}.", Called(course, sentence.text));
    case Sentence::kExploreIt:
    case Sentence::kReadIt:
      return "The program's hand goes over the page; say next to go on.";
    default:
      return {};
  }
}

std::string Awaited(lesson_action::Await await, Question question, bool stopped) {
  if (stopped) return "Stopped: no force. Say go to go on.";
  switch (await) {
    case lesson_action::Await::kTrace:
      return "Your turn: trace, then lift or say done.";
    case lesson_action::Await::kAnswer:
      return question == Question::kSame ? "Asked: same or different?" : "Asked: what is it?";
    case lesson_action::Await::kNext:
      return "Say next to go on; the page lies there until then.";
    case lesson_action::Await::kEnd:
      return "The end: say quit.";
  }
  return {};
}

std::vector<std::string> LearnHelp(bool keys) {
  std::vector<std::string> words;
  for (const std::string& word : LearnWords()) {
    words.push_back(fmt::format("{} {}", words.size() + 1, word));
  }
  std::vector<std::string> lines = {
      fmt::format("Words, or their beginning or number: {}.", Joined(words, ", ")),
      "While something is asked, signs, numbers and names are answers; a line that begins with / "
      "is a word: /7 is bigger, /a is again. Stop and quit always are words.",
      "A trace has ended when you have followed it all and lift for half a second, when you say "
      "done, or press the button twice. One press tells where you are; held, it stops.",
      "An empty line tells what is waited for."};
  if (keys) lines.emplace_back("Keys: Escape stops, the blank pauses; the others are in README.");
  return lines;
}

std::string LearnUnknown(std::string_view given) {
  return fmt::format("Unknown: {}. Type ? for the words.", OneLine(given, 20));
}

std::string LearnAmbiguous(std::string_view given, const std::vector<std::string>& words) {
  return fmt::format("{} could be {}.", OneLine(given, 20), Joined(words, " or "));
}

std::string AlreadyStopped() { return "Stopped already. Say go to go on."; }
std::string NotStopped() { return "Not stopped: go on feeling."; }
std::string Pausing() { return "Pause: no force. Say go to go on."; }
std::string NotWhileAsked() { return "Not told while it is asked."; }
std::string TipAt(std::string_view name, std::size_t line, bool touching) {
  const std::string_view touch = touching ? "touching" : "in the air";
  if (name.empty()) return fmt::format("On a sign, {}, line {}.", touch, line + 1);
  return fmt::format("At {}, {}, line {}.", OneLine(name), touch, line + 1);
}
std::string TipBetween(bool touching) {
  return fmt::format("Between signs, {}.", touching ? "touching" : "in the air");
}
std::string NoLessonNow() { return "No lesson has begun."; }
std::string LetterHere(std::string_view name) { return fmt::format("At {}.", OneLine(name)); }
std::string NoLetterHere() { return "No sign is near the tip."; }
std::string WordHere(std::string_view word) { return fmt::format("Word: {}.", OneLine(word)); }
std::string Spelled(const std::vector<std::string>& names) {
  return fmt::format("Spelled: {}.", Joined(names, ", "));
}
std::string NothingTouched() { return "Nothing touched yet: the trace goes on."; }
std::string StillAsked() { return "Still asked: an answer, or say next."; }

std::string WhereInCourse(std::string_view title, std::size_t number, std::size_t of,
                          std::size_t step, std::size_t steps) {
  return fmt::format("Lesson {} of {}, step {} of {}: {}.", number, of, step, steps,
                     OneLine(title));
}

std::string Learner(std::string_view name, std::size_t trials, bool fresh) {
  if (fresh) return fmt::format("New learner: {}.", OneLine(name));
  return fmt::format("Learner: {}, {} so far.", OneLine(name), Counted(trials, "trial", "trials"));
}

std::string AskLearner() { return "Who learns? Type a name of your choice and Enter."; }
std::string AskWhich(const std::vector<std::string>& names) {
  return fmt::format("Who learns: {}, or a new name?", Joined(names, ", "));
}
std::string NoLearner() { return "nobody said who learns: give a name with --learner NAME"; }
std::string AskConsent() {
  return "Keep the raw tracks of your hand? They stay on this machine and can be erased with "
         "moontrace records erase. Type yes, or Enter for no.";
}
std::string ConsentGiven(bool yes) {
  return yes ? "Raw tracks will be kept." : "Raw tracks will not be kept.";
}
std::string YesOrNo() { return "Type yes or no."; }
std::string NotAName() { return "Not a name: 1 to 60 printable characters, no slashes."; }
std::string QuitLeaves() { return "The word quit ends, and nothing is kept yet."; }
std::string LeftBeforeBeginning() { return "Ended before it began: nothing was kept."; }
std::string NoConsentAsked() { return "Raw tracks are not kept: nobody was asked."; }
std::string NoRecords() {
  return "Nothing is remembered after this session: this build has no SQLite.";
}
std::string NotKept(std::string_view why) {
  return fmt::format("Not kept yet: {}. It is tried again.", OneLine(why, 300));
}
std::string KeptNow(std::size_t trials) {
  return fmt::format("Kept now: {}.", Counted(trials, "trial", "trials"));
}
std::string NeverKept(std::size_t trials) {
  return fmt::format("{} could not be kept in the records", Counted(trials, "trial", "trials"));
}
std::string SimulatedOnly(std::string_view name) {
  return fmt::format("{} is a simulated learner: choose another name, or add --simulate",
                     OneLine(name));
}

std::string Demonstration() {
  return "Demonstration: nothing is felt. The program's own hand traces each page.";
}
std::string DemonstrationCounts() {
  return "Nothing counts here, so a sign comes again until you say next: trials are kept as "
         "simulated and make no sign sure.";
}
std::string WithDevice(std::string_view device) {
  return fmt::format("Device: {}.", OneLine(device));
}
std::string NotFelt() {
  return "Nothing is felt: this device has no motors. Trials do not count for mastery.";
}
std::string LearnScaled() { return "Scaled: trials do not count for mastery."; }
std::string LearnBegins() { return "Type a word and Enter; ? tells the words, quit ends."; }
std::string SessionEnded(std::size_t trials, std::size_t sure) {
  return fmt::format("Ended: {} this time, {} sure.", Counted(trials, "trial", "trials"),
                     Counted(sure, "sign", "signs"));
}
std::string EndOfInput() { return "End of input: the session ends."; }
std::string LostTrial() { return "This try does not count: the device was lost."; }
std::string NoRoomFor(double wanted, double got) {
  return fmt::format("No room for letters of {}: here {}; this does not count.",
                     Millimetres(wanted), Millimetres(got));
}
std::string CannotShow(std::string_view text, std::string_view why) {
  return fmt::format("Cannot be shown: {}: {}.", OneLine(text, 16), OneLine(why, 300));
}

std::string DeviceProblem(std::string_view name, std::string_view problem) {
  return fmt::format("There, but not usable: {}: {}", OneLine(name), OneLine(problem, 300));
}
std::string NoForceDevice() { return "No force device is here: nothing can be felt."; }
std::vector<std::string> LearningWithoutDevice() {
  return {
      "A demonstration works: moontrace learn --device simulated. The program's own hand traces "
      "the pages; nothing is felt and nothing counts.",
      "Printing works: moontrace learn --print lesson.svg writes a lesson's pages for swell "
      "paper in true size.",
      "Mouse or pen works, with a window and sound: moontrace learn --device mouse --view "
      "--sound. Nothing is felt and nothing counts.",
      "To see which devices this machine knows: moontrace devices."};
}
std::string NoDeviceGiven() { return "no force device: name one with --device when there is one"; }

std::string Printed(std::string_view title, std::size_t pages, double size) {
  return fmt::format("Printed: {}, {}, letters of {}. Print at 100 percent on swell paper.",
                     OneLine(title), Counted(pages, "page", "pages"), Millimetres(size));
}
std::string NoSuchLesson(std::string_view given, std::string_view nearest) {
  return fmt::format("no such lesson: {}{}{}", OneLine(given),
                     nearest.empty() ? "" : "; did you mean ", OneLine(nearest));
}
std::string NothingToPrint(std::string_view lesson) {
  return fmt::format("lesson {} shows nothing that could be printed", OneLine(lesson));
}
std::string OnlyWithPrint(std::string_view option) {
  return fmt::format("{} is for printing: add --print FILE", option);
}

std::string KeysNeedTerminal() { return "--keys needs a terminal: leave it out in a pipe"; }
std::string NoSuchKey(std::string_view key) {
  return fmt::format("no key is called {}; a sign, or a name like Space, Tab, F5, PageUp",
                     OneLine(key));
}
std::string EscapeStops() { return "Escape always stops: leave this line out"; }
std::string TwoWordsOneKey(std::string_view key, std::string_view first, std::string_view second) {
  return fmt::format("{} is {} and {}", key, first, second);
}
std::string KeyConflicts(const std::vector<std::string>& conflicts) {
  return fmt::format("keys with two words: {}; give each its own", Joined(conflicts, ", "));
}

std::string NoLeading() { return "Nothing leads your hand here; the way is:"; }

std::string WayOfStroke(const StrokeWay& way, std::size_t number, std::size_t of) {
  static constexpr const char* kHeights[] = {"bottom", "middle", "top"};
  static constexpr const char* kSides[] = {"left", "middle", "right"};
  static constexpr const char* kWays[] = {"right", "up and right",  "up",   "up and left",
                                          "left",  "down and left", "down", "down and right"};
  const auto place = [](ThirdPlace at) {
    const std::string height = kHeights[at.y + 1], side = kSides[at.x + 1];
    return height == side ? height : height + " " + side;
  };
  const std::string which = of == 1 ? "One stroke" : fmt::format("Stroke {} of {}", number, of);
  if (way.dot) return fmt::format("{}: a dot, {}.", which, place(way.from));
  std::string line = fmt::format("{}: from {}", which, place(way.from));
  for (const WayPiece& piece : way.pieces) {
    const char* turn = piece.clockwise ? "clockwise" : "anticlockwise";
    if (piece.round) {
      line += fmt::format(", a ring {}", turn);
    } else if (piece.arc) {
      line += fmt::format(", a bend {} {}", turn, kWays[piece.eighth]);
    } else {
      line += fmt::format(", {}", kWays[piece.eighth]);
    }
  }
  return fmt::format("{}, to {}.", line, place(way.to));
}

}  // namespace moontrace::say
