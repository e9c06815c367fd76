#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lessons/course/course.h"
#include "lessons/course/trial.h"
#include "sim/tutor/tutor_command.h"

/// Sentences of a tutor's commands, for learner and tutor; see messages.h.
namespace moontrace::say {

/// Each tutor is met with it, whenever they come.
std::string TutorGreeting(std::string_view learner);
/// What stands behind words that only a tutor says, or says otherwise than a learner.
std::string TutorWordsHelp();
/// What in a window is not the learner's.
std::string TutorsInWindow();
std::string NothingRests();
std::string LessonNotFound(const Course& course, std::string_view given, bool tutor);
/// The push at this moment, and whether learner or tutor set it or the size, not the course's
/// rules.
struct PushNow {
  bool led = false;  ///< the whole way, as in a demonstration
  GuidanceMode mode = GuidanceMode::kOff;
  int help = 0;  ///< 0 to 10; while the hand is led, once it is no longer; below zero: by the rules
  bool set = false;
};
/// What the learner's page and push are now.
std::string PageAndHelp(double size, const PushNow& push);
/// Of this session; a trial without an item: none yet.
std::string LastTrials(const Course& course, const Trial& right, const Trial& wrong);
std::string NoNextLesson();
std::string TutorGaveBack();
std::string Recording();
std::string RecordedStrokeIs(double seconds);
std::string NothingRecorded();
std::string NoStrokeYet();
std::string CannotRecord();
std::string CannotLead();

}  // namespace moontrace::say
