#include "sim/learn/learn_messages.h"

#include <fmt/core.h>

#include <algorithm>

#include "lessons/records/learner_history.h"
#include "sim/console/word_messages.h"
#include "sim/console/wording.h"
#include "sim/learn/key_wording.h"
#include "sim/learn/learn_path.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

std::string Millimetres(double size) { return Short(kMillimetres * size, 1) + " mm"; }

}  // namespace

std::string LedNow() { return "Let your hand be led to the end."; }

std::string ProgramTraces() { return "The program's hand traces; next leaves the sign."; }

std::string TracesOn() { return "The program's hand goes on tracing until you say next."; }

std::string Awaited(lesson_action::Await await, Question question, std::string_view between,
                    bool lifts) {
  switch (await) {
    case lesson_action::Await::kTrace:
      return lifts ? "Your turn: trace, then lift or say done; next leaves it."
                   : "Your turn: trace, then say done; next leaves it.";
    case lesson_action::Await::kAnswer:
      if (question == Question::kPick) return fmt::format("Asked: is it {}?", between);
      return question == Question::kSame ? "Asked: same or different?" : "Asked: what is it?";
    case lesson_action::Await::kNext:
      return "Say next to go on; the page lies there until then.";
    case lesson_action::Await::kEnd:
      return "The end: say quit.";
  }
  return {};
}

namespace {

std::string TraceEnds(bool lifts, bool button) {
  return fmt::format(
      "A trace has ended when {}you say done{}. The word next leaves a sign for later.",
      lifts ? "you have followed it all and lift for half a second, when " : "",
      button ? ", or press the button twice" : "");
}
constexpr const char* kUnknown =
    "Asked for what you do not know, say I don't know: you are told, and asked again later.";
constexpr const char* kSlash =
    "A line that begins with / is a word, never an answer: /a is again. Once you have learnt "
    "numbers, a number is an answer, and /7 is bigger.";

void TellButton(HelpLines& help, bool button) {
  if (!button) return;
  help.first.emplace_back(
      "One press of the device's button tells where you are; held down, it stops.");
}

}  // namespace

namespace {

/// Words that a first lesson does without.
bool IsForLater(LearnWord word) {
  switch (word) {
    case LearnWord::kLetter:
    case LearnWord::kSpell:
    case LearnWord::kWord:
    case LearnWord::kSlower:
    case LearnWord::kFaster:
    case LearnWord::kLessons:
    case LearnWord::kHow:
    case LearnWord::kBrief:
    case LearnWord::kFull:
    case LearnWord::kMyText:
      return true;
    default:
      return false;
  }
}

}  // namespace

HelpLines KeysHelp(const std::map<std::string, std::string>& keys, bool lifts, bool button) {
  std::vector<std::string> first, later;
  for (const auto& [key, word] : keys) {
    const auto& words = LearnWords();
    const auto at = std::find(words.begin(), words.end(), word) - words.begin();
    std::vector<std::string>& list = IsForLater(static_cast<LearnWord>(at)) ? later : first;
    list.push_back(fmt::format("{} {}", KeyCalled(key), word));
  }
  HelpLines help{{fmt::format("One key a word, without Enter: {}.", Joined(first, ", ")),
                  "While something is asked, type the answer and Enter. Escape always stops."},
                 {fmt::format("For later, when you know some letters: {}.", Joined(later, ", ")),
                  kUnknown, kSlash, TraceEnds(lifts, button)}};
  TellButton(help, button);
  help.first.emplace_back("The question mark once more tells the other keys.");
  return help;
}

HelpLines LearnHelp(bool lifts, bool button) {
  std::vector<std::string> first, later;
  for (std::size_t i = 0; i < LearnWords().size(); ++i) {
    const std::string& word = LearnWords()[i];
    std::vector<std::string>& list = IsForLater(static_cast<LearnWord>(i)) ? later : first;
    list.push_back(fmt::format("{} {}", WordNamed(word)->number, word));
  }
  HelpLines help{{fmt::format("Words, or their beginning or number: {}.", Joined(first, ", ")),
                  "While something is asked, a sign or its name is the answer."},
                 {fmt::format("For later, when you know some letters: {}.", Joined(later, ", ")),
                  kUnknown, kSlash, "Stop and quit always are words.",
                  "lesson and a number goes to that lesson: lesson 5.",
                  "practise and a sign you know traces it once more: practise b.",
                  "my text and a text of your own lays it under your hand: my text the cat sat.",
                  "find and a word says the way to it on the page: find cat.",
                  "So do find next, next line and next heading; return leads back.",
                  TraceEnds(lifts, button), "An empty line tells what is waited for."}};
  TellButton(help, button);
  help.first.emplace_back("? once more tells the other words; help next tells what next does.");
  return help;
}

std::string Pausing(bool felt) {
  return felt ? "Pause: no force. Say go to go on." : "A pause. Say go to go on.";
}
std::string NotWhileAsked() { return "Not told while it is asked."; }
std::string TipAt(std::string_view name, std::size_t line, bool touching) {
  const std::string_view touch = touching ? "touching" : "in the air";
  if (name.empty()) return fmt::format("On a sign, {}, line {}.", touch, line + 1);
  return fmt::format("At {}, {}, line {}.", OneLine(name), touch, line + 1);
}
std::string TipBetween(bool touching) {
  return fmt::format("Between signs, {}.", touching ? "touching" : "in the air");
}
std::string LessonInList(std::string_view title, std::size_t number, bool here, bool done,
                         bool optional) {
  const char* state = here       ? ", you are here"
                      : done     ? ", done"
                      : optional ? ", beside the course"
                                 : "";
  return fmt::format("{} {}{}.", number, OneLine(title), state);
}
std::string HowFar(std::size_t known, std::size_t all, double smallest) {
  const std::string begun = fmt::format("{} of {} begun", known, Counted(all, "sign", "signs"));
  if (smallest <= 0) return begun + ", none sure yet.";
  return fmt::format("{}; sure down to {} mm.", begun, Short(kMillimetres * smallest, 1));
}
std::string HowSure(std::string_view name, std::size_t right, std::size_t of, double size) {
  const std::string at = Short(kMillimetres * size, 1);
  if (of == 0) return fmt::format("{}: not named yet at {} mm.", OneLine(name), at);
  return fmt::format("{}: {} of {} right at {} mm.", OneLine(name), right, of, at);
}
std::string SureAt(const std::vector<std::string>& names, double size) {
  if (size <= 0) return fmt::format("Begun: {}.", Joined(names, ", "));
  return fmt::format("Sure at {} mm: {}.", Short(kMillimetres * size, 1), Joined(names, ", "));
}
std::string LessonWhich() { return "Say which lesson: lesson 5. The word lessons tells them."; }
std::string PractiseWhich() { return "Which sign? Say it now: b."; }
std::string BriefNow() { return "Brief: outcomes only. full says all again."; }
std::string FullNow() { return "Full: all is said again."; }
std::string AskOwnText(std::string_view last) {
  if (last.empty()) return "Your text? Type it and Enter.";
  const std::string text = OneLine(last, 30);
  const bool ends = text.find_last_of(".!?") == text.size() - 1;
  return fmt::format("Your text? Type it and Enter; Enter alone takes: {}{}", text,
                     ends ? "" : ".");
}
std::string NoOwnText() { return "No text so far: my text the cat sat."; }
std::string NoLessonNow() { return "No lesson has begun."; }
std::string LetterHere(std::string_view name) { return fmt::format("At {}.", OneLine(name)); }
std::string NoLetterHere() { return "No sign is near the tip."; }
std::string WordHere(std::string_view word) { return fmt::format("Word: {}.", OneLine(word)); }
std::string Spelled(const std::vector<std::string>& names) {
  return fmt::format("Spelled: {}.", Joined(names, ", "));
}
std::string NothingTouched(bool mouse) {
  return mouse ? "Nothing touched: hold the mouse button while you move."
               : "Nothing touched yet: the trace goes on.";
}
std::string NothingFollowed() { return "No line followed yet: the trace goes on."; }
std::string NextLeavesIt() { return "Say next once more: it is left for later."; }
std::string StillAsked() { return "Still asked: an answer, or the word next."; }
std::string NothingIsAsked() { return "Nothing is asked now."; }

std::string WhereInCourse(std::string_view title, std::size_t number, std::size_t of,
                          std::size_t step, std::size_t steps) {
  if (of == 0) return fmt::format("Step {} of {}: {}.", step, steps, OneLine(title));
  return fmt::format("Lesson {} of {}, step {} of {}: {}.", number, of, step, steps,
                     OneLine(title));
}

std::string Learner(std::string_view name, std::size_t trials, bool fresh) {
  if (fresh) return fmt::format("New learner: {}.", OneLine(name));
  return fmt::format("Learner: {}, {} so far.", OneLine(name),
                     Counted(trials, "exercise", "exercises"));
}

std::string TakenForKept(std::string_view given, std::string_view kept) {
  return fmt::format("{} is known here: {} is taken for that.", OneLine(kept), OneLine(given));
}

std::string AskLearner() { return "Who learns? Type a name of your choice and Enter."; }
std::string AskWhich(const std::vector<std::string>& names) {
  std::vector<std::string> shown;
  shown.reserve(names.size());
  for (const std::string& name : names) shown.push_back(ShownPseudonym(name));
  return fmt::format("Who learns: {}, or a new name?", Joined(shown, ", "));
}
std::string NoLearner() {
  return "nobody said who learns: give a name with --learner NAME, or as the first line";
}
std::string AskConsent() {
  return "One last question: may the path of your hand be kept too? It stays on this machine, and "
         "shows where a letter is hard. Say yes, or Enter for no.";
}
std::string ConsentHelp() {
  return "Yes or no. What was kept goes again with moontrace records consent NAME no.";
}
std::string ConsentGiven(bool yes) {
  return yes ? "The path of your hand will be kept." : "The path of your hand will not be kept.";
}
std::string SayTheName() { return "Say the name."; }
std::string YesOrNo() { return "Say yes or no."; }
std::string NotAName() { return "Not a name: take 1 to 60 letters, without a slash."; }
std::string WordIsNoName(std::string_view word) {
  return fmt::format("{} is a word, not a name: who learns?", OneLine(word, 14));
}
std::string NumberIsNoName(std::string_view number, std::string_view word) {
  return fmt::format("{} is the word {}, not a name: who learns?", number, word);
}
std::string AnyNameWillDo() { return "Any name will do, your own or a made-up one: who learns?"; }
std::string QuitLeaves() { return "The word quit ends, and nothing is kept yet."; }
std::string LeftBeforeBeginning() { return "Ended before it began: nothing was kept."; }
std::string NoRecords() {
  return "Nothing is remembered after this session: this build has no SQLite.";
}
std::string NotKept(std::string_view why) {
  return fmt::format("Not kept yet: {}. It is tried again.", OneLine(why, 300));
}
std::string KeptNow(std::size_t trials) {
  return fmt::format("Kept now: {}.", Counted(trials, "exercise", "exercises"));
}
std::string NeverKept(std::size_t trials) {
  return fmt::format("{} could not be kept in the records", Counted(trials, "trial", "trials"));
}
std::string SimulatedOnly(std::string_view name) {
  return fmt::format("{} is a simulated learner: choose another name, or add --simulate",
                     OneLine(name));
}

std::string ByProgramsHand() {
  return "Nothing is felt: the program's own hand goes through the lessons.";
}
std::string WhatProgramsHandDoes(bool kept) {
  return fmt::format("Its exercises {}make no sign sure, so a sign comes again until you say next.",
                     kept ? "are kept, but " : "");
}
std::string DemonstrationIsAlone() {
  return "For the demonstration, which keeps nothing, say quit, then type: "
         "moontrace learn --device simulated.";
}
std::string DemonstrationTakesNoTutor() {
  return "The demonstration takes no tutor: moontrace learn --device simulated --tutor does.";
}
std::string NoNameNeeded() { return "The demonstration keeps nothing, so no name is needed."; }
std::string WithDevice(std::string_view device) {
  return fmt::format("Device: {}.", OneLine(device));
}
std::string NotFelt() {
  return "Nothing is felt: this device has no motors. Where a lesson speaks of feeling, the sound "
         "of --sound and the picture of --view stand for it. What you do here makes no letter "
         "sure.";
}
std::string MousePresses() {
  return "Hold the mouse button down: that presses the tip on the paper. The wheel says how hard.";
}
std::string MouseCannotPush() {
  return "The mouse cannot push, so nothing is felt. The way of each letter is told in words, and "
         "heard with --sound. What you do here makes no letter sure.";
}
std::string TipStaysDown() { return "The tip is always on the paper: you need not press."; }
std::string LearnScaled() {
  return "Letters are not in true size: what you do here makes none sure.";
}
std::string LearnBegins() {
  return "To say a word, type it and Enter; ? tells the words, quit ends.";
}
std::string LearnBeginsWithKeys() { return "One key a word, without Enter. ? tells the keys."; }
std::string SessionEnded(std::size_t trials, std::size_t sure) {
  return fmt::format("Ended: {} this time, {} sure.", Counted(trials, "exercise", "exercises"),
                     Counted(sure, "sign", "signs"));
}
std::string EndOfInput() { return "End of input: the session ends."; }
std::string LostTrial() { return "This try does not count: the device was lost."; }
std::string MendDevice(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::kPid:
      return "The lesson waits. Look at the device's plug, its power and its safety switch.";
    case DeviceKind::kWoodenHaptics:
      return "The lesson waits. Look at the arm's plug and its power; then lay the arm in its "
             "rest, "
             "as I shall tell.";
    case DeviceKind::kRawHid:
    case DeviceKind::kPlugin:
      return "The lesson waits. Look at the device's plug and its power.";
    case DeviceKind::kPuck:
      break;
  }
  return "The lesson waits. Look at the device's plug.";
}
std::string WaitsForDevice() { return "The lesson waits for the device: nothing counts now."; }
std::string SizesEndAt(double size, double smallest) {
  if (size < 0.999 * smallest) {
    return fmt::format("No letters are clear on this device: they stay at {}.", Millimetres(size));
  }
  return fmt::format("Letters end at {} here: smaller ones are not clear on this device.",
                     Millimetres(size));
}
std::string NoRoomFor(double wanted, double got) {
  return fmt::format("No room for letters of {}: here {}; this does not count.",
                     Millimetres(wanted), Millimetres(got));
}
std::string SizeHasNoRoom(double wanted, double got) {
  return fmt::format("{} has no room: letters of {} now; this does not count.", Millimetres(wanted),
                     Millimetres(got));
}
std::string CannotShow(std::string_view text, std::string_view why) {
  return fmt::format("Cannot be shown: {}: {}.", OneLine(text, 16), OneLine(why, 300));
}

std::string DeviceProblem(std::string_view name, std::string_view problem) {
  return fmt::format("There, but not usable: {}: {}", OneLine(name), OneLine(problem, 300));
}
std::string NoForceDevice() { return "No force device is here: nothing can be felt."; }
std::vector<std::string> LearningWithoutDevice(bool window) {
  std::vector<std::string> lines{
      "A demonstration works: moontrace learn --device simulated. It takes nine minutes, is told "
      "in words, and keeps nothing.",
      "Printing works: moontrace learn --print lesson.pdf writes a lesson's pages for swell "
      "paper in true size."};
  lines.push_back(fmt::format(
      "Mouse or pen works{}, with a window and sound: moontrace learn --device mouse --view "
      "--sound. Nothing is felt and nothing counts.",
      window ? "" : " from the desktop"));
  lines.emplace_back(
      "With a tutor: moontrace learn --tutor --device simulated --learner NAME, and in a second "
      "terminal moontrace tutor.");
  lines.emplace_back("To see which devices this machine knows: moontrace devices.");
  return lines;
}
std::string NoWindowForMouse() {
  return "no window can open here: start it from the desktop, or print a lesson: moontrace learn "
         "--print lesson.pdf";
}
std::string NoWindowHere() { return "No window can open here: it goes on without --view."; }
std::string AskWithoutDevice(bool window) {
  return fmt::format(
      "What shall begin? Type 1, 2 or 3, or its word, and Enter; Enter alone ends.\n"
      "1 demonstration: told in words, nine minutes.\n"
      "2 paper: the pages of a lesson for swell paper.\n"
      "3 mouse: a window and sound{}; nothing is felt.",
      window ? "" : ", from the desktop");
}
std::string DemonstrationIs() {
  return "1 asks a few questions, and the word quit ends it. 2 writes a file to be printed. 3 lets "
         "the mouse move the tip.";
}
std::string NoneOfThree(std::string_view given) {
  return fmt::format("{} is none of these.", OneLine(given, 20));
}
std::string NoDeviceGiven() {
  return "nothing was begun: take one of these, or plug in a device and start learn again";
}

std::string Printed(std::string_view title, std::size_t pages, double size) {
  return fmt::format("Printed: {}, {}, letters of {}.", OneLine(title),
                     Counted(pages, "page", "pages"), Millimetres(size));
}
std::string PrintedSideways() { return "Landscape: upright, the sheet would break a word."; }
std::string PrintedSmaller(double wanted) {
  return fmt::format("Smaller than {}: so large, a word would be broken.", Millimetres(wanted));
}
std::string PrintedBroken() { return "Words are broken: no size keeps them in a line."; }
std::string PrintedHow() {
  return "Print at 100 percent on swell paper; the slanting line marks the upper right corner.";
}
std::string PrintNext(std::string_view file, std::size_t number, std::string_view course) {
  const std::string of =
      course.empty() ? "" : fmt::format(" --course \"{}\"", OneLine(course, 4096));
  return fmt::format("Next: moontrace learn{} --print {} --lesson {}", of, file, number);
}
std::string PrintedLast() {
  return "This is the last lesson. To feel letters with a device: moontrace learn";
}
std::string PrintedPageInMoon(std::size_t page) { return fmt::format("page {}", page); }
std::string PrintedInstructionInMoon() { return "follow each line"; }
std::string PrintedInstruction(std::string_view title, std::size_t page, std::size_t pages,
                               double size, std::string_view lines) {
  return fmt::format(
      "{}, page {} of {}, letters of {}. The slanting line is at the upper right. Feel each line "
      "from the left, with one or two fingers. Lines: {}.",
      OneLine(title), page, pages, Millimetres(size), OneLine(lines, 120));
}
std::string NoSuchLesson(std::string_view given, std::string_view nearest) {
  return fmt::format("no such lesson: {}; {}", OneLine(given, 40),
                     nearest.empty() ? "moontrace course show lists them"
                                     : fmt::format("did you mean {}?", OneLine(nearest)));
}
std::string NothingToPrint(std::string_view lesson) {
  return fmt::format("lesson {} shows nothing that could be printed; name another",
                     OneLine(lesson));
}
std::string PrintRunsNothing() {
  return "--print draws a lesson and runs none: leave out --simulate";
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

std::string WayInWords(std::string_view name) {
  return fmt::format("The way of {}, in words:", OneLine(name));
}

std::string AskedWayInWords(std::size_t number, std::size_t of) {
  if (of == 1) return "Its way, in words:";
  return fmt::format("Sign {} of {}, its way in words:", number, of);
}

namespace {

std::string PathOfStroke(const StrokePath& path, std::size_t number, std::size_t of) {
  static constexpr const char* kHeights[] = {"bottom", "middle", "top"};
  static constexpr const char* kSides[] = {"left", "middle", "right"};
  static constexpr const char* kDirections[] = {"right", "up and right",  "up",   "up and left",
                                                "left",  "down and left", "down", "down and right"};
  const auto place = [](ThirdPlace at) {
    const std::string height = kHeights[at.y + 1], side = kSides[at.x + 1];
    return height == side ? height : height + " " + side;
  };
  const std::string which = of == 1 ? "One stroke" : fmt::format("Stroke {} of {}", number, of);
  if (path.dot) return fmt::format("{}: a dot, {}.", which, place(path.from));
  std::string line = fmt::format("{}: from {}", which, place(path.from));
  for (const PathPiece& piece : path.pieces) {
    const char* turn = piece.clockwise ? "clockwise" : "anticlockwise";
    if (piece.round) {
      line += fmt::format(", a ring {}", turn);
    } else if (piece.arc) {
      line += fmt::format(", a bend {} {}", turn, kDirections[piece.eighth]);
    } else {
      line += fmt::format(", {}", kDirections[piece.eighth]);
    }
  }
  return fmt::format("{}, to {}.", line, place(path.to));
}

}  // namespace

std::vector<std::string> PathInWords(const std::vector<IntendedStroke>& strokes) {
  std::vector<std::string> lines;
  const std::vector<StrokePath> paths = PathsOf(strokes);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    lines.push_back(PathOfStroke(paths[i], i + 1, paths.size()));
  }
  return lines;
}

std::string SimulatedBegins(std::string_view course, std::size_t lessons) {
  return fmt::format("A simulated learner begins {}, {}.", course,
                     Counted(lessons, "lesson", "lessons"));
}

std::string SimulatedKeepsNothing() { return "Nothing is kept: --records FILE keeps it."; }

std::string SimulatedGoesOn(std::string_view learner, std::size_t trials) {
  return fmt::format("{} goes on after {}.", ShownPseudonym(learner),
                     Counted(trials, "trial", "trials"));
}

std::string SimulatedLesson(std::string_view title, int day, std::size_t trials) {
  return fmt::format("Lesson done: {}. Day {}, {} so far.", title, day,
                     Counted(trials, "trial", "trials"));
}

std::string SimulatedSizes(const std::vector<double>& sizes) {
  std::string list;
  for (const double size : sizes) {
    list += fmt::format("{}{:.4g}", list.empty() ? "" : ", ", 1e3 * size);
  }
  return fmt::format("Signs were sure at {} mm.", list);
}

std::string SimulatedDone(int days, std::size_t trials, double hours) {
  return fmt::format("Course done, in {} and {}, {:.1f} hours of the hand's work.",
                     Counted(static_cast<std::size_t>(days), "day", "days"),
                     Counted(trials, "trial", "trials"), hours);
}

std::string SimulatedEnded(int days, std::string_view lesson) {
  return fmt::format("Course not done after {}: it is at {}.",
                     Counted(static_cast<std::size_t>(days), "day", "days"), lesson);
}

std::string SimulatedMastered(std::size_t mastered, std::size_t items, double size) {
  return fmt::format("Mastered at {:.4g} mm: {} of {} worked on.", 1e3 * size, mastered,
                     Counted(items, "sign", "signs"));
}

std::string SimulatedStuck(std::string_view lesson, std::string_view item) {
  return fmt::format("stuck in lesson {} at {}: it never became sure", lesson,
                     item.empty() ? "no sign" : item);
}

std::string SimulatedProves() {
  return "A simulated learner: this shows that the program works, not how people learn.";
}

std::string NotSimulated(std::string_view learner) {
  return fmt::format("{} is a person in these records: choose another --learner name",
                     ShownPseudonym(learner));
}

}  // namespace moontrace::say
