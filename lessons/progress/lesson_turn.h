#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/progress/lesson_state.h"

namespace moontrace {

/// One turn of the lesson machine while it is computed; used by lesson_*.cpp only.
struct Turn {
  const Course& course;
  LessonState state;
  std::int64_t time = 0;  ///< of the event, Unix time [s]
  std::vector<Action> actions;
};

// lesson_turn.cpp

void Say(Turn& turn, lesson_action::Sentence sentence, std::string_view text = {},
         std::string_view other = {}, double value = 0);
void SayCount(Turn& turn, lesson_action::Sentence sentence, std::string_view text, int number,
              int of);
/// The machine waits, as before or for something else; ends the turn's actions.
void AwaitNow(Turn& turn, lesson_action::Await await);
/// Adds the trial to progress and to the actions, to be kept in the records.
void Keep(Turn& turn, Trial trial);
/// Keeps a trial as a mark: the present step has ended, or the learner has come to a step
/// of a lesson.
void KeepStepEnd(Turn& turn);
void KeepArrival(Turn& turn, const Lesson& lesson, std::size_t step = 0);
/// The present lesson and step; null: none.
const Lesson* LessonNow(const Turn& turn);
const Step* StepNow(const Turn& turn);
/// The item has been shown by its name: once before, or in this session.
bool IsIntroduced(const Turn& turn, const std::string& item);
/// What was said, short enough to be said again: whole UTF-8 characters, at most 60 bytes.
std::string Shortened(std::string_view text);

// lesson_page.cpp: what is shown now

/// A page of an item for the task: says what is to be done, shows it, pushes, awaits.
void PresentItem(Turn& turn, const std::string& item, StepKind task, bool review);
/// The page of a step to explore or to read.
void PresentText(Turn& turn, const Step& step);
/// The page of a text of the learner's own, until "next".
void PresentOwnText(Turn& turn, const std::string& text);
/// Says again what is to be done.
void Ask(Turn& turn);
/// Shows the page again, by the rules and what overrules them; the trial begins again.
void ShowPage(Turn& turn);
/// Another push on the page that is shown, while it is felt.
void ChangePush(Turn& turn);
/// The memory aid of what is shown, unless saying it would give the answer away; empty: none.
std::string HintNow(const Turn& turn);
/// Help for this item by the rules and the tutor's overrules, 0-10, as if it were no probe.
int HelpByRules(const Turn& turn);
/// Size by the rules alone [m].
double SizeByRules(const Turn& turn);

// lesson_trial.cpp: what was done with it

void HandleTraced(Turn& turn, const lesson_event::Traced& traced);
void HandleAnswered(Turn& turn, const lesson_event::Answered& answered);
/// "next": leaves what is there; it is not sure by that.
void Skip(Turn& turn);

// lesson_words.cpp

void HandleSaid(Turn& turn, const lesson_event::Said& said);
void HandleOverrule(Turn& turn, const lesson_event::Overrule& overrule);
void HandleOwnText(Turn& turn, const std::string& text);

// lesson_steps.cpp

/// The present step has ended: keeps that, and says what it means. What comes next is GoOn's.
void EndStepNow(Turn& turn, const Lesson& lesson, const Step& step);
/// To what comes next: a review, an item, the next step or lesson, or the end.
void GoOn(Turn& turn);
/// Leaves all for the beginning of a lesson.
void GoToLesson(Turn& turn, const Lesson& lesson);
/// To the lesson where the learner is; true: there is one with steps.
bool FindPlace(Turn& turn);
/// A lesson's title with its number.
void SayLesson(Turn& turn, lesson_action::Sentence sentence, const Lesson& lesson);
/// Clears what belongs to the present step alone.
void ForgetStep(Turn& turn);

}  // namespace moontrace
