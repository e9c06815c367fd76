#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/tutor/tutor_command.h"

/// Sentences of the tutor's door to a lesson.
namespace moontrace::say {

namespace help {
inline constexpr const char* kTutor =
    "speaks to a lesson that runs on this machine (learn --tutor): size, help, mode and more";
inline constexpr const char* kTutorLearner =
    "the learner whose lesson it is. Default: the one whose lesson runs.";
}  // namespace help

/// A line that is no command.
/// Once, at the beginning of what a tutor may join.
std::string TutorMayJoin();
std::string TutorSaidNothing();

// What comes and goes, for the learner and for the tutor.
std::string TutorCame(std::size_t tutor);
std::string TutorLeft(std::size_t tutor);
std::string TutorDropped(std::size_t tutor);
std::string TutorLineTooLong(std::size_t longest);
std::string TooManyTutors(std::size_t most);
/// One of another user.
std::string StrangerRefused();

/// What the learner is told before a command is done; empty: it is told otherwise.
std::string TutorDoes(const TutorCommand& command);
/// The same where nobody but the learner is there: "Pause, no force."
std::string WithoutTutor(std::string sentence);
std::string LearnerStopped();
std::string LearnerAt(std::string_view learner, std::string_view status);
std::string WhoIsHere(std::string_view learner, std::size_t tutors);

// Why there is no door.
std::string SocketTaken(std::string_view path);
std::string SocketIsNoSocket(std::string_view path);
std::string FolderNotOurs(std::string_view folder);
std::string FolderOpenToOthers(std::string_view folder);
std::string CannotOpenSocket(std::string_view path, std::string_view cause);

// The tutor's own program.
/// `nearest`: whose lesson runs with a tutor and was perhaps meant; empty: nobody's.
std::string NoLessonRuns(std::string_view learner, std::string_view nearest);
std::string SeveralLessons(const std::vector<std::string>& learners);
std::string LessonRefused(std::string_view path, std::string_view cause);
std::string LessonEnded();
std::string LessonSilent();
std::string TutorGone();

}  // namespace moontrace::say
