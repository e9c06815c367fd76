#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "devices/core/profile.h"
#include "lessons/course/course.h"
#include "lessons/measure/intended_strokes.h"
#include "lessons/progress/lesson_machine.h"
#include "sim/learn/learn_words.h"

/// Sentences of `moontrace learn`; see messages.h.
namespace moontrace::say {

namespace help {
inline constexpr const char* kLearn = "lessons: from large letters to reading";
inline constexpr const char* kLearner =
    "who learns, a name of your choice. Default the one in the records, else you are asked.";
inline constexpr const char* kCourse = "course to learn, a name or a file. Default learn-moon.";
inline constexpr const char* kRecords = "file of the records. Default the one in your data folder.";
inline constexpr const char* kLearnDevice =
    "what moves the tip: a name from moontrace devices, plugin:PATH, simulated (a demonstration, "
    "nothing is felt), or mouse with --view. Default the first device with motors.";
inline constexpr const char* kLearnSeconds = "ends after so many seconds. Default: when you quit.";
inline constexpr const char* kLearnSeed = "of the choice of signs, a whole number. Default 1.";
inline constexpr const char* kPrint =
    "instead: write the pages of a lesson for swell paper, .svg, .pdf or .png, in true size.";
inline constexpr const char* kPrintLesson = "with --print, the lesson. Default the first.";
inline constexpr const char* kPrintSize =
    "with --print, height of the letters in mm. Default the "
    "largest of the course.";
inline constexpr const char* kSimulate =
    "instead: a simulated learner goes through the course, unattended.";
inline constexpr const char* kDays =
    "with --simulate, sessions, one a day. Default: until the course is done.";
inline constexpr const char* kKeys =
    "single keys without Enter, at a terminal; --keys=FILE changes them. Default off.";
inline constexpr const char* kBrief =
    "outcomes only, from now on for this learner; the word full says all again.";
inline constexpr const char* kSpeak = "speak everything too, by speech-dispatcher. Default off.";
inline constexpr const char* kSound = "sounds of the way and of what happens. Default off.";
inline constexpr const char* kLetTutor =
    "a tutor may join, by moontrace tutor in a second terminal of this machine or over ssh. "
    "Default "
    "off.";
}  // namespace help

/// A sentence of the lesson machine in words.
std::string LessonSentence(const Course& course, const lesson_action::Say& sentence);
/// The same to who wants outcomes only; empty: nothing is said.
std::string BriefSentence(const Course& course, const lesson_action::Say& sentence);
/// The same where the program's own hand traces and nobody's is led; empty: as it is.
std::string DemonstrationSentence(const Course& course, const lesson_action::Say& sentence);
/// An item, or two with a line feed between, as people call it.
std::string Called(const Course& course, std::string_view item);

/// What the lesson waits for, as a person asks for it; said on an empty line.
/// `between`: the two of a question of which it is.
std::string Awaited(lesson_action::Await await, Question question, std::string_view between,
                    bool lifts);
/// The same while a hand is led, or the program's own traces.
std::string LedNow();
std::string ProgramTraces();
/// Once, where it has traced the sign several times.
std::string TracesOn();

// What words are answered by.
/// What ? gives: at first the words that a first lesson needs, asked once more the others.
struct HelpLines {
  std::vector<std::string> first, more;
};
/// Of words, of single keys (key -> word); `button`: the device has one.
HelpLines LearnHelp(bool lifts, bool button);
HelpLines KeysHelp(const std::map<std::string, std::string>& keys, bool lifts, bool button);
/// `felt`: a hand can be pushed here.
std::string Pausing(bool felt);
std::string NotWhileAsked();
/// `name` empty: it is not said.
std::string TipAt(std::string_view name, std::size_t line, bool touching);
std::string TipBetween(bool touching);
std::string NoLessonNow();
/// A line of the list of lessons.
std::string LessonInList(std::string_view title, std::size_t number, bool here, bool done,
                         bool optional);
/// Signs that have been begun, of all; the smallest size at which one is sure [m], 0: none.
std::string HowFar(std::size_t known, std::size_t all, double smallest);
/// Right names of the last ones, at the size at which a sign is worked on [m].
std::string HowSure(std::string_view name, std::size_t right, std::size_t of, double size);
/// Signs that are not asked for now: the smallest size at which they are sure [m]; 0: none.
std::string SureAt(const std::vector<std::string>& names, double size);
std::string LessonWhich();
std::string PractiseWhich();
std::string BriefNow();
std::string FullNow();
/// `last`: what Enter alone takes; empty: there is none.
std::string AskOwnText(std::string_view last);
std::string NoOwnText();
std::string LetterHere(std::string_view name);
std::string NoLetterHere();
std::string WordHere(std::string_view word);
std::string Spelled(const std::vector<std::string>& names);
std::string NothingTouched(bool mouse);
std::string NothingFollowed();
std::string NextLeavesIt();
std::string StillAsked();
std::string NothingIsAsked();
/// To who says "I know" where a name is asked.
std::string SayTheName();

// Where we are in the course; `of` 0: beside it.
std::string WhereInCourse(std::string_view title, std::size_t number, std::size_t of,
                          std::size_t step, std::size_t steps);
std::string Learner(std::string_view name, std::size_t trials, bool fresh);
/// Somebody is kept under a name that differs from what was given by capitals only.
std::string TakenForKept(std::string_view given, std::string_view kept);
std::string AskLearner();
std::string AskWhich(const std::vector<std::string>& names);
std::string NoLearner();
std::string AskConsent();
std::string ConsentHelp();
/// Of that question: what a learner agreed to.
inline constexpr const char* kConsentVersion = "tracks-2";
std::string ConsentGiven(bool yes);
std::string YesOrNo();
std::string NotAName();
/// A word of lessons, where a name is asked.
std::string WordIsNoName(std::string_view word);
std::string NumberIsNoName(std::string_view number, std::string_view word);
/// To who does not know who learns.
std::string AnyNameWillDo();
std::string QuitLeaves();
std::string LeftBeforeBeginning();
std::string NoRecords();
std::string NotKept(std::string_view why);
std::string KeptNow(std::size_t trials);
std::string NeverKept(std::size_t trials);
std::string SimulatedOnly(std::string_view name);

// How a session begins and ends.
/// Lessons of a learner, without a device.
std::string ByProgramsHand();
std::string WhatProgramsHandDoes(bool kept);
/// Where one was given.
std::string DemonstrationTakesNoTutor();
std::string NoNameNeeded();
std::string DemonstrationIsAlone();
std::string WithDevice(std::string_view device);
std::string NotFelt();
/// Of a mouse in place of NotFelt: how it presses, that it cannot push.
std::string MousePresses();
std::string MouseCannotPush();
/// The tip cannot be lifted: told to who is new.
std::string TipStaysDown();
std::string LearnScaled();
std::string LearnBegins();
std::string LearnBeginsWithKeys();
std::string SessionEnded(std::size_t trials, std::size_t sure);
std::string EndOfInput();
std::string LostTrial();
/// What to do where a device of that kind is lost, and that the lesson waits.
std::string MendDevice(DeviceKind kind);
/// The answer to what cannot be done meanwhile.
std::string WaitsForDevice();
// Of a device that renders no letters below `smallest` [m]; infinite: none.
std::string SizesEndAt(double size, double smallest);
std::string NoRoomFor(double wanted, double got);
/// The answer to who asked for that size [m].
std::string SizeHasNoRoom(double wanted, double got);
std::string CannotShow(std::string_view text, std::string_view why);

// Without a device.
std::string NoForceDevice();
std::string DeviceProblem(std::string_view name, std::string_view problem);
/// `window`: one can be opened, as far as is known.
std::vector<std::string> LearningWithoutDevice(bool window);
std::string NoWindowForMouse();
/// Of a window that is not needed.
std::string NoWindowHere();
/// At a terminal, where there is no device.
/// `window`: one may open here.
std::string AskWithoutDevice(bool window);
std::string DemonstrationIs();
/// Behind it they are told again.
std::string NoneOfThree(std::string_view given);
std::string NoDeviceGiven();

// Printing.
std::string Printed(std::string_view title, std::size_t pages, double size);
std::string PrintedSideways();
std::string PrintedSmaller(double wanted);
std::string PrintedBroken();
std::string PrintedHow();
/// What to type for lesson `number`; `course`: one that has to be named, or empty.
std::string PrintNext(std::string_view file, std::size_t number, std::string_view course);
std::string PrintedLast();
// On the sheet itself: at its head and foot in raised letters, then in print for who helps.
std::string PrintedPageInMoon(std::size_t page);
std::string PrintedInstructionInMoon();
std::string PrintedInstruction(std::string_view title, std::size_t page, std::size_t pages,
                               double size, std::string_view lines);
std::string NoSuchLesson(std::string_view given, std::string_view nearest);
std::string NothingToPrint(std::string_view lesson);
std::string PrintRunsNothing();
std::string OnlyWithPrint(std::string_view option);

// Single keys.
std::string KeysNeedTerminal();
std::string NoSuchKey(std::string_view key);
std::string EscapeStops();
std::string TwoWordsOneKey(std::string_view key, std::string_view first, std::string_view second);
std::string KeyConflicts(const std::vector<std::string>& conflicts);

// Where nothing can lead the hand.
std::string WayInWords(std::string_view name);
/// Of what is asked, which is sign `number`, from 1.
std::string AskedWayInWords(std::size_t number, std::size_t of);
/// How each stroke runs, a line a stroke.
std::vector<std::string> PathInWords(const std::vector<IntendedStroke>& strokes);

// A simulated learner.
std::string SimulatedBegins(std::string_view course, std::size_t lessons);
std::string SimulatedKeepsNothing();
std::string SimulatedGoesOn(std::string_view learner, std::size_t trials);
std::string SimulatedLesson(std::string_view title, int day, std::size_t trials);
/// Sizes [m] at which items became sure in the lesson just done, descending.
std::string SimulatedSizes(const std::vector<double>& sizes);
std::string SimulatedDone(int days, std::size_t trials, double hours);
std::string SimulatedEnded(int days, std::string_view lesson);
/// What came of it: items sure at standard size [m], of how many that were worked on.
std::string SimulatedMastered(std::size_t mastered, std::size_t items, double size);
std::string SimulatedStuck(std::string_view lesson, std::string_view item);
std::string SimulatedProves();
std::string NotSimulated(std::string_view learner);

}  // namespace moontrace::say
