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
std::string LessonNotFound(std::string_view given, std::size_t lessons);
/// What the learner's page and push are now; `set`: by learner or tutor, not by the course's rules.
std::string PageAndHelp(double size, GuidanceMode mode, int help, bool set);
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
